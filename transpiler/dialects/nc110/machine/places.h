// Operands as places: shared by lowering, which owns a program's places, and locate, which names any of them.
#pragma once

#include <optional>
#include <string>

#include "transpiler/dialects/nc110/machine/operands.h"
#include "transpiler/ir/program.h"

namespace plcxx::nc110 {

/// A signal or word of a package, without name and address.
ir::Place MemoryPlace(const Operand& operand);

/// What TnI, CnW, Pn ... are: a field of an instance.
struct InstanceField {
  ir::StateKind kind{};
  uint8_t field = 0;
  std::string instance;  // "T5"
};
std::optional<InstanceField> FieldOfOperand(const Operand& operand);

}  // namespace plcxx::nc110
