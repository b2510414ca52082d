// Declarations (specification section 9): a mnemonic in column 1 and a number.
#include <algorithm>

#include "transpiler/dialects/prostep/source/lexer_internal.h"

namespace plcxx::prostep {

void LineLexer::Declaration(std::string_view word) {
  Take(TokenKind::kDeclaration, word.size());
  SkipBlanks();
  if (word == "DM" || word == "DT") return TextBehindDot();
  Number();
  if (word == "DMF") {
    Switches();
  } else {
    DataValue();
  }
  Comment();
}

void LineLexer::DataValue() {
  SkipBlanks();
  if (!AtRest()) Number();
}

void LineLexer::Switches() {
  for (SkipBlanks(); !AtRest(); SkipBlanks()) {
    size_t end = RunEnd(at_);
    const std::string run = Upper(text_.substr(at_, end - at_));
    if (run == "S" || run == "D") {
      const size_t number = text_.find_first_not_of(" \t", end);
      if (number != std::string_view::npos && IsDigit(text_[number])) end = RunEnd(number);
    }
    Take(TokenKind::kSwitch, end);
  }
}

void LineLexer::TextBehindDot() {
  Take(TokenKind::kNumber, std::min(text_.find_first_not_of("0123456789", at_), text_.size()));
  SkipBlanks();
  if (AtEnd()) return;
  if (text_[at_] != '.') return Whole(TokenKind::kJunk);
  ++at_;
  Take(TokenKind::kText, std::max(at_, text_.find_last_not_of(" \t") + 1));
}

}  // namespace plcxx::prostep
