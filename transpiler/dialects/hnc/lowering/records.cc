#include "transpiler/dialects/hnc/lowering/records.h"

#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/locals.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

/// Bytes of a record, as far as possible in double words.
template <class Visit>
void ForEachPiece(uint32_t size, const Visit& visit) {
  for (uint32_t at = 0; at < size;) {
    const ir::Type width = size - at >= 4 ? ir::Type::kI32 : size - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
    visit(at, width);
    at += ir::Bytes(width);
  }
}

Address Behind(const Address& address, uint32_t bytes) {
  Address part = address;
  part.base += bytes;
  return part;
}

constexpr uint32_t kMostPlainStores = 16;  // that clear an array one by one

}  // namespace

void Records::Assign(const Address& to, const Address& from, TypeId type) {
  ForEachPiece(TypeAt(type).size, [&](uint32_t at, ir::Type width) {
    accesses_.StoreAt(Behind(to, at), width, accesses_.LoadAt(Behind(from, at), width, {}), {});
  });
}

std::vector<ValueId> Records::Load(const Address& from, TypeId type) {
  std::vector<ValueId> pieces;
  ForEachPiece(TypeAt(type).size,
               [&](uint32_t at, ir::Type width) { pieces.push_back(accesses_.LoadAt(Behind(from, at), width, {})); });
  return pieces;
}

void Records::Store(const Address& to, const std::vector<ValueId>& pieces, TypeId type) {
  size_t next = 0;
  ForEachPiece(TypeAt(type).size,
               [&](uint32_t at, ir::Type width) { accesses_.StoreAt(Behind(to, at), width, pieces[next++], {}); });
}

void Records::Clear(ObjectId object) {
  const uint32_t size = objects_[object].size;
  if (size == 0) return;
  if (size <= 4 * kMostPlainStores) {
    for (uint32_t at = 0; at < size;) {
      const ir::Type width = size - at >= 4 ? ir::Type::kI32 : size - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
      const ValueId zero = builder_.Constant(width, 0);
      const ir::PlaceId piece = places_.At(object, at, width);
      builder_.Store(piece, zero);
      at += ir::Bytes(width);
    }
    return;
  }
  const ir::PlaceId at = locals_.Add("clear", ir::Type::kI32);
  builder_.Store(at, Long(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = size,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .step = builder_.NewRegion(),
                .exhausted = {}};
  builder_.Into(loop.condition, [&] { Pure(OpKind::kLess32, {builder_.Load(at), Long(size)}); });
  builder_.Into(loop.body, [&] {
    const ValueId index = builder_.Load(at);
    const ValueId zero = builder_.Constant(ir::Type::kI8, 0);
    const ir::PlaceId byte = places_.IndexedAt(object, 0, 1, ir::Type::kI8);
    builder_.Store(byte, zero, index);
  });
  builder_.Into(loop.step, [&] { builder_.Increment(at); });
  builder_.LoopWith(loop);
}

}  // namespace plcxx::hnc
