// Parameters and other places that live as long as the routine that uses them.
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Locals : Context {
 public:
  explicit Locals(const Context& context) : Context(context) {}

  ir::PlaceId Add(std::string name, ir::Type type);
  /// The place of a new parameter of the routine.
  ir::PlaceId AddParameter(ir::RoutineId routine, std::string name, ir::Type type);

 private:
  uint32_t count_ = 0;
};

}  // namespace plcxx::prostep
