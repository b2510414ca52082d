// Variables, what their records keep beside them, steps and scalars of the lowering as places.
#pragma once

#include <map>
#include <set>
#include <string>

#include "transpiler/dialects/classicladder/lowering/context.h"
#include "transpiler/dialects/classicladder/lowering/names.h"
#include "transpiler/dialects/classicladder/machine/places.h"

namespace plcxx::classicladder {

class Places : Context {
 public:
  Places(const Context& context, const Names& names) : Context(context), names_(names) {}

  /// Of a variable without an index.
  ir::PlaceId Of(const Address& address);
  ir::PlaceId FieldOf(Group group, Part part, uint32_t number);
  ir::PlaceId HiddenOf(Group group, Hidden part, uint32_t number);
  ir::PlaceId ActiveOf(uint32_t step);
  /// `place` under `name`, by which it is one and the same.
  ir::PlaceId Named(std::string name, ir::Place place);
  ir::PlaceId NewSystemPlace(std::string name, ir::Type type) { return New(std::move(name), type, SystemSpace()); }
  ir::PlaceId NewLocal(std::string name, ir::Type type) { return New(std::move(name), type, RoutineSpace()); }
  /// The variables that were asked for.
  const std::set<VariableKey>& used() const { return used_; }

 private:
  ir::PlaceId New(std::string name, ir::Type type, ir::SpaceId space_id);

  const Names& names_;
  std::map<std::string, ir::PlaceId> places_;  // by name and address
  std::set<VariableKey> used_;
};

}  // namespace plcxx::classicladder
