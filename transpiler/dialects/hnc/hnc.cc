#include "transpiler/dialects/hnc/hnc.h"

#include <charconv>
#include <utility>

#include "transpiler/dialects/common/wiring.h"
#include "transpiler/dialects/hnc/analysis/summary.h"
#include "transpiler/dialects/hnc/control/locate.h"
#include "transpiler/dialects/hnc/control/stub.h"
#include "transpiler/dialects/hnc/lowering/lowering.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/parser/files.h"
#include "transpiler/dialects/hnc/parser/parser.h"
#include "transpiler/dialects/hnc/source/recognize.h"

namespace plcxx::hnc {
namespace {

constexpr std::string_view kExtensions[] = {".cld"};
constexpr uint32_t kMostErrors = 50;

std::string Syntax(dialects::Request& request) { return PrintSyntax(*request.sources, Parse(request)); }

dialects::Lowered LowerProgram(dialects::Request& request) {
  Settings settings = ReadSettings(request.options);
  settings.facts = request.facts;
  Unit unit = Parse(request);
  dialects::Lowered lowered;
  lowered.summary = {.lines = unit.line_count, .statements = unit.statement_count};
  const Objects objects(unit);
  const Facts facts(unit, objects);
  lowered.program = Lower(unit, objects, facts, settings, *request.sources, *request.diagnostics);
  if (request.lists == dialects::Lists::kAll && !request.diagnostics->HasErrors()) {
    lowered.summary.tables = SummaryTables(unit, objects, facts, lowered.program, *request.sources);
  }
  request.diagnostics->LimitErrors(kMostErrors);
  Keep(request, std::move(unit));
  return lowered;
}

/// A number as C writes it: 16, 0x10, 020, with the suffixes u and l; a character constant of one byte.
std::optional<uint64_t> ParseValue(std::string_view text) {
  if (text.size() == 3 && text.front() == '\'' && text.back() == '\'') return static_cast<uint8_t>(text[1]);
  while (!text.empty() && (text.back() == 'u' || text.back() == 'U' || text.back() == 'l' || text.back() == 'L')) {
    text.remove_suffix(1);
  }
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    base = 16;
    text.remove_prefix(2);
  } else if (text.size() > 1 && text.front() == '0') {
    base = 8;
  }
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

const dialects::Dialect kHnc = {
    .name = "hnc",
    .title = "Huazhong HNC Century Star",
    .extensions = kExtensions,
    .options = Options(),
    .load = LoadOptionsOf({}),
    .recognize = Recognize,
    .report_load_error = dialects::ReportCannotRead,
    .check_options = CheckOptions,
    .print_tokens = PrintTokens,
    .print_syntax = Syntax,
    .lower = LowerProgram,
    .locate = Locate,
    .parse_value = ParseValue,
    .make_stub = MakeStub,
    .report_over_budget = dialects::ReportNoBudget,
    .lints = {},
    .options_take_underscores = true,
    .takes_macros = true,
    .values_wrap = true,
    .whole_periods = true,
};

}  // namespace plcxx::hnc
