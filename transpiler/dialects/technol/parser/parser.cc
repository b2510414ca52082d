#include "transpiler/dialects/technol/parser/parser.h"

#include "transpiler/dialects/technol/parser/file_reader.h"
#include "transpiler/dialects/technol/parser/predefined_symbols.h"
#include "transpiler/dialects/technol/parser/usage.h"
#include "transpiler/dialects/technol/source/sources.h"

namespace plcxx::technol {
namespace {

/// Tells tables from sources (4.5): the first table to the program, all sources to the result.
std::vector<source::FileId> ReadTables(const dialects::Request& request, ParsingContext& context) {
  std::vector<source::FileId> sources;
  bool first = true;
  for (const source::FileId file : request.files) {
    const std::string& path = context.sources.Get(file).path;
    if (!IsTable(path)) {
      sources.push_back(file);
      continue;
    }
    auto table = ReadTable(context.sources, file, context.settings, *request.diagnostics);
    if (first) {
      context.program.table = std::move(table);
    } else {
      const source::Offset begin = context.sources.Get(file).base;
      context.diagnostics.Report({begin, begin}, diag::TechnolTwoTables, path);
    }
    first = false;
  }
  return sources;
}

}  // namespace

Program Parse(dialects::Request& request, const Settings& settings) {
  Parsing parsing{.request = request, .context = ParsingContext(*request.sources, *request.diagnostics, settings)};
  ParsingContext& context = parsing.context;
  Program& program = context.program;
  AddControlSymbols(context.names);
  FileReader files(parsing);
  AddSignalFile(request, context);
  const std::vector<source::FileId> sources = ReadTables(request, context);
  program.tables_only = sources.empty();
  parsing.last_source = program.tables_only ? request.files.back() : sources.back();
  for (const source::FileId file : sources) files.ReadSource(file);
  files.EndOfProgram();
  WarnOfUnused(context, sources);
  request.diagnostics->SortBySource();
  return std::move(program);
}

void AddNotes(diag::Diagnostic& diagnostic, const Program& program, ExpansionId expansion) {
  for (; expansion.valid(); expansion = program.expansions[expansion].outer) {
    const Expansion& line = program.expansions[expansion];
    diagnostic.notes.push_back({line.body, "in macro '" + line.macro + "'"});
  }
}

}  // namespace plcxx::technol
