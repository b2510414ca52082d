#include "transpiler/dialects/@name@/@name@.h"

#include "transpiler/dialects/common/wiring.h"
#include "transpiler/dialects/@name@/control/locate.h"
#include "transpiler/dialects/@name@/control/stub.h"
#include "transpiler/dialects/@name@/lowering/lowering.h"
#include "transpiler/dialects/@name@/machine/options.h"
#include "transpiler/dialects/@name@/parser/parser.h"
#include "transpiler/dialects/@name@/source/recognize.h"

namespace plcxx::@name@ {
namespace {

constexpr std::string_view kExtensions[] = {".@name@"};

std::string Syntax(dialects::Request& request) {
  return PrintSyntax(*request.sources, Parse(*request.sources, request.files, *request.diagnostics));
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  Settings settings = ReadSettings(request.options);
  settings.facts = request.facts;
  const Program tree = Parse(*request.sources, request.files, *request.diagnostics);
  dialects::Lowered lowered;
  lowered.summary = {.lines = tree.line_count, .statements = tree.statements.size(), .resources = {}};
  if (!request.diagnostics->HasErrors()) lowered.program = Lower(tree, settings);
  return lowered;
}

}  // namespace

const dialects::Dialect k@Name@ = {
    .name = "@name@",
    .title = "@Name@",
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

}  // namespace plcxx::@name@
