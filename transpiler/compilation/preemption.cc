#include "transpiler/compilation/preemption.h"

#include <vector>

namespace plcxx::compilation {
namespace {

/// The widest load and store of every target that plcxx has.
constexpr uint32_t kWordBytes = 4;

}  // namespace

checks::StoredPlace StoredAs(const ir::Place& place, const emit::layout::PlaceStorage& storage) {
  const uint32_t bytes = place.type == ir::Type::kBit ? 1 : ir::Bytes(place.type);
  const uint32_t words = (bytes + kWordBytes - 1) / kWordBytes;
  switch (storage.storage) {
    case emit::layout::Storage::kNone:
    case emit::layout::Storage::kLocal:
      return {};
    case emit::layout::Storage::kBit:
    case emit::layout::Storage::kByte:
    case emit::layout::Storage::kRetentiveByte:
      return {storage.offset, 1, 1};
    case emit::layout::Storage::kPackedBit:
    case emit::layout::Storage::kRetentiveBit:
      return {storage.offset, 1, 2};  // a write loads the byte and stores it
    case emit::layout::Storage::kWord16:
    case emit::layout::Storage::kWord32:
    case emit::layout::Storage::kWord64:
    case emit::layout::Storage::kFloat32:
    case emit::layout::Storage::kFloat64:
    case emit::layout::Storage::kField:
      return {storage.offset, bytes, words};
    case emit::layout::Storage::kWide:
    case emit::layout::Storage::kRetentiveWide:
      return {storage.offset, bytes, bytes};  // byte by byte: its alignment and its order are any
    case emit::layout::Storage::kIndexed:
    case emit::layout::Storage::kRetentiveIndexed:
      return {storage.offset, place.high - place.low, 1 + bytes};  // and its index is looked at
  }
  return {};
}

std::vector<bool> CheckPreemptive(Compilation& compilation) {
  if (!compilation.ok() || !compilation.has_program) return {};
  const ir::Program& program = compilation.program;
  const emit::layout::Layout layout = emit::layout::MakeLayout(program);
  std::vector<checks::StoredPlace> stored;
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    stored.push_back(StoredAs(program.places[ir::PlaceId(i)], layout.places[i]));
  }
  std::vector<bool> shared = checks::CheckPreemption(program, stored, compilation.diagnostics);
  compilation.diagnostics.SortBySource();
  return shared;
}

}  // namespace plcxx::compilation
