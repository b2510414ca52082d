// Loads and stores: named locals, cells at constant places, indexed places with the fault of 6.9 beside them where the
// bounds of the index do not show that it stays inside; bit-fields.
#pragma once

#include <functional>
#include <optional>
#include <unordered_set>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Conversions;
class Faults;
class Intervals;
class Locals;
class Operators;
class CellPlaces;
class Pointers;
class StatedFacts;

/// Whether an access outside of its object is a fault, or one was recorded: the store of `+=` and `++` goes where the
/// load in front of it went, and one access has one fault.
enum class IndexFault : uint8_t { kRecords, kRecorded };

class Accesses : Context {
 public:
  Accesses(const Context& context, StatedFacts& stated, Faults& faults, CellPlaces& places, Locals& locals,
           Intervals& intervals, Conversions& conversions, Operators& operators, Pointers& pointers)
      : Context(context),
        stated_(stated),
        faults_(faults),
        places_(places),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        operators_(operators),
        pointers_(pointers) {}

  /// A choice among the objects that an address may be in.
  void ForEachTargetOf(const Address& address, IndexFault fault, const std::function<void(ObjectId)>& body);
  ir::ValueId LoadAt(const Address& address, ir::Type type, ExprId at, IndexFault fault = IndexFault::kRecords);
  void StoreAt(const Address& address, ir::Type type, ir::ValueId value, ExprId at,
               IndexFault fault = IndexFault::kRecords);
  /// What a bit-field gives back of a value that was stored into it: its width's digits, with its sign.
  Value InBitField(const Value& digits, const Lvalue& lvalue);
  /// W4, once for each variable.
  void CheckAssigned(VariableId id, ExprId at);
  Value Load(const Lvalue& lvalue);
  void Store(const Lvalue& lvalue, const Value& value, IndexFault fault = IndexFault::kRecords);

 private:
  /// A place of an object, and the index for it.
  struct Access {
    ir::PlaceId place;
    ir::ValueId index;
  };
  void ReportIndex(ObjectId object, ExprId at);
  std::optional<Access> AccessTo(ObjectId object, const Address& address, ir::Type type, ExprId at, IndexFault fault);
  Value LoadBitField(const Lvalue& lvalue);
  void StoreBitField(const Lvalue& lvalue, const Value& value, IndexFault fault);

  StatedFacts& stated_;
  Faults& faults_;
  CellPlaces& places_;
  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Operators& operators_;
  Pointers& pointers_;
  std::unordered_set<uint32_t> read_unassigned_;  // by VariableId: reported
};

}  // namespace plcxx::hnc
