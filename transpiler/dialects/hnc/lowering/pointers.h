// Addresses as values (specification 5.3, 6.5): a byte and the number of an object; pointer variables.
#pragma once

#include <unordered_set>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Conversions;

class Pointers : Context {
 public:
  Pointers(const Context& context, Conversions& conversions) : Context(context), conversions_(conversions) {}

  void AddIndex(Address& address, const Value& index, uint32_t size, int64_t sign);
  Address PointerIn(VariableId id);
  void StorePointer(VariableId id, const Address& value);
  ir::ValueId OffsetOf(const Address& address);
  ir::ValueId ObjectOf(const Address& address);
  ir::ValueId IsNotNull(const Address& address, ExprId id);
  /// Null is the least offset.
  static bool MayBeNull(const Address& address);
  /// Whether an access through the pointer can be lowered; else it is refused, once for each variable.
  bool CheckTargets(const Address& address, ExprId at);
  /// Why not, of a pointer whose targets are none or too many: "is 0".
  static std::string_view WhyRefused(const Address& address);
  Address SelectAddress(ir::ValueId condition, const Address& a, const Address& b);

 private:
  bool HasPoison(ExprId id) const;
  bool IsHandedPoison(const Expr& call, VariableId parameter, std::vector<VariableId>& seen) const;
  bool HasPoisonedSource(VariableId variable, std::vector<VariableId>& seen) const;

  Conversions& conversions_;
  std::unordered_set<uint32_t> refused_;  // by VariableId
};

}  // namespace plcxx::hnc
