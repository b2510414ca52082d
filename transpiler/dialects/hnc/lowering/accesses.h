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
  /// Whether `bytes` at an address are within its one object, whatever the index is.
  bool IsInside(const Address& address, uint32_t bytes) const;
  /// Several accesses that are one (6.9): all of `bytes` at an address, each target with an address of its own, or none
  /// of them and one fault.
  void InOne(const Address& address, uint32_t bytes, const std::function<void(const Address&)>& body);
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
  /// An address with an index, as an object of a size has it: inside where the index is from `first` to `last`.
  struct Scaled {
    int64_t base = 0, strides = 0, first = 0, last = 0;
    bool inside = false;
  };
  struct Reach {
    int64_t base = 0;
    ir::ValueId index;
    ir::ValueId outside;  // none: always inside
  };
  void ReportIndex(ObjectId object, ExprId at);
  static Scaled ScaledIn(int64_t size, const Address& address, int64_t bytes);
  /// None: never inside; a constant address in the only object has been refused then.
  std::optional<Reach> ReachOf(ObjectId object, const Address& address, int64_t bytes, ExprId at);
  void RecordMiss(const Address& address);
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
