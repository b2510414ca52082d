#include "transpiler/dialects/technol/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/technol/lowering/arithmetic.h"
#include "transpiler/dialects/technol/lowering/assembler.h"
#include "transpiler/dialects/technol/lowering/bits.h"
#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/dialects/technol/lowering/conditions.h"
#include "transpiler/dialects/technol/lowering/data.h"
#include "transpiler/dialects/technol/lowering/documentation.h"
#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/faults.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/host_calls.h"
#include "transpiler/dialects/technol/lowering/instruction_set.h"
#include "transpiler/dialects/technol/lowering/jumps.h"
#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"
#include "transpiler/dialects/technol/lowering/mechanisms.h"
#include "transpiler/dialects/technol/lowering/moves.h"
#include "transpiler/dialects/technol/lowering/operands.h"
#include "transpiler/dialects/technol/lowering/products.h"
#include "transpiler/dialects/technol/lowering/requests.h"
#include "transpiler/dialects/technol/lowering/routine_writer.h"
#include "transpiler/dialects/technol/lowering/schedule.h"
#include "transpiler/dialects/technol/lowering/segments.h"
#include "transpiler/dialects/technol/lowering/shifts.h"
#include "transpiler/dialects/technol/lowering/statement_writer.h"
#include "transpiler/dialects/technol/lowering/subprograms.h"
#include "transpiler/dialects/technol/lowering/waits.h"

namespace plcxx::technol {
namespace {

void AddInitialData(Translation& translation) {
  const Program& tree = translation.tree;
  const auto initial = [&](Area area, auto&& bytes) {
    for (uint32_t i = 0; i < bytes.size(); ++i) {
      if (bytes[i] == 0) continue;
      translation.program.spaces[translation.memory[area]].initial.push_back({.offset = i, .value = bytes[i]});
    }
  };
  if (!tree.user_data.empty()) initial(Area::kUser, tree.user_data);
  initial(Area::kTabTechnol, tree.table ? ImageOf(*tree.table) : EmptyImage());
}

/// A register whose upper half nobody reads has 16 bits.
void FindWideRegisters(Translation& translation) {
  const Program& tree = translation.tree;
  const Flow& flow = translation.flow;
  for (uint32_t i = 0; i < tree.instructions.size(); ++i) {
    const InstructionId id(i);
    if (!flow.IsReached(id)) continue;
    const uint32_t width = flow.WidthBefore(id) == 0 ? 16 : flow.WidthBefore(id);
    const Resources reads = EffectsOf(tree, tree.instructions[id], width).reads;
    for (const Register reg :
         {Register::kEax, Register::kEbx, Register::kEcx, Register::kEdx, Register::kEsi, Register::kEdi}) {
      const Resources upper = PartsOf(reg) & ~(PartsOf(reg) >> 1) & ~(PartsOf(reg) >> 2);
      if ((reads & upper) != 0) translation.registers.MakeWide(reg);
    }
  }
}

/// The collaborators of one lowering. Each is given those that it uses, and no other.
class Lowering : dialects::LoweringFrame<Translation, Context> {
 public:
  using LoweringFrame::LoweringFrame;
  ir::Program Run();

 private:
  HostCalls host_{translation_.builder};
  Faults faults_{context_, host_};
  CellPlaces cells_{context_};
  MechanismPlaces mechanism_places_{context_, cells_};
  Locals locals_{context_};
  Exits exits_{context_, locals_};
  Operands operands_{context_, cells_, mechanism_places_, faults_, exits_};
  Flags flags_{context_};
  Conditions conditions_{context_, flags_};
  Segments segments_{context_, locals_, mechanism_places_};
  Jumps jumps_{context_, locals_, faults_, exits_, flags_, conditions_, segments_};
  Waits waits_{context_, mechanism_places_, exits_, operands_, jumps_};
  Mechanisms mechanisms_{context_, locals_, mechanism_places_, exits_};
  Subprograms subprograms_{context_, exits_, mechanisms_};
  Bits bits_{context_, operands_, mechanisms_};
  Data data_{context_, faults_, operands_};
  Arithmetic arithmetic_{context_, operands_, flags_, conditions_};
  Moves moves_{context_, locals_, operands_};
  Shifts shifts_{context_, operands_, flags_};
  Products products_{context_, faults_, operands_, flags_};
  Assembler assembler_{context_, flags_, jumps_, arithmetic_, moves_, shifts_, products_};
  InstructionSet instructions_{context_, cells_, host_,       jumps_,       bits_,
                               data_,    waits_, mechanisms_, subprograms_, assembler_};
  StatementWriter statements_{context_, cells_};
  Requests requests_{context_, cells_, host_};
  Schedule schedule_{context_, cells_, host_, mechanisms_, requests_};
  RoutineWriter routines_{context_,    locals_,   mechanism_places_, exits_,        flags_,
                          conditions_, segments_, statements_,       instructions_, schedule_};
  Documentation documentation_{context_};
};

ir::Program Lowering::Run() {
  translation_.program.dialect = "technol";
  AddInitialData(translation_);
  FindWideRegisters(translation_);
  host_.Add(HostRows());
  translation_.facts.Begin(translation_.settings.facts);
  schedule_.AddRoutines();
  routines_.AddRoutines();
  schedule_.LowerPowerOn();
  statements_.FindTargets();
  for (const Routine& routine : translation_.routines.all()) routines_.Lower(routine);
  documentation_.Add();
  schedule_.Lower();
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Flow& flow, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(flow, settings, sources).Run();
}

}  // namespace plcxx::technol
