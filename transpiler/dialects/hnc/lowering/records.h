// Structures as values (specification 5.5, 6.8), by copies of their bytes.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Locals;
class CellPlaces;

class Records : Context {
 public:
  Records(const Context& context, CellPlaces& places, Locals& locals, Accesses& accesses)
      : Context(context), places_(places), locals_(locals), accesses_(accesses) {}

  void Assign(const Address& to, const Address& from, TypeId type);
  /// The value as it is now; what is executed before it is stored does not change it.
  std::vector<ir::ValueId> Load(const Address& from, TypeId type);
  void Store(const Address& to, const std::vector<ir::ValueId>& pieces, TypeId type);
  /// Zeros for all bytes of an object in memory.
  void Clear(ObjectId object);

 private:
  bool IsPlain(const Address& address, uint32_t size) const;

  CellPlaces& places_;
  Locals& locals_;
  Accesses& accesses_;
};

}  // namespace plcxx::hnc
