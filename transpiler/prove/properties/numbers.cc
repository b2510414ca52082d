#include "transpiler/prove/properties/numbers.h"

#include <map>
#include <utility>

namespace plcxx::prove::properties {
std::vector<std::vector<execute::CellId>> NumbersAmong(const CheckedProgram& checked,
                                                       const std::vector<execute::CellId>& cells) {
  const ir::Program& program = *checked.version.program;
  std::map<execute::CellId, std::vector<execute::CellId>> word_of;  // by its first cell
  for (const ir::Place& place : program.places) {
    const bool is_number = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                           execute::IsInside(program, place) &&
                           program.spaces[place.space].lifetime != ir::Lifetime::kRoutine;
    if (!is_number) continue;
    std::vector<execute::CellId> word = execute::CellsOf(program, checked.version.cells, place);
    for (const execute::CellId cell : word) {
      std::vector<execute::CellId>& known = word_of[cell];
      if (known.size() < word.size()) known = word;
    }
  }
  std::vector<std::vector<execute::CellId>> numbers;
  std::vector<bool> taken(checked.version.cells.count);
  for (const execute::CellId cell : cells) {
    if (taken[cell.index] || checked.new_each_time[cell.index]) continue;
    std::vector<execute::CellId> word{cell};
    const execute::Cell what = execute::CellAt(program, checked.version.cells, cell);
    if (what.kind == execute::CellKind::kCalls) continue;
    if (what.kind == execute::CellKind::kBit) {
      const auto known = word_of.find(cell);
      if (known == word_of.end()) continue;
      word = known->second;
    } else if (execute::CellWidth(program, what) == 1) {
      continue;
    }
    for (const execute::CellId one : word) taken[one.index] = true;
    numbers.push_back(std::move(word));
  }
  return numbers;
}

}  // namespace plcxx::prove::properties
