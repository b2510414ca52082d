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

/// Piece by piece, as scalars are: each has its object to itself, or they are all within it.
bool Records::IsPlain(const Address& address, uint32_t size) const {
  return size == 1 || size == 2 || size == 4 || accesses_.IsInside(address, size);
}

void Records::Assign(const Address& to, const Address& from, TypeId type) {
  const uint32_t size = TypeAt(type).size;
  if (!IsPlain(to, size) || !IsPlain(from, size)) return Store(to, Load(from, type), type);
  ForEachPiece(size, [&](uint32_t at, ir::Type width) {
    accesses_.StoreAt(Behind(to, at), width, accesses_.LoadAt(Behind(from, at), width, {}), {});
  });
}

std::vector<ValueId> Records::Load(const Address& from, TypeId type) {
  const uint32_t size = TypeAt(type).size;
  std::vector<ValueId> pieces;
  if (IsPlain(from, size)) {
    ForEachPiece(size,
                 [&](uint32_t at, ir::Type width) { pieces.push_back(accesses_.LoadAt(Behind(from, at), width, {})); });
    return pieces;
  }
  std::vector<ir::PlaceId> found;
  ForEachPiece(size, [&](uint32_t, ir::Type width) {
    found.push_back(locals_.Add("found", width));
    builder_.Store(found.back(), builder_.Constant(width, 0));
  });
  accesses_.InOne(from, size, [&](const Address& one) {
    size_t next = 0;
    ForEachPiece(size, [&](uint32_t at, ir::Type width) {
      builder_.Store(found[next++], accesses_.LoadAt(Behind(one, at), width, {}, IndexFault::kRecorded));
    });
  });
  for (const ir::PlaceId place : found) pieces.push_back(builder_.Load(place));
  return pieces;
}

void Records::Store(const Address& to, const std::vector<ValueId>& pieces, TypeId type) {
  const uint32_t size = TypeAt(type).size;
  const auto store = [&](const Address& one, IndexFault fault) {
    size_t next = 0;
    ForEachPiece(size, [&](uint32_t at, ir::Type width) {
      accesses_.StoreAt(Behind(one, at), width, pieces[next++], {}, fault);
    });
  };
  if (IsPlain(to, size)) return store(to, IndexFault::kRecords);
  accesses_.InOne(to, size, [&](const Address& one) { store(one, IndexFault::kRecorded); });
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
