// The functions of decoded instructions.
#pragma once

#include <optional>

#include "transpiler/ir/program.h"
#include "transpiler/sim/decoded.h"
#include "transpiler/sim/place_access.h"
#include "transpiler/sim/rungs.h"

namespace plcxx::sim {

using Function = decltype(Decoded::execute);

/// What executes an operation, whatever it is given.
Function FunctionOf(ir::OpKind op);
/// What executes a load or a store of this place, of which the frequent forms have functions of their own: those take
/// their place from the decoded instruction itself.
Function LoadOf(const PlaceAccess& access, ir::Type type);
Function StoreOf(const PlaceAccess& access);

/// `inst` as it is here, its result at `id`.
Flow ExecuteAs(Execution& execution, ir::InstId id, const ir::Inst& inst);

/// A rung: its statement begins, its contacts are joined, its coil is written.
Flow ExecuteRung(Execution& execution, const Decoded& inst);
/// The step that an instruction is in a rung; none: it is nothing for one.
std::optional<LogicStep> StepOf(const ir::Inst& inst, const Decoded& decoded);
/// Whether it may be the coil of one.
bool WritesBit(const Decoded& decoded);

}  // namespace plcxx::sim
