#include "transpiler/dialects/nc110/parser/item_reader.h"

#include <algorithm>

namespace plcxx::nc110 {

constexpr uint32_t kMaxParentheses = 32;

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

const Token& ItemReader::Take() {
  const Token& token = Peek();
  if (now_.position + 1 < now_.lexed.tokens.size()) {
    ++now_.position;
  }
  now_.failed = now_.failed || token.faulty;
  return token;
}

bool ItemReader::TakeIf(TokenKind kind) {
  if (!At(kind)) {
    return false;
  }
  Take();
  return true;
}

std::string_view ItemReader::TextOf(const Token& token) const {
  if (token.mapped) {
    return now_.lexed.mapped.at(token.range.begin);
  }
  return std::string_view(now_.file->text)
      .substr(token.range.begin - now_.file->base, token.range.end - token.range.begin);
}

std::string ItemReader::Found() const {
  const Token& token = Peek();
  if (token.kind == TokenKind::kEndOfFile) {
    return "the end of the file";
  }
  constexpr size_t kLongest = 40;
  const std::string_view text = TextOf(token);
  const std::string quoted =
      Quoted(text.size() > kLongest ? std::string(text.substr(0, kLongest)) + "..." : std::string(text));
  return quoted;
}

source::Range ItemReader::MissingAt() const {
  const Token& token = Peek();
  // Section 10.2: the line of the offending token, also when that begins the next line. The end of the file has none.
  if (now_.position == 0 || token.kind != TokenKind::kEndOfFile) {
    return token.range;
  }
  return BehindPrevious();
}

source::Range ItemReader::BehindPrevious() const {
  const source::Offset end = now_.lexed.tokens[now_.position - 1].range.end;
  return {end, end};
}

void ItemReader::CheckCase(const Token& token) {
  if (!token.lower_case || token.faulty) {
    return;
  }
  if (options_.strict_case) {
    Fault(token.range, diag::Nc110LowerCaseRejected, TextOf(token));
  } else if (!std::exchange(now_.case_warned, true)) {
    diagnostics_.Report(token.range, diag::Nc110LowerCase, TextOf(token), Capitals(TextOf(token)));
  }
}

ExprId ItemReader::Expected(std::string_view what) {
  now_.failed = now_.failed || At(TokenKind::kBad);  // its character has been reported
  const bool doubled =
      At(TokenKind::kAssign) && now_.position > 0 && now_.lexed.tokens[now_.position - 1].kind == TokenKind::kAssign;
  if (doubled) return HardFault(MissingAt(), diag::Nc110ExpectedHint, what, Found(), "assign with '=' alone");
  return HardFault(MissingAt(), diag::Nc110Expected, what, Found());
}

bool ItemReader::Require(TokenKind kind, std::string_view what) {
  if (now_.panic) {
    return false;
  }
  if (TakeIf(kind)) {
    return true;
  }
  if (kind == TokenKind::kAssign && At(TokenKind::kColon)) {
    HardFault(MissingAt(), diag::Nc110ExpectedHint, what, Found(), "assign with '=' alone");
  } else if (kind == TokenKind::kColon) {
    now_.failed = now_.failed || At(TokenKind::kBad);  // its character has been reported
    HardFault(MissingAt(), diag::Nc110ExpectedHint, what, Found(),
              "a head is DOF, DOE or DOW, its name if any, a colon and the condition: DOF LAMP: I0A0");
  } else {
    Expected(what);
  }
  return false;
}

bool ItemReader::EnterParenthesis(source::Range range) {
  if (++now_.parentheses > kMaxParentheses) {
    HardFault(range, diag::Nc110TooDeep);
    return false;
  }
  return true;
}

bool ItemReader::LooksLikeTarget(size_t ahead) const {
  const Token& token = Peek(ahead);
  const TokenKind next = Peek(ahead + 1).kind;
  if (token.kind == TokenKind::kRun) return next == TokenKind::kAssign;
  const bool is_named = token.kind == TokenKind::kOperand || token.kind == TokenKind::kSymbol;
  return is_named && (next == TokenKind::kAssign || next == TokenKind::kOpenParenthesis);
}

bool ItemReader::AtItemStart() const {
  constexpr TokenKind kStarts[] = {TokenKind::kEndOfFile, TokenKind::kCycleMark, TokenKind::kMsg,
                                   TokenKind::kOperand,   TokenKind::kSymbol,    TokenKind::kRun,
                                   TokenKind::kSlash,     TokenKind::kEnd,       TokenKind::kBad};
  return std::ranges::find(kStarts, Peek().kind) != std::end(kStarts) || IsBlockWord(Peek().kind);
}

ExprId ItemReader::ErrorExpr(source::Range range) {
  Expr expr;
  expr.range = range;
  return program_.exprs.Add(expr);
}

}  // namespace plcxx::nc110
