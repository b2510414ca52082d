// `plcxx print tokens` and `plcxx print syntax`: one line per token or statement, stable, places as line:column.
#include "transpiler/dialects/@name@/lexer.h"
#include "transpiler/dialects/@name@/parser.h"

namespace plcxx::@name@ {
namespace {

std::string Place(const source::SourceManager& sources, source::Offset offset) {
  const source::Position position = sources.Locate(offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  std::string out;
  for (const Token& token : Lex(sources, file)) {
    out += Place(sources, token.range.begin) + " " + std::string(Name(token.kind)) + " " +
           std::string(sources.Text(token.range)) + "\n";
  }
  return out;
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  std::string out;
  for (const SourceFile& file : program.files) {
    out += "file " + sources.Get(file.file).path + "\n";
    for (uint32_t i = 0; i < file.count; ++i) {
      const Statement& statement = program.statements[StatementId(file.first.index + i)];
      out += "  " + Place(sources, statement.range.begin) + " " + std::string(Name(statement.instruction)) + " " +
             std::string(sources.Text(statement.range)) + "\n";
    }
  }
  return out;
}

}  // namespace plcxx::@name@
