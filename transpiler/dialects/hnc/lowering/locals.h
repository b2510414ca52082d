// Locals of the routine that is being made: a space of its own, so that generated code has them as locals.
#pragma once

#include <string>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Locals : Context {
 public:
  explicit Locals(const Context& context) : Context(context) {}

  ir::PlaceId Add(std::string name, ir::Type type);
  /// Where further locals are added.
  struct Position {
    ir::SpaceId space;
    uint32_t bytes = 0;
  };
  /// Of a new routine; gives where locals were added before.
  Position Begin(std::string name);
  Position position() const { return position_; }
  void Resume(Position position) { position_ = position; }

 private:
  Position position_;
};

}  // namespace plcxx::hnc
