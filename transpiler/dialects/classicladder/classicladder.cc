#include "transpiler/dialects/classicladder/classicladder.h"

#include "transpiler/dialects/classicladder/control/locate.h"
#include "transpiler/dialects/classicladder/control/stub.h"
#include "transpiler/dialects/classicladder/lowering/lowering.h"
#include "transpiler/dialects/classicladder/machine/options.h"
#include "transpiler/dialects/classicladder/parser/parser.h"
#include "transpiler/dialects/classicladder/source/recognize.h"
#include "transpiler/dialects/common/wiring.h"

namespace plcxx::classicladder {
namespace {

constexpr std::string_view kExtensions[] = {".clp"};

std::string Syntax(dialects::Request& request) {
  const Settings settings = ReadSettings(request.options);
  return PrintSyntax(*request.sources, Parse(*request.sources, request.files, settings, *request.diagnostics));
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  Settings settings = ReadSettings(request.options);
  settings.facts = request.facts;
  const Program tree = Parse(*request.sources, request.files, settings, *request.diagnostics);
  dialects::Lowered lowered;
  lowered.summary = {.lines = tree.line_count, .statements = tree.element_count, .resources = {}};
  if (!request.diagnostics->HasErrors()) lowered.program = Lower(tree, settings, *request.sources);
  return lowered;
}

}  // namespace

const dialects::Dialect kClassicladder = {
    .name = "classicladder",
    .title = "ClassicLadder of LinuxCNC",
    .extensions = kExtensions,
    .options = Options(),
    .load = {},
    .recognize = Recognize,
    .report_load_error = dialects::ReportCannotRead,
    .check_options = CheckOptions,
    .print_tokens = dialects::TokensOfFiles<PrintTokens>,
    .print_syntax = Syntax,
    .lower = LowerProgram,
    .locate = Locate,
    .parse_value = ParseValue,
    .make_stub = MakeStub,
    .report_over_budget = dialects::ReportNoBudget,
    .lints = {},
};

}  // namespace plcxx::classicladder
