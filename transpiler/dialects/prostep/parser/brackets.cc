#include "transpiler/dialects/prostep/parser/brackets.h"

namespace plcxx::prostep {

void BracketChecker::BeginModule() {
  levels_.assign(1, {});
  forgiven_ = 0;
}

void BracketChecker::Instruction(Op op, source::Range range, std::string_view text) {
  Level& level = levels_.back();
  if (op == Op::kUnknown) {
    level.has_content = true;  // it may have been meant as some
    if (text.ends_with('(')) {
      Open(range, text);
      levels_.back().has_content = true;
      levels_.back().is_misspelt = true;
    }
    return;
  }
  switch (Info(op).role) {
    case Role::kLogic:
      level.has_content = true;
      if (op == Op::kOr || op == Op::kOrNot) level.in_string = false;
      return;
    case Role::kCompare:
      level.has_content = true;
      level.in_string = false;
      return;
    case Role::kString:
      level.in_string = true;
      return;
    case Role::kOpen:
      if (op == Op::kOpenOr) level.in_string = false;
      return Open(range, text);
    case Role::kClose:
      return Close(range);
    case Role::kNeutral:
      return;
    case Role::kJump:
    case Role::kEnds:
      return Outside(range, text);
  }
}

const BracketChecker::Level* BracketChecker::InnermostOpen() const {
  for (size_t i = levels_.size(); i-- > 1;) {
    if (!levels_[i].is_misspelt) return &levels_[i];
  }
  return nullptr;
}

void BracketChecker::Open(source::Range range, std::string_view text) {
  levels_.push_back({.open = range});
  forgiven_ = 0;
  // Those within the first one that is too deep have the same cause.
  if (levels_.size() - 1 == kBracketLevels + 1) diagnostics_.Report(range, diag::ProstepBracketTooDeep, text);
}

void BracketChecker::Close(source::Range range) {
  if (levels_.size() == 1) {
    if (forgiven_ == 0) {
      diagnostics_.Report(range, diag::ProstepBracketNotOpen);
    } else {
      --forgiven_;
    }
    levels_.back().has_content = true;
    return;
  }
  const Level closed = levels_.back();
  levels_.pop_back();
  if (!closed.has_content) {
    diagnostics_.Report(range, diag::ProstepBracketEmpty).notes.push_back({closed.open, "it was opened here"});
  }
  levels_.back().has_content = true;
}

void BracketChecker::Outside(source::Range range, std::string_view text) {
  if (const Level* open = InnermostOpen()) {
    diagnostics_.Report(range, diag::ProstepBracketNotClosed, text).notes.push_back({open->open, "it was opened here"});
  }
  if (levels_.size() > 1) {
    forgiven_ = levels_.size() - 1;
    levels_.resize(1);
  }
  levels_.back().in_string = false;
}

void BracketChecker::Label(std::string_view name, source::Range range) {
  if (const Level* open = InnermostOpen()) {
    diagnostics_.Report(range, diag::ProstepLabelInBracket, name)
        .notes.push_back({open->open, "the bracket was opened here"});
  } else if (levels_.back().in_string) {
    diagnostics_.Report(range, diag::ProstepLabelInString, name);
  }
}

void BracketChecker::EndModule(source::Range range, std::string_view text) { Outside(range, text); }

}  // namespace plcxx::prostep
