#include "transpiler/dialects/prostep/parser/parser.h"

#include <utility>

#include "transpiler/dialects/prostep/parser/file_reader.h"

namespace plcxx::prostep {

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, diag::Engine& diagnostics) {
  Parsing parsing{.sources = sources, .diagnostics = diagnostics};
  FileReader reader(parsing);
  for (const source::FileId file : files) reader.TakeFile(file);
  parsing.program.statement_count = parsing.program.instructions.size();
  return std::move(parsing.program);
}

std::string ToText(const Program& program, const Instruction& instruction) {
  std::string text(Info(instruction.op).mnemonic);
  if (instruction.target.valid()) return text + " " + program.labels[instruction.target].name;
  if (instruction.operand.exists()) text += " " + ToText(instruction.operand);
  return text;
}

}  // namespace plcxx::prostep
