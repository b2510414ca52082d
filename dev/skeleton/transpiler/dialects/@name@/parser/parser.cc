#include "transpiler/dialects/@name@/parser/parser.h"

#include "transpiler/dialects/@name@/source/lexer.h"

namespace plcxx::@name@ {
namespace {

class Parser {
 public:
  Parser(const source::SourceManager& sources, diag::Engine& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {}

  void ParseFile(source::FileId file) {
    SourceFile parsed{.file = file, .first = StatementId(program_.statements.size())};
    const std::vector<Token> tokens = Lex(sources_, file);
    for (size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].kind == TokenKind::kWord) ParseStatement(tokens, i);
    }
    parsed.count = program_.statements.size() - parsed.first.index;
    program_.files.push_back(parsed);
    program_.line_count += sources_.LineCount(file);
  }

  Program Take() { return std::move(program_); }

 private:
  void ParseStatement(const std::vector<Token>& tokens, size_t word) {
    const std::string_view text = sources_.Text(tokens[word].range);
    Statement statement{.instruction = InstructionByWord(text), .range = tokens[word].range};
    if (word + 1 < tokens.size() && tokens[word + 1].kind == TokenKind::kOperands) {
      statement.range.end = tokens[word + 1].range.end;
    }
    if (statement.instruction == Instruction::kUnsupported) {
      diagnostics_.Report(tokens[word].range, diag::@Name@Unsupported, text);
    }
    program_.statements.Add(statement);
  }

  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  Program program_;
};

}  // namespace

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, diag::Engine& diagnostics) {
  Parser parser(sources, diagnostics);
  for (const source::FileId file : files) parser.ParseFile(file);
  return parser.Take();
}

}  // namespace plcxx::@name@
