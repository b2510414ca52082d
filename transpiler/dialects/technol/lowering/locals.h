// Registers and what else lives as long as a routine: places that only the lowering needs.
//
// A module or mechanism that calls no subprogram has its locals for itself, in a space of its own. Those of all others
// are in one space, since subprograms share the registers of their callers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Locals : Context {
 public:
  explicit Locals(const Context& context) : Context(context) {}

  void BeginRoutine() { own_.clear(); }
  /// The local with this name of the routine that is lowered: its own, or one that it shares.
  ir::PlaceId operator()(std::string_view name, ir::Type type);
  /// A new one of the routine that is lowered alone.
  ir::PlaceId AddOwn(std::string name, ir::Type type);
  /// A new one of the space that is shared.
  ir::PlaceId AddShared(std::string name, ir::Type type);

 private:
  std::map<std::string, ir::PlaceId> shared_, own_;  // by name; of all routines, of the one that is lowered
  std::map<uint32_t, ir::SpaceId> own_spaces_;       // by the routine's number
  uint32_t shared_count_ = 0;
};

}  // namespace plcxx::technol
