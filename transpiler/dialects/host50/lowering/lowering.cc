#include "transpiler/dialects/host50/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/host50/lowering/axes.h"
#include "transpiler/dialects/host50/lowering/blocks.h"
#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/contacts.h"
#include "transpiler/dialects/host50/lowering/documentation.h"
#include "transpiler/dialects/host50/lowering/elements.h"
#include "transpiler/dialects/host50/lowering/faults.h"
#include "transpiler/dialects/host50/lowering/host_calls.h"
#include "transpiler/dialects/host50/lowering/instruction_set.h"
#include "transpiler/dialects/host50/lowering/jumps.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/names.h"
#include "transpiler/dialects/host50/lowering/network_writer.h"
#include "transpiler/dialects/host50/lowering/numbers.h"
#include "transpiler/dialects/host50/lowering/own_instances.h"
#include "transpiler/dialects/host50/lowering/own_places.h"
#include "transpiler/dialects/host50/lowering/results.h"
#include "transpiler/dialects/host50/lowering/routines.h"
#include "transpiler/dialects/host50/lowering/schedule.h"
#include "transpiler/dialects/host50/lowering/section_writer.h"
#include "transpiler/dialects/host50/lowering/slices.h"
#include "transpiler/dialects/host50/lowering/statement_writer.h"
#include "transpiler/dialects/host50/lowering/tables.h"

namespace plcxx::host50 {
namespace {

/// The collaborators of one lowering. Each is given those that it uses, and no other.
class Lowering : dialects::LoweringFrame<Translation, Context> {
 public:
  using LoweringFrame::LoweringFrame;
  ir::Program Run();

 private:
  HostCalls host_{translation_.builder};
  Names names_{context_};
  Cells cells_{context_, names_};
  OwnPlaces own_places_{context_};
  OwnInstances instances_{context_, names_};
  Routines routines_{context_, own_places_};
  Faults faults_{context_, host_};
  Logic logic_{context_};
  Numbers numbers_{context_, cells_};
  Contacts contacts_{context_, cells_, instances_, logic_};
  Results results_{context_, contacts_, logic_, numbers_};
  Jumps jumps_{context_, own_places_, faults_, logic_, results_};
  Blocks blocks_{context_, cells_, numbers_, routines_};
  Elements elements_{context_, cells_, faults_, logic_, numbers_, results_};
  Axes axes_{context_, host_, cells_, instances_, faults_, logic_, numbers_, results_};
  InstructionSet instructions_{context_, cells_, contacts_, logic_, results_, jumps_, blocks_, elements_, axes_};
  StatementWriter statements_{context_, names_};
  NetworkWriter networks_{context_, jumps_, results_, instructions_, statements_};
  Slices slices_{context_, own_places_, routines_, jumps_, statements_, networks_};
  SectionWriter sections_{context_, routines_, jumps_, statements_, networks_, slices_};
  Schedule schedule_{context_, host_, cells_, own_places_, instances_, routines_};
  Tables tables_{context_};
  Documentation documentation_{context_, cells_, names_};
};

ir::Program Lowering::Run() {
  host_.Add(HostRows());
  translation_.facts.Begin(translation_.settings.facts);
  routines_.Add();
  schedule_.AddPlaces();
  sections_.LowerAll();
  schedule_.Lower();
  tables_.Add();
  documentation_.Add();
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  if (!tree.faulty) return Lowering(tree, settings, sources).Run();
  ir::Program none;
  none.dialect = "host50";
  return none;
}

}  // namespace plcxx::host50
