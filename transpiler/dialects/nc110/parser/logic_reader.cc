#include "transpiler/dialects/nc110/parser/logic_reader.h"

#include <algorithm>

namespace plcxx::nc110 {

/// An operand in front of '=' inside of brackets is part of a comparison, unless it begins a line.
void LogicReader::SkipToNextItem(size_t item_begin) {
  for (;; Take()) {
    const Token& token = Peek();
    if (token.kind == TokenKind::kEndOfFile) {
      return;
    }
    if (now_.position == item_begin) {
      continue;
    }
    if (token.kind == TokenKind::kCycleMark || token.kind == TokenKind::kMsg || IsBlockWord(token.kind)) {
      return;
    }
    if (token.kind == TokenKind::kOpenBracket) {
      ++now_.open_brackets;
    } else if (token.kind == TokenKind::kCloseBracket && now_.open_brackets > 0) {
      --now_.open_brackets;
    }
    const bool target = LooksLikeTarget(token.kind == TokenKind::kSlash ? 1 : 0);
    if (target && (token.first_on_line || now_.open_brackets == 0)) {
      return;
    }
  }
}

void LogicReader::ParseCycleMark(Item& item) {
  const Token& mark = Take();
  item.kind = ItemKind::kCycleMark;
  if (program_.first_cycle_mark.valid()) {
    Warn(mark.range, diag::Nc110SecondCycleMark);
  } else {
    program_.first_cycle_mark = ItemId(program_.items.size());
  }
  open_blocks_.ReportAtMark(mark.range);
}

void LogicReader::ParseItem() {
  now_.failed = now_.panic = now_.in_condition = now_.extension_warned = false;
  now_.open_brackets = now_.parentheses = now_.operands = 0;
  now_.primary_name = "expression";
  const size_t begin = now_.position;
  Item item;
  const TokenKind kind = Peek().kind;
  const bool block_word = IsBlockWord(kind) || blocks_.IsMisspeltHead();
  bool stray = false;
  if (kind == TokenKind::kCycleMark) {
    ParseCycleMark(item);
  } else if (kind == TokenKind::kMsg) {
    messages_.ParseMessage(item);
  } else if (kind == TokenKind::kDof || kind == TokenKind::kDoe || kind == TokenKind::kDow) {
    blocks_.ParseBlockHead(item);
  } else if (IsBlockWord(kind)) {
    blocks_.ParseBlockEnd(item);
  } else if (blocks_.IsMisspeltHead()) {
    const Token& word = Peek();
    assignments_.ReadUnknown();
    blocks_.ParseMisspeltHead(item, word);
  } else if (AtOperand() || kind == TokenKind::kSlash) {
    assignments_.ParseAssignment(item);
  } else {
    assignments_.ReportNoStatement();
    stray = true;
  }
  if (!now_.panic && !Peek().first_on_line) {
    if (!AtItemStart() && !now_.failed) {
      assignments_.ReportNoStatement();
    }
    // What follows a fault on its line and is no target is a part of the faulty statement.
    now_.panic = now_.panic || (now_.failed && (!AtItemStart() || (AtOperand() && !LooksLikeTarget(0))));
  }
  if (now_.panic) {
    SkipToNextItem(begin);
  }
  if (stray) {
    blocks_.PassStray();
  } else if (!block_word) {
    blocks_.PassItem(item);
  }
  item.faulty = now_.failed;
  item.range = {now_.lexed.tokens[begin].range.begin, now_.lexed.tokens[now_.position - 1].range.end};
  comments_.AttachComments(item, Peek().range.begin);
  program_.statement_count += item.kind != ItemKind::kCycleMark && item.kind != ItemKind::kError;
  program_.items.Add(item);
}

void LogicReader::ParseLogicFile(source::FileId file, SourceFile& entry) {
  now_.file = &sources_.Get(file);
  now_.lexed =
      Lex(sources_, file, options_.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject, diagnostics_);
  now_.position = now_.next_comment = 0;
  now_.case_warned = now_.constant_warned = false;
  open_blocks_.ReportAcrossFiles();
  entry.items.first = program_.items.size();
  comments_.SplitOffHeader(entry);
  while (!At(TokenKind::kEndOfFile)) {
    ParseItem();
  }
  entry.items.count = program_.items.size() - entry.items.first;
  comments_.TakeRest(entry);
  if (entry.items.count == 0) {
    diagnostics_.Report({now_.file->base, now_.file->base}, diag::Nc110NoStatements);
  }
}

}  // namespace plcxx::nc110
