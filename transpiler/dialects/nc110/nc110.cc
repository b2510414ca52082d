#include "transpiler/dialects/nc110/nc110.h"

#include "transpiler/dialects/nc110/analysis/ladder_lint.h"
#include "transpiler/dialects/nc110/analysis/warnings.h"
#include "transpiler/dialects/nc110/control/documentation.h"
#include "transpiler/dialects/nc110/control/locate.h"
#include "transpiler/dialects/nc110/control/stub.h"
#include "transpiler/dialects/nc110/lowering/lowering.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/parser/parser.h"

namespace plcxx::nc110 {
namespace {

constexpr std::string_view kExtensions[] = {".plc", ".sym"};

void ReportLoadError(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics) {
  const bool too_long =
      error.problem == source::LoadProblem::kTooLarge || error.problem == source::LoadProblem::kLineTooLong;
  if (too_long) {
    diagnostics.Report({}, diag::Nc110SourceTooLong, path, error.detail);
  } else {
    diagnostics.Report({}, diag::Nc110CannotRead, path, error.detail, source::RemedyOf(error.problem));
  }
}

std::string Tokens(dialects::Request& request) {
  const Settings settings = ReadSettings(request);
  std::string text;
  for (const source::FileId file : request.files) text += PrintTokens(*request.sources, file, settings.parse);
  return text;
}

std::string Syntax(dialects::Request& request) {
  const Settings settings = ReadSettings(request);
  return PrintSyntax(*request.sources, Parse(*request.sources, request.files, settings.parse, *request.diagnostics));
}

/// The table of texts in the file that an option names.
TextTable ReadNamedTexts(const dialects::Request& request, const char* key, TextFileKind kind) {
  const auto file = LoadNamedFile(request, key);
  if (!file) return {};
  return ReadTextFile(*request.sources, *file, kind, *request.diagnostics);
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  diag::Engine& diagnostics = *request.diagnostics;
  const source::SourceManager& sources = *request.sources;
  Settings settings = ReadSettings(request);
  settings.facts = request.facts;
  const Program tree = Parse(sources, request.files, settings.parse, diagnostics);

  HelpTexts help;
  if (const auto file = LoadNamedFile(request, "help")) help = ReadHelpFile(sources, *file, diagnostics);
  TextTable messages = ReadNamedTexts(request, "messages", TextFileKind::kMessages);
  AddDeclaredMessages(tree, sources, messages, diagnostics);
  TextTable menu = ReadNamedTexts(request, "menu", TextFileKind::kMenu);

  const auto ladder_lint = request.options.find("ladder-lint");
  if (ladder_lint != request.options.end() && ladder_lint->second == "on") diagnostics.Enable(diag::Nc110Ladder.row);

  const CheckedProgram checked{tree, settings, sources, help, messages};
  CheckZones(checked, diagnostics);
  CheckMessages(checked, diagnostics);
  CheckBcdComparisons(checked, diagnostics);
  if (!diagnostics.HasErrors()) {  // what is missing may stand in a statement that was not understood
    CheckUnwritten(checked, diagnostics);
    CheckUnwrittenFields(checked, diagnostics);
    CheckSelfHold(checked, diagnostics);
    CheckSequencers(checked, diagnostics);
    LintLadder(sources, tree, diagnostics);
  }

  dialects::Lowered lowered;
  lowered.program = Lower(tree, settings, sources);
  lowered.program.messages = std::move(messages.texts);
  lowered.program.menu_texts = std::move(menu.texts);
  lowered.program.documentation = Document(tree, settings, sources, help);
  lowered.summary = {.lines = tree.line_count, .statements = tree.statement_count, .resources = {}};
  return lowered;
}

void ReportOverBudget(dialects::Budget budget, uint64_t needed, uint64_t limit, source::FileId first,
                      const source::SourceManager& sources, diag::Engine& diagnostics) {
  source::Range range = sources.WholeFile(first);
  range.end = range.begin + static_cast<source::Offset>(sources.Line(first, 1).size());
  const auto report = [&](const diag::Message<diag::Number, diag::Number>& message) {
    diagnostics.Report(range, message, static_cast<int64_t>(needed), static_cast<int64_t>(limit));
  };
  switch (budget) {
    case dialects::Budget::kFastUs:
      return report(diag::Nc110FastBudget);
    case dialects::Budget::kSlowMs:
      return report(diag::Nc110SlowBudget);
    case dialects::Budget::kCodeKb:
      return report(diag::Nc110CodeBudget);
  }
}

}  // namespace

const dialects::Dialect kNc110 = {
    .name = "nc110",
    .title = "Balt-System NC-110 ... NC-400",
    .extensions = kExtensions,
    .options = Options(),
    .load = {},
    .recognize = Recognize,
    .report_load_error = ReportLoadError,
    .check_options = CheckOptions,
    .print_tokens = Tokens,
    .print_syntax = Syntax,
    .lower = LowerProgram,
    .locate = Locate,
    .parse_value = ParseValue,
    .make_stub = MakeStub,
    .report_over_budget = ReportOverBudget,
    .lints = {.driven_in_both_parts = &diag::Nc110DrivenInBothParts,
              .driven_twice = &diag::Nc110DrivenTwice,
              .read_never_driven = &diag::Nc110ReadNeverDriven,
              .sliced_carry_read = &diag::Nc110SlicedCarryRead,
              .written_in_both_parts = &diag::Nc110WrittenInBothParts,
              .double_coil = &diag::Nc110DoubleCoil,
              .dead_store = &diag::Nc110DeadStore},
};

}  // namespace plcxx::nc110
