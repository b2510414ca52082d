#include "transpiler/dialects/nc110/parser/mux_reader.h"

namespace plcxx::nc110 {

constexpr size_t kMaxMuxInputs = 8;

MuxId MuxReader::ParseMux(Type target_type, source::Range target) {
  const Token& word = Take();
  CheckCase(word);
  if (target_type == Type::kSignal) {
    Fault(target, diag::Nc110MuxSignalTarget, Quoted(Plain(target)));
  }
  Mux mux;
  mux.range = word.range;
  std::vector<ExprId> words;
  std::vector<ExprId> selectors;
  if (!ParseMuxList(Type::kWord, words) || !Require(TokenKind::kComma, "','") ||
      !ParseMuxList(Type::kSignal, selectors)) {
    return program_.muxes.Add(mux);
  }
  mux.range.end = now_.lexed.tokens[now_.position - 1].range.end;
  if (words.size() > kMaxMuxInputs) {
    Fault(program_.exprs[words[kMaxMuxInputs]].range, diag::Nc110MuxTooMany);
  } else if (selectors.size() > kMaxMuxInputs) {
    Fault(program_.exprs[selectors[kMaxMuxInputs]].range, diag::Nc110MuxTooMany);
  } else if (words.size() != selectors.size()) {
    Fault(mux.range, diag::Nc110MuxCount, static_cast<diag::Number>(words.size()),
          static_cast<diag::Number>(selectors.size()));
  }
  const bool item_follows = At(TokenKind::kSlash) ? LooksLikeTarget(1) : AtItemStart();
  if (!item_follows) {
    HardFault(Peek().range, diag::Nc110MuxFollowed, Found());
  }
  if (!now_.failed) {
    mux.first = static_cast<uint32_t>(program_.mux_inputs.size());
    mux.count = static_cast<uint32_t>(words.size());
    for (size_t i = 0; i < words.size(); ++i) {
      program_.mux_inputs.push_back({words[i], selectors[i]});
    }
  }
  return program_.muxes.Add(mux);
}

bool MuxReader::ParseMuxList(Type type, std::vector<ExprId>& list) {
  if (!At(TokenKind::kOpenParenthesis)) {
    HardFault(MissingAt(), diag::Nc110MuxOpen, Found());
    return false;
  }
  do {
    Take();
    list.push_back(expressions_.ParseExpression(type));
    if (now_.panic) {
      return false;
    }
    CheckMuxInput(type, list.back());
  } while (At(TokenKind::kComma));
  if (At(TokenKind::kMinus)) {
    HardFault(Peek().range, diag::Nc110MinusOutside);
    return false;
  }
  if (!TakeIf(TokenKind::kCloseParenthesis)) {
    HardFault(MissingAt(), diag::Nc110MuxClose, Found());
    return false;
  }
  return true;
}

void MuxReader::CheckMuxInput(Type type, ExprId input) {
  const Expr* expr = &program_.exprs[input];
  if (type == Type::kSignal && expr->kind == ExprKind::kNot) {
    expr = &program_.exprs[expr->left];
  }
  const bool documented = expr->kind == ExprKind::kOperand || expr->kind == ExprKind::kError ||
                          (type == Type::kWord && expr->kind == ExprKind::kConstant);
  if (!documented && !std::exchange(now_.extension_warned, true)) {
    Warn(expr->range, diag::Nc110Extension, "an expression as an input of MUX");
  }
}

}  // namespace plcxx::nc110
