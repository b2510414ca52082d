#include "transpiler/dialects/nc110/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/nc110/lowering/blocks.h"
#include "transpiler/dialects/nc110/lowering/cells.h"
#include "transpiler/dialects/nc110/lowering/expirations.h"
#include "transpiler/dialects/nc110/lowering/expressions.h"
#include "transpiler/dialects/nc110/lowering/faults.h"
#include "transpiler/dialects/nc110/lowering/frames.h"
#include "transpiler/dialects/nc110/lowering/host_calls.h"
#include "transpiler/dialects/nc110/lowering/item_writer.h"
#include "transpiler/dialects/nc110/lowering/latched_inputs.h"
#include "transpiler/dialects/nc110/lowering/routines.h"
#include "transpiler/dialects/nc110/lowering/schedule.h"
#include "transpiler/dialects/nc110/lowering/statement_writer.h"
#include "transpiler/dialects/nc110/lowering/system_places.h"
#include "transpiler/dialects/nc110/lowering/targets.h"
#include "transpiler/dialects/nc110/lowering/texts.h"

namespace plcxx::nc110 {
namespace {

/// The collaborators of one lowering. Each is given those that it uses, and no other.
class Lowering : dialects::LoweringFrame<Translation, Context> {
 public:
  using LoweringFrame::LoweringFrame;
  ir::Program Run();

 private:
  HostCalls host_{translation_.builder};
  Cells cells_{context_};
  LatchedInputs inputs_{context_, cells_};
  SystemPlaces system_{context_};
  Texts texts_{context_};
  Routines routines_{context_};
  Faults faults_{context_, host_};
  Expirations expirations_{context_};
  Expressions expressions_{context_, inputs_, texts_};
  Targets targets_{context_, cells_, inputs_, system_, faults_, expressions_, expirations_};
  StatementWriter statements_{context_};
  Blocks blocks_{context_, expressions_, faults_, statements_};
  ItemWriter items_{context_, routines_, blocks_, targets_, statements_};
  Frames frames_{context_, routines_, system_, inputs_, texts_, expirations_};
  Schedule schedule_{context_, host_, cells_, system_, routines_};
};

ir::Program Lowering::Run() {
  host_.Add(HostRows());
  translation_.facts.Begin(translation_.settings.facts);
  routines_.Add();
  schedule_.Declare();
  items_.LowerAll();
  frames_.LowerFast();
  frames_.LowerSlow();
  schedule_.Lower();
  schedule_.AddMessagePlaces();
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::nc110
