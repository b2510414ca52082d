#include "transpiler/dialects/host50/host50.h"

#include "transpiler/dialects/common/wiring.h"
#include "transpiler/dialects/host50/analysis/resources.h"
#include "transpiler/dialects/host50/analysis/warnings.h"
#include "transpiler/dialects/host50/control/locate.h"
#include "transpiler/dialects/host50/control/stub.h"
#include "transpiler/dialects/host50/lowering/lowering.h"
#include "transpiler/dialects/host50/machine/options.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/dialects/host50/source/recognize.h"

namespace plcxx::host50 {
namespace {

constexpr std::string_view kExtensions[] = {".il"};
constexpr source::Encoding kEncodings[] = {source::Encoding::kUtf8, source::Encoding::kGb18030};
constexpr uint32_t kMostErrors = 100;  // of section 10

Program ParseProgram(const dialects::Request& request) {
  return Parse(*request.sources, request.files, request.options, *request.diagnostics);
}

std::string Syntax(dialects::Request& request) {
  const Program tree = ParseProgram(request);
  const std::string text = PrintSyntax(*request.sources, tree);
  PlaceInFirstLines(tree, *request.diagnostics);
  request.diagnostics->LimitErrors(kMostErrors);
  return text;
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  diag::Engine& diagnostics = *request.diagnostics;
  const Program tree = ParseProgram(request);
  CheckProgram(tree, *request.sources, diagnostics);
  PlaceInFirstLines(tree, diagnostics);
  diagnostics.LimitErrors(kMostErrors);
  dialects::Lowered lowered;
  lowered.summary = {.lines = tree.line_count, .statements = tree.statement_count, .resources = {}};
  for (const ResourceUse& use : ResourcesOf(tree)) {
    lowered.summary.resources.push_back(
        {.name = Name(use.resource), .used = use.used, .available = Available(use.resource)});
  }
  Settings settings = tree.settings;
  settings.facts = request.facts;
  if (!tree.faulty) lowered.program = Lower(tree, settings, *request.sources);
  return lowered;
}

}  // namespace

const dialects::Dialect kHost50 = {
    .name = "host50",
    .title = "CTB HOST 50 series",
    .extensions = kExtensions,
    .options = Options(),
    .load = {.encodings = kEncodings,
             .choice = source::Choice::kAlways,
             .detection = source::Detection::kFallback,
             .fallback = source::Encoding::kGb18030,
             .undecodable = source::Undecodable::kByTheDialect,
             .line_ends = source::LineEnds::kLfOrCrLf,
             .end_marks = ""},
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
    .lints = {},  // its own warnings are those of warnings.h
    .options_ignore_case = true,
    .message_text = MessageText,
};

}  // namespace plcxx::host50
