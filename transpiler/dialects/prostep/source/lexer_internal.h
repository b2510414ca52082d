// One line of a prostep source to tokens. Shared by the files of the lexer only.
#pragma once

#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {

class LineLexer {
 public:
  /// `text` is the line without its end, `begin` its place; tokens are added to `tokens`.
  LineLexer(std::string_view text, source::Offset begin, const source::File& file, std::vector<Token>& tokens,
            diag::Engine& diagnostics)
      : text_(text), begin_(begin), file_(file), tokens_(tokens), diagnostics_(diagnostics) {}

  /// The whole line without blanks at its ends.
  void Whole(TokenKind kind);
  void Declaration(std::string_view word);
  /// A line with a colon.
  void Statement();

 private:
  // lexer_statements.cc
  void WordsBeforeColon(size_t colon);
  void InstructionOrOperand();
  void Word();
  bool TakeBracket(size_t word_end);
  bool IsOperandLine(std::string_view word, size_t word_end) const;
  void OperandBehind(std::string_view mnemonic);
  void Operand();
  void Target();
  void Number();
  void Comment();

  // lexer_declarations.cc
  void DataValue();
  void Switches();
  void TextBehindDot();

  bool AtEnd() const { return at_ >= text_.size(); }
  /// Nothing more than a marked comment.
  bool AtRest() const { return AtEnd() || text_[at_] == ';' || text_[at_] == '*'; }
  void SkipBlanks();
  std::string_view Rest() const { return text_.substr(at_); }
  size_t LettersEnd(size_t from) const;
  /// The end of what no blank, ';' or '*' interrupts.
  size_t RunEnd(size_t from) const;
  /// [at_, end) as a token; at_ moves after it. Reports what may not stand in it.
  void Take(TokenKind kind, size_t end);
  /// Characters that may stand in texts and comments only.
  bool ReportCharacters(size_t begin, size_t end);
  bool ReportControlCharacters(size_t begin, size_t end);
  source::Range RangeOf(size_t begin, size_t end) const;

  std::string_view text_;
  source::Offset begin_;
  const source::File& file_;
  std::vector<Token>& tokens_;
  diag::Engine& diagnostics_;
  size_t at_ = 0;
};

/// Is it an instruction with its operand and nothing more, but without the colon?
bool LooksLikeInstruction(std::string_view text);

}  // namespace plcxx::prostep
