#include "transpiler/dialects/prostep/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/prostep/analysis/warnings.h"
#include "transpiler/dialects/prostep/lowering/arithmetic.h"
#include "transpiler/dialects/prostep/lowering/bits.h"
#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/control.h"
#include "transpiler/dialects/prostep/lowering/declarations.h"
#include "transpiler/dialects/prostep/lowering/documentation.h"
#include "transpiler/dialects/prostep/lowering/faults.h"
#include "transpiler/dialects/prostep/lowering/functions.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"
#include "transpiler/dialects/prostep/lowering/indexed_cells.h"
#include "transpiler/dialects/prostep/lowering/indirect_access.h"
#include "transpiler/dialects/prostep/lowering/instances.h"
#include "transpiler/dialects/prostep/lowering/instruction_set.h"
#include "transpiler/dialects/prostep/lowering/locals.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/long_words.h"
#include "transpiler/dialects/prostep/lowering/module_writer.h"
#include "transpiler/dialects/prostep/lowering/nc_variables.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/refresh.h"
#include "transpiler/dialects/prostep/lowering/registers.h"
#include "transpiler/dialects/prostep/lowering/scalars.h"
#include "transpiler/dialects/prostep/lowering/schedule.h"
#include "transpiler/dialects/prostep/lowering/statement_writer.h"
#include "transpiler/dialects/prostep/lowering/timing.h"

namespace plcxx::prostep {

namespace {

/// The collaborators of one lowering. Each is given those that it uses, and no other.
class Lowering : dialects::LoweringFrame<Translation, Context> {
 public:
  using LoweringFrame::LoweringFrame;
  ir::Program Run();

 private:
  HostCalls host_{translation_.builder};
  Scalars scalars_{context_};
  Cells cells_{context_};
  IndexedCells indexed_{context_};
  Instances instances_{context_};
  Locals locals_{context_};
  Faults faults_{context_, host_};
  Registers registers_{context_, scalars_};
  Operands operands_{context_, host_, cells_};
  Logic logic_{context_, registers_};
  Bits bits_{context_, cells_, instances_, operands_, logic_};
  Timing timing_{context_, scalars_, instances_, operands_, logic_};
  Control control_{context_, scalars_, faults_, registers_, logic_};
  Arithmetic arithmetic_{context_, cells_, faults_, registers_, operands_};
  IndirectAccess indirect_{context_, cells_, indexed_, faults_, registers_, operands_};
  NcVariables nc_{context_, host_, scalars_, cells_, faults_, operands_};
  LongWords long_words_{context_, cells_, registers_};
  Functions functions_{context_, registers_, logic_, arithmetic_, indirect_, nc_, long_words_};
  InstructionSet instructions_{context_, registers_, operands_, logic_, bits_, timing_, control_, functions_};
  StatementWriter statements_{context_, registers_};
  ModuleWriter modules_{context_, registers_, logic_, control_, instructions_, statements_};
  Refresh refresh_{context_, host_, cells_};
  Schedule schedule_{context_, host_, scalars_, cells_, instances_, locals_, refresh_};
  Declarations declarations_{context_, cells_, locals_};
  Documentation documentation_{context_, cells_, instances_};
};

ir::Program Lowering::Run() {
  translation_.program.dialect = "prostep";
  declarations_.AddInitialData();
  host_.Add(HostRows());
  translation_.facts.Begin(translation_.settings.facts);
  schedule_.AddRoutines();
  modules_.AddRoutines(schedule_.init());
  schedule_.LowerPowerOn();
  for (uint32_t i = 0; i < translation_.tree.modules.size(); ++i) modules_.Lower(ModuleId(i));
  documentation_.Add();
  schedule_.Lower();
  declarations_.AddMessages();
  declarations_.AddMFunctions();
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources,
                  diag::Engine& diagnostics) {
  if (diagnostics.HasErrors()) return {};
  CheckWhatIsExecuted(tree, settings, diagnostics);
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::prostep
