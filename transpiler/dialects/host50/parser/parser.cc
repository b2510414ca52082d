#include "transpiler/dialects/host50/parser/parser.h"

#include <algorithm>

#include "transpiler/dialects/host50/parser/body_reader.h"
#include "transpiler/dialects/host50/parser/call_graph.h"
#include "transpiler/dialects/host50/parser/directive_reader.h"
#include "transpiler/dialects/host50/parser/structure_reader.h"
#include "transpiler/dialects/host50/parser/table_reader.h"

namespace plcxx::host50 {
namespace {

/// E111 for each line with bytes that its encoding does not define, also in comments and texts.
void ReportUndefinedBytes(Parsing& parsing, const source::File& file) {
  constexpr uint32_t kReplacementBytes = 3;  // of U+FFFD
  uint32_t last_line = 0;
  for (const uint32_t at : file.replaced) {
    const source::Offset begin = file.base + at;
    const uint32_t line = parsing.sources.Locate(begin).line;
    if (line == last_line) continue;
    last_line = line;
    parsing.program.faulty = true;
    parsing.diagnostics.Report({begin, begin + kReplacementBytes}, diag::Host50UndefinedByte,
                               source::Name(file.encoding));
  }
}

}  // namespace

void PlaceInFirstLines(const Program& program, diag::Engine& diagnostics) {
  if (program.continuations.empty()) return;
  diagnostics.MovePlaces([&](source::Range range) {
    const auto behind = std::ranges::upper_bound(program.continuations, range.begin, {},
                                                 [](const Continuation& lines) { return lines.rest.begin; });
    if (behind == program.continuations.begin()) return range;
    const Continuation& lines = *std::prev(behind);
    return range.begin <= lines.rest.end ? lines.first : range;
  });
}

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files,
              const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  Parsing parsing{.sources = sources, .diagnostics = diagnostics};
  Program& program = parsing.program;
  program.files.assign(files.begin(), files.end());
  for (const source::FileId file : files) {
    parsing.files.push_back(Lex(sources, file));
    program.line_count += sources.LineCount(file);
    for (const Line& line : parsing.files.back().lines) {
      if (line.continuation.rest.end != 0) program.continuations.push_back(line.continuation);
    }
    ReportUndefinedBytes(parsing, sources.Get(file));
  }
  const Parts parts = StructureReader(parsing).ReadStructure();
  DirectiveReader(parsing).ReadDirectives(parts.directives);
  ApplyOptions(options, program.settings);
  SymbolReader symbols(parsing);
  TableReader(parsing, symbols).ReadTables(parts.tables);
  BodyReader(parsing, parts, symbols).ReadBodies();
  CheckCalls(program, diagnostics);
  return std::move(program);
}

}  // namespace plcxx::host50
