// Calls of the program's own functions (specification 6.4): arguments from right to left, structures by copies.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Addresses;
class Conversions;
class Expressions;
class Intervals;
class Pointers;
class Records;
class SystemCalls;

class Calls : Context {
 public:
  Calls(const Context& context, Intervals& intervals, Conversions& conversions, Pointers& pointers, Records& records,
        Addresses& addresses, Expressions& expressions, SystemCalls& system_calls)
      : Context(context),
        intervals_(intervals),
        conversions_(conversions),
        pointers_(pointers),
        records_(records),
        addresses_(addresses),
        expressions_(expressions),
        system_calls_(system_calls) {}

  CallResult Call(ExprId id);

 private:
  /// By parameter: one of the three, as its type is.
  struct Arguments {
    std::vector<Value> numbers;
    std::vector<Address> addresses;
    std::vector<std::vector<ir::ValueId>> records;  // those that what is evaluated later may change; else empty
  };
  /// From the last to the first; what the function has no parameter for is executed.
  Arguments EvaluateArguments(const Expr& expr);
  /// Copies structures to the parameters, and gives the other arguments as the routine takes them.
  std::vector<ir::ValueId> Pass(const Function& callee, const Arguments& arguments);
  /// `called`: what its routine gives.
  CallResult ResultOf(FunctionId function, ir::ValueId called);
  CallResult CallFunction(const Expr& expr);

  Intervals& intervals_;
  Conversions& conversions_;
  Pointers& pointers_;
  Records& records_;
  Addresses& addresses_;
  Expressions& expressions_;
  SystemCalls& system_calls_;
};

}  // namespace plcxx::hnc
