#include "transpiler/dialects/nc110/parser/parser.h"

#include "transpiler/dialects/nc110/parser/logic_reader.h"
#include "transpiler/dialects/nc110/parser/symbol_file_reader.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kMaxFiles = 10;

void ReportProgramWarnings(const Parsing& parsing) {
  const SourceFile* first = nullptr;
  bool empty_reported = false;
  for (const SourceFile& file : parsing.program.files) {
    if (!file.is_symbol_file) {
      first = first == nullptr ? &file : first;
      empty_reported = empty_reported || file.items.count == 0;
    }
  }
  if (first == nullptr) {
    return;
  }
  const source::Offset base = parsing.sources.Get(first->file).base;
  if (parsing.program.statement_count == 0) {
    if (!empty_reported && !parsing.diagnostics.HasErrors()) {
      parsing.diagnostics.Report({base, base}, diag::Nc110NoStatements);
    }
  } else if (!parsing.program.first_cycle_mark.valid()) {
    parsing.diagnostics.Report({base, base}, diag::Nc110NoCycleMark);
  }
}

}  // namespace

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const ParseOptions& options,
              diag::Engine& diagnostics) {
  Parsing parsing{.sources = sources, .options = options, .diagnostics = diagnostics};
  Program& program = parsing.program;
  if (files.size() > kMaxFiles) {
    const source::Offset base = sources.Get(files[kMaxFiles]).base;
    diagnostics.Report({base, base}, diag::Nc110SourceCount, static_cast<diag::Number>(files.size()));
    return std::move(program);
  }
  size_t bytes = 0;
  for (const source::FileId file : files) bytes += sources.Get(file).text.size();
  // Typical programs have one expression node per 6 bytes and one statement per 30.
  program.exprs.Reserve(bytes / 6);
  program.items.Reserve(bytes / 30);
  program.assignments.Reserve(bytes / 30);
  OpenBlocks open_blocks(parsing);
  OperandReader operands(parsing, open_blocks);
  SymbolFileReader symbol_files(parsing, operands);
  LogicReader logic(parsing, open_blocks, operands);
  bool logic_file_seen = false;
  for (const source::FileId file : files) {
    SourceFile entry;
    entry.file = file;
    entry.is_symbol_file = sources.Get(file).text.starts_with('*');
    entry.line_count = sources.LineCount(file);
    program.line_count += entry.line_count;
    program.files.push_back(entry);
    if (entry.is_symbol_file) {
      symbol_files.ParseSymbolFile(file, logic_file_seen);
    } else {
      logic_file_seen = true;
      logic.ParseLogicFile(file, program.files.back());
    }
  }
  open_blocks.ReportAtEnd();
  ReportProgramWarnings(parsing);
  return std::move(program);
}

}  // namespace plcxx::nc110
