#include "transpiler/dialects/prostep/prostep.h"

#include "transpiler/dialects/common/wiring.h"
#include "transpiler/dialects/prostep/analysis/program_checks.h"
#include "transpiler/dialects/prostep/control/locate.h"
#include "transpiler/dialects/prostep/control/stub.h"
#include "transpiler/dialects/prostep/lowering/lowering.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/source/lexer.h"
#include "transpiler/dialects/prostep/source/numbers.h"

namespace plcxx::prostep {
namespace {

constexpr std::string_view kExtensions[] = {".plc", ".pst"};
constexpr source::Encoding kEncodings[] = {source::Encoding::kMazovia, source::Encoding::kCp852,
                                           source::Encoding::kCp1250, source::Encoding::kUtf8};

Program ParseProgram(const dialects::Request& request, const Settings& settings) {
  diag::Engine& diagnostics = *request.diagnostics;
  if (settings.strict) {
    for (const diag::Row* row : {&diag::ProstepDeclarationIndented.row, &diag::ProstepHighByteUnknown.row,
                                 &diag::ProstepAlwaysZero.row, &diag::ProstepAlwaysSeesZero.row}) {
      diagnostics.MakeError(*row);
    }
  }
  Program tree = Parse(*request.sources, request.files, diagnostics);
  ResolveCalls(tree, diagnostics);
  return tree;
}

std::string Syntax(dialects::Request& request) {
  return PrintSyntax(*request.sources, ParseProgram(request, ReadSettings(request.options)));
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  diag::Engine& diagnostics = *request.diagnostics;
  Settings settings = ReadSettings(request.options);
  settings.facts = request.facts;
  const Program tree = ParseProgram(request, settings);
  dialects::Lowered lowered;
  lowered.summary = {.lines = tree.line_count, .statements = tree.statement_count, .resources = {}};
  if (diagnostics.HasErrors()) return lowered;
  CheckUncalled(tree, diagnostics);
  CheckActivity(tree, *request.sources, diagnostics);
  CheckLabels(tree, diagnostics);
  CheckMessages(tree, diagnostics);
  CheckTimersAndCounters(tree, diagnostics);
  CheckInputWrites(tree, diagnostics);
  lowered.program = Lower(tree, settings, *request.sources, diagnostics);
  return lowered;
}

/// A number of 2.5, up to four bytes: 18, -5, 0FFH, 12D.
std::optional<uint64_t> ParseValue(std::string_view text) {
  const ConstantNumber constant = ReadConstant(TrimBlanks(text), 4);
  if (constant.fault != NumberFault::kNone) return std::nullopt;
  return constant.value;
}

}  // namespace

const dialects::Dialect kProstep = {
    .name = "prostep",
    .title = "PRONUM 630T, 640FC",
    .extensions = kExtensions,
    .options = Options(),
    .load = {.encodings = kEncodings,
             .choice = source::Choice::kAlways,
             .detection = source::Detection::kFallback,
             .fallback = source::Encoding::kMazovia,
             .undecodable = source::Undecodable::kByTheDialect,
             .line_ends = source::LineEnds::kEveryCrAndLf,
             .end_marks = "\x03\x1A",
             .text_behind_end = source::TextBehindEnd::kIsNothing},
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
    .message_text = MessageText,
};

}  // namespace plcxx::prostep
