// Library functions (specification 6.11): arithmetic, and memory with lengths clipped to the objects.
#pragma once

#include <functional>
#include <string>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Addresses;
class Conversions;
class Expressions;
class Faults;
class Intervals;
class Locals;
class Pointers;

class LibraryCalls : Context {
 public:
  LibraryCalls(const Context& context, Faults& faults, Locals& locals, Intervals& intervals, Conversions& conversions,
               Pointers& pointers, Accesses& accesses, Addresses& addresses, Expressions& expressions)
      : Context(context),
        faults_(faults),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        pointers_(pointers),
        accesses_(accesses),
        addresses_(addresses),
        expressions_(expressions) {}

  CallResult Call(const Expr& expr);

 private:
  ir::ValueId RoomBehind(const Address& address);
  Address At(const Address& address, ir::ValueId counter);
  CallResult MemoryFunction(const Expr& expr);

  /// What memcpy, memmove, memset and memcmp get.
  struct MemoryOperands {
    SystemFunction function{};
    ir::ValueId wanted;  // the length; an i32
    ir::ValueId byte;    // of memset
    Address from, to;    // `from`: not of memset

    bool compares() const { return function == SystemFunction::kMemcmp; }
    bool sets() const { return function == SystemFunction::kMemset; }
    bool moves() const { return function == SystemFunction::kMemmove; }
  };
  /// The same in locals, from which each byte is done.
  struct KeptOperands {
    ir::PlaceId count, at;
    std::function<Address()> target, source;
    ir::PlaceId byte, difference, backward;  // of memset, memcmp, memmove alone
  };
  MemoryOperands EvaluateOperands(const Expr& expr);
  /// Reports a pointer of which it is not known where it points to; false then.
  bool CheckTargets(const Expr& expr, const MemoryOperands& operands);
  ir::ValueId ClippedLength(const MemoryOperands& operands);
  ir::PlaceId Keep(std::string name, ir::ValueId value);
  /// Gives the address again, wherever it is called.
  std::function<Address()> KeepAddress(std::string name, const Address& address);
  KeptOperands KeepOperands(const MemoryOperands& operands);
  ir::ValueId Position(const KeptOperands& kept);
  void DoOneByte(const KeptOperands& kept);
  void DoEachByte(const KeptOperands& kept);

  Faults& faults_;
  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Pointers& pointers_;
  Accesses& accesses_;
  Addresses& addresses_;
  Expressions& expressions_;
};

}  // namespace plcxx::hnc
