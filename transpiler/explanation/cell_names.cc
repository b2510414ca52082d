#include "transpiler/explanation/cell_names.h"

#include "transpiler/ir/place_names.h"

namespace plcxx::explanation {
namespace {

/// The letters and digits alone: generated code spells "F 9.6" as F9_6.
std::string Plain(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    const bool is_mark = c == ' ' || c == '.' || c == '_' || c == '%' || c == '!';
    if (!is_mark) plain += c;
  }
  return plain;
}

}  // namespace

CellNames::CellNames(const ir::Program& program, const execute::Cells& cells)
    : program_(program), exact_(cells.count, kNone), words_(cells.count, kNone) {
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    if (place.indexed || !execute::IsInside(program, place)) continue;
    const bool is_exact = place.is_field() || place.type == ir::Type::kBit;
    for (const execute::CellId cell : execute::CellsOf(program, cells, place)) {
      uint32_t& known = is_exact ? exact_[cell.index] : words_[cell.index];
      if (known == kNone || (!is_exact && ir::Bytes(place.type) < ir::Bytes(program.places[ir::PlaceId(known)].type))) {
        known = i;
      }
    }
  }
}

std::string CellNames::NameOf(const ir::Place& place) const {
  const std::string& address = ir::SourceName(place);
  std::string symbols = place.name;
  std::string meaning;
  for (const ir::Documentation& documented : program_.documentation) {
    if (documented.address != address) continue;
    if (!documented.symbols.empty()) symbols = documented.symbols;
    if (symbols.empty()) symbols = documented.predefined;
    meaning = documented.meaning;
  }
  std::string more = Plain(symbols) == Plain(address) ? "" : symbols;
  if (!meaning.empty()) more += (more.empty() ? "" : ": ") + meaning;
  return more.empty() ? address : address + " (" + more + ")";
}

}  // namespace plcxx::explanation
