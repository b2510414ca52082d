#include "transpiler/dialects/technol/technol.h"

#include <filesystem>
#include <string>
#include <vector>

#include "transpiler/dialects/common/wiring.h"
#include "transpiler/dialects/technol/analysis/flow_checks.h"
#include "transpiler/dialects/technol/analysis/warnings.h"
#include "transpiler/dialects/technol/control/locate.h"
#include "transpiler/dialects/technol/control/stub.h"
#include "transpiler/dialects/technol/lowering/lowering.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/machine/technology_table.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/source/sources.h"
#include "transpiler/dialects/technol/syntax/raised_errors.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kExtensions[] = {".plc", ".tch"};

std::string Syntax(dialects::Request& request) {
  return PrintSyntax(*request.sources, Parse(request, ReadSettings(request.options)));
}

/// The table of the sources as an image and as a listing, each named after its file (9.8.3).
std::vector<dialects::DataFile> TableFiles(const TechnologyTable& table, const source::SourceManager& sources) {
  const std::string stem = std::filesystem::path(sources.Get(table.file).path).stem().string();
  const TableImage image = ImageOf(table);
  return {{.name = stem + ".bin", .bytes = std::string(image.begin(), image.end())},
          {.name = stem + ".lst", .bytes = Listing(table)}};
}

dialects::Lowered LowerProgram(dialects::Request& request) {
  diag::Engine& diagnostics = *request.diagnostics;
  Settings settings = ReadSettings(request.options);
  settings.facts = request.facts;
  const Program tree = Parse(request, settings);
  dialects::Lowered lowered;
  lowered.summary = {.lines = tree.line_count, .statements = tree.statement_count, .raised_errors = RaisedErrors(tree)};
  lowered.has_program = !tree.tables_only;
  if (tree.table) lowered.data_files = TableFiles(*tree.table, *request.sources);
  const Flow flow(tree);
  CheckPaths(flow, diagnostics);
  CheckStack(flow, diagnostics);
  CheckLoads(flow, diagnostics);
  if (!diagnostics.HasErrors()) CheckResumePoints(flow, diagnostics);
  if (diagnostics.HasErrors()) return lowered;
  if (!tree.tables_only) {
    WarnOfPaths(flow, diagnostics);
    Warn(flow, diagnostics);
  }
  lowered.program = Lower(flow, settings, *request.sources);
  return lowered;
}

}  // namespace

const dialects::Dialect kTechnol = {
    .name = "technol",
    .title = "MEFI CNC836, CNC8x6, CNC8x9, CNC872",
    .extensions = kExtensions,
    .options = Options(),
    .load = SourceOptions(),
    .recognize = Recognize,
    .report_load_error = ReportLoadError,
    .check_options = CheckOptions,
    .print_tokens = dialects::TokensOfFiles<PrintTokens>,
    .print_syntax = Syntax,
    .lower = LowerProgram,
    .locate = Locate,
    .parse_value = ParseValue,
    .make_stub = MakeStub,
    .report_over_budget = dialects::ReportNoBudget,
    .lints = {},  // its own warnings are those of warnings.h
    .options_take_underscores = true,
    .reads_empty_files = true,
    .takes_system_includes = true,
};

}  // namespace plcxx::technol
