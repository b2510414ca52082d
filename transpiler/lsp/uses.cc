#include "transpiler/lsp/uses.h"

#include <algorithm>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/symbol_names.h"

namespace plcxx::lsp {
namespace {

void AddOnce(std::vector<source::Range>& ranges, source::Range range) {
  if (range.begin != 0 && (ranges.empty() || ranges.back() != range)) ranges.push_back(range);
}

void Sort(std::vector<source::Range>& ranges) {
  std::ranges::sort(ranges, {}, [](source::Range range) { return range.begin; });
  const auto rest = std::ranges::unique(ranges);
  ranges.erase(rest.begin(), rest.end());
}

/// An indexed access may touch all of its stretch.
Bits Touched(const ir::Place& place) {
  Bits bits = BitsOf(place);
  if (place.indexed) {
    bits.first = uint64_t{place.low} * 8;
    bits.last = uint64_t{place.high} * 8;
  }
  return bits;
}

bool HasSymbol(const ir::Documentation& known, std::string_view name) {
  return ir::AnySymbolName(known, [name](std::string_view one) { return one == name; });
}

}  // namespace

Uses UsesOf(const ir::Program& program, const Bits& bits) {
  Uses uses;
  for (const ir::Inst& inst : program.insts) {
    if (inst.range.begin == 0) continue;
    ir::ForEachAccess(
        program, inst,
        [&](ir::PlaceId id, ir::Access access) {
          if (!Overlap(Touched(program.places[id]), bits)) return;
          if (access != ir::Access::kWrite) AddOnce(uses.reads, inst.range);
          if (access != ir::Access::kRead) AddOnce(uses.writes, inst.range);
        },
        [&](ir::StateId state) {
          if (bits.of == Bits::Of::kInstance && bits.number == state.index) AddOnce(uses.writes, inst.range);
        });
  }
  Sort(uses.reads);
  Sort(uses.writes);
  return uses;
}

const ir::Documentation* DocumentationOf(const Names& names, const Target& target, std::string_view spelling) {
  const std::string key = names.editing().key(spelling);
  std::string_view address;
  if (target.definition != kNoDefinition) address = names.definitions()[target.definition].address;
  const ir::Documentation* by_name = nullptr;
  for (const ir::Documentation& known : names.program().documentation) {
    if (!address.empty() && known.address == address) return &known;
    if (names.editing().key(known.address) == key) return &known;
    if (by_name == nullptr && HasSymbol(known, key)) by_name = &known;
  }
  if (by_name != nullptr || !target.bits) return by_name;
  const auto location = names.Locate(spelling);
  if (!location) return nullptr;
  const auto found =
      std::ranges::find(names.program().documentation, location->place.name, &ir::Documentation::address);
  return found == names.program().documentation.end() ? nullptr : &*found;
}

}  // namespace plcxx::lsp
