// Contacts and coils.
#pragma once

#include "transpiler/dialects/classicladder/lowering/accesses.h"
#include "transpiler/dialects/classicladder/lowering/edges.h"
#include "transpiler/dialects/classicladder/lowering/grid.h"
#include "transpiler/dialects/classicladder/lowering/logic.h"

namespace plcxx::classicladder {

class Contacts : Context {
 public:
  Contacts(const Context& context, Logic& logic, Grid& grid, Accesses& accesses, Edges& edges)
      : Context(context), logic_(logic), grid_(grid), accesses_(accesses), edges_(edges) {}

  /// The variable is read whatever comes from the left: an edge takes notice of it, and an index may be outside.
  void Contact(uint32_t x, uint32_t y, const Element& element);
  void Coil(uint32_t x, uint32_t y, const Element& element);

 private:
  Logic& logic_;
  Grid& grid_;
  Accesses& accesses_;
  Edges& edges_;
};

}  // namespace plcxx::classicladder
