#include "transpiler/dialects/classicladder/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/classicladder/lowering/accesses.h"
#include "transpiler/dialects/classicladder/lowering/blocks.h"
#include "transpiler/dialects/classicladder/lowering/contacts.h"
#include "transpiler/dialects/classicladder/lowering/context.h"
#include "transpiler/dialects/classicladder/lowering/declarations.h"
#include "transpiler/dialects/classicladder/lowering/edges.h"
#include "transpiler/dialects/classicladder/lowering/expressions.h"
#include "transpiler/dialects/classicladder/lowering/faults.h"
#include "transpiler/dialects/classicladder/lowering/grid.h"
#include "transpiler/dialects/classicladder/lowering/host_calls.h"
#include "transpiler/dialects/classicladder/lowering/jumps.h"
#include "transpiler/dialects/classicladder/lowering/ladder.h"
#include "transpiler/dialects/classicladder/lowering/logic.h"
#include "transpiler/dialects/classicladder/lowering/names.h"
#include "transpiler/dialects/classicladder/lowering/pages.h"
#include "transpiler/dialects/classicladder/lowering/places.h"
#include "transpiler/dialects/classicladder/lowering/schedule.h"
#include "transpiler/dialects/classicladder/lowering/statement_writer.h"
#include "transpiler/dialects/classicladder/lowering/subroutines.h"
#include "transpiler/dialects/classicladder/machine/places.h"

namespace plcxx::classicladder {

namespace {

/// The collaborators of one lowering. Each is given those that it uses, and no other.
class Lowering : dialects::LoweringFrame<Translation, Context> {
 public:
  using LoweringFrame::LoweringFrame;
  ir::Program Run();

 private:
  HostCalls host_{translation_.builder};
  Names names_{translation_.tree};
  Faults faults_{context_, host_};
  Places places_{context_, names_};
  Accesses accesses_{context_, faults_, places_};
  Edges edges_{context_, names_, accesses_};
  Schedule schedule_{context_, host_, places_, edges_};
  Logic logic_{context_};
  Grid grid_{logic_};
  Contacts contacts_{context_, logic_, grid_, accesses_, edges_};
  Blocks blocks_{context_, logic_, grid_, places_};
  Expressions expressions_{context_, faults_, accesses_};
  Jumps jumps_{context_, faults_, logic_, places_, schedule_};
  Subroutines subroutines_{context_};
  StatementWriter statements_{context_, names_};
  Ladder ladder_{context_, logic_, grid_, contacts_, blocks_, expressions_, jumps_, subroutines_, statements_};
  Pages pages_{context_, places_, accesses_, statements_};
  Declarations declarations_{context_};
};

ir::Program Lowering::Run() {
  const Program& tree = translation_.tree;
  translation_.program.dialect = "classicladder";
  AddSpaces(translation_.program, tree.sizes);
  declarations_.AddInitialValues();
  host_.Add(HostRows());
  schedule_.AddRoutines();
  for (const auto& [number, section] : tree.sections) {
    if (section.language == Language::kLadder && section.is_main()) subroutines_.AddCalledBy(section);
  }
  for (const auto& [number, section] : tree.sections) {
    translation_.builder.SetRegion(schedule_.fast());
    if (section.language == Language::kSequential) {
      pages_.Lower(section);
    } else if (section.is_main()) {
      ladder_.Lower(section, schedule_.fast());
    }
  }
  for (const Section* section : subroutines_.called()) ladder_.Lower(*section, subroutines_.BodyOf(*section));
  pages_.LowerRefresh();
  schedule_.Lower();
  declarations_.AddDocumentation(places_.used());
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::classicladder
