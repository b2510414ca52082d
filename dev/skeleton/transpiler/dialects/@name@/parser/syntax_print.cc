// `plcxx print tokens` and `plcxx print syntax`: one line per token or statement, stable, places as line:column.
#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/@name@/parser/parser.h"
#include "transpiler/dialects/@name@/source/lexer.h"

namespace plcxx::@name@ {
std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  return dialects::TokenLines(sources, Lex(sources, file));
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  std::string out;
  for (const SourceFile& file : program.files) {
    out += "file " + sources.Get(file.file).path + "\n";
    for (uint32_t i = 0; i < file.count; ++i) {
      const Statement& statement = program.statements[StatementId(file.first.index + i)];
      out += "  " + dialects::PlaceText(sources, statement.range.begin) + " " + std::string(Name(statement.instruction)) + " " +
             std::string(sources.Text(statement.range)) + "\n";
    }
  }
  return out;
}

}  // namespace plcxx::@name@
