// Blocks: heads, ends, names, chains, nesting.
#include <algorithm>

#include "transpiler/dialects/nc110/parser/internal.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kMaxNesting = 9;
constexpr size_t kMaxName = 128;
constexpr size_t kSignificantName = 6;

std::string_view HeadWord(BlockKind kind) {
  switch (kind) {
    case BlockKind::kDof:
      return "DOF";
    case BlockKind::kDoe:
      return "DOE";
    case BlockKind::kDow:
      return "DOW";
  }
  PLCXX_UNREACHABLE();
}

std::string_view EndWord(BlockKind kind) {
  switch (kind) {
    case BlockKind::kDof:
      return "ENDF";
    case BlockKind::kDoe:
      return "ENDE";
    case BlockKind::kDow:
      return "ENDW";
  }
  PLCXX_UNREACHABLE();
}

BlockKind KindOf(TokenKind word) {
  if (word == TokenKind::kDof || word == TokenKind::kEndf) {
    return BlockKind::kDof;
  }
  return word == TokenKind::kDoe || word == TokenKind::kEnde ? BlockKind::kDoe : BlockKind::kDow;
}

bool CanBeName(TokenKind kind) {
  return kind == TokenKind::kOperand || kind == TokenKind::kRun || kind == TokenKind::kNumber;
}

}  // namespace

std::string_view Parser::BlockName(source::Range range) const {
  const auto mapped = mapped_names_.find(range.begin);
  return mapped != mapped_names_.end() ? std::string_view(mapped->second) : sources_.Text(range);
}

bool Parser::SameName(source::Range a, source::Range b) const {
  return BlockName(a).substr(0, kSignificantName) == BlockName(b).substr(0, kSignificantName);
}

source::Range Parser::TakeBlockName() {
  const Token& token = Take();
  if (token.mapped) {
    mapped_names_[token.range.begin] = TextOf(token);
  }
  if (TextOf(token).size() > kMaxName) {
    Fault(token.range, diag::Nc110BlockNameTooLong, static_cast<diag::Number>(TextOf(token).size()));
  }
  return token.range;
}

void Parser::ParseBlockHead(Item& item) {
  const Token& word = Take();
  CheckCase(word);
  Block block;
  block.kind = KindOf(word.kind);
  block.keyword = word.range;
  block.head = ItemId(program_.items.size());
  block.level = static_cast<uint8_t>(std::min<size_t>(open_blocks_.size() + 1, 255));
  block.parent = open_blocks_.empty() ? BlockId() : open_blocks_.back().block;
  const BlockId id(program_.blocks.size());
  if (block.kind == BlockKind::kDow && !options_.enable_dow) {
    Fault(word.range, diag::Nc110DowDisabled, "DOW");
  }
  if (block.kind == BlockKind::kDoe) {
    LinkChain(id, block);
  }
  if (open_blocks_.size() == kMaxNesting) {
    Fault(word.range, diag::Nc110BlockNesting);
  }
  chain_ = BlockId();
  chain_unsure_ = false;
  if (CanBeName(Peek().kind) && !LooksLikeTarget(0)) {
    block.name = TakeBlockName();
  }
  const source::Range colon = Peek().range;
  if (Require(TokenKind::kColon, "':'")) {
    ParseCondition(block, colon);
  } else {
    block.condition = ErrorExpr(word.range);
  }
  item.kind = ItemKind::kBlockHead;
  item.detail = program_.blocks.Add(block).index;
  open_blocks_.push_back({id});
}

bool Parser::NoConditionHere() const {
  const Token& token = Peek();
  return token.first_on_line || token.kind == TokenKind::kEndOfFile || token.kind == TokenKind::kCycleMark ||
         token.kind == TokenKind::kMsg || IsBlockWord(token.kind) ||
         LooksLikeTarget(token.kind == TokenKind::kSlash ? 1 : 0);
}

void Parser::ParseCondition(Block& block, source::Range colon) {
  if (NoConditionHere()) {
    if (block.kind == BlockKind::kDoe) {
      return;
    }
    Fault(colon, diag::Nc110ConditionExpected, HeadWord(block.kind));
    const bool on_next_line = Peek().first_on_line && !LooksLikeTarget(At(TokenKind::kSlash) ? 1 : 0) &&
                              (AtOperand() || At(TokenKind::kOpenParenthesis) || At(TokenKind::kOpenBracket) ||
                               At(TokenKind::kSlash) || At(TokenKind::kFunction) || At(TokenKind::kAscii));
    if (!on_next_line) {
      block.condition = ErrorExpr(colon);
      return;
    }
  }
  primary_name_ = "condition";
  in_condition_ = true;
  block.condition = ParseExpression(Type::kSignal);
  const Expr& condition = program_.exprs[block.condition];
  if (condition.kind == ExprKind::kConstant) {
    Warn(condition.range, diag::Nc110ConstantCondition, HeadWord(block.kind));
  }
}

void Parser::LinkChain(BlockId id, Block& block) {
  if (!chain_.valid()) {
    if (!chain_unsure_) {
      Fault(block.keyword, diag::Nc110DoeWithoutDof);
    }
    return;
  }
  Block& previous = program_.blocks[chain_];
  previous.next = id;
  block.previous = chain_;
  block.unreachable = previous.unreachable || (previous.kind == BlockKind::kDoe && !previous.condition.valid());
  if (block.unreachable) {
    Warn(block.keyword, diag::Nc110UnreachableDoe);
  }
}

void Parser::ParseBlockEnd(Item& item) {
  const Token& word = Take();
  CheckCase(word);
  BlockEnd end;
  end.kind = KindOf(word.kind);
  const TokenKind after_name = Peek(1).kind;
  if (CanBeName(Peek().kind) && !Peek().first_on_line && after_name != TokenKind::kAssign &&
      after_name != TokenKind::kOpenParenthesis) {
    end.name = TakeBlockName();
  }
  chain_unsure_ = false;
  const bool closes_loop = !open_blocks_.empty() && program_.blocks[open_blocks_.back().block].kind == BlockKind::kDow;
  if (end.kind == BlockKind::kDow && !options_.enable_dow && !closes_loop) {
    Fault(word.range, diag::Nc110DowDisabled, "ENDW");
    chain_unsure_ = true;
  } else if (open_blocks_.empty()) {
    Fault(word.range, diag::Nc110EndWithoutBlock, EndWord(end.kind));
    chain_unsure_ = true;
  } else {
    CloseBlock(end, word);
  }
  item.kind = ItemKind::kBlockEnd;
  item.detail = program_.block_ends.Add(end).index;
}

void Parser::CloseBlock(BlockEnd& end, const Token& word) {
  const Block& innermost = program_.blocks[open_blocks_.back().block];
  if (innermost.kind != end.kind) {
    Fault(word.range, diag::Nc110BlockKind, EndWord(end.kind), HeadWord(innermost.kind))
        .notes.push_back({innermost.keyword, "the block begins here"});
  }
  CheckEndName(end);
  end.block = open_blocks_.back().block;
  if (const source::Range lone = open_blocks_.back().lone_end; lone.begin != 0) {
    const std::string text(sources_.Text(lone));
    diagnostics_.Report(lone, diag::Nc110UnknownIdentifierCause, text, CauseOfUnknown(text));
  }
  open_blocks_.pop_back();
  program_.blocks[end.block].end = ItemId(program_.items.size());
  chain_ = end.kind == BlockKind::kDow ? BlockId() : end.block;
}

/// A wrong name may mean that ends are missing: then the blocks in between are closed too, without more messages.
void Parser::CheckEndName(const BlockEnd& end) {
  if (end.name.begin == end.name.end) {
    return;
  }
  const Block& innermost = program_.blocks[open_blocks_.back().block];
  const std::string_view name = BlockName(end.name);
  const bool named = innermost.name.begin != innermost.name.end;
  if (named && SameName(innermost.name, end.name)) {
    if (BlockName(innermost.name) != name) {
      Warn(end.name, diag::Nc110BlockNameTail, name, BlockName(innermost.name));
    }
    return;
  }
  const std::string expected =
      named ? "the open block is " + Quoted(BlockName(innermost.name)) : "the open block has no name";
  Fault(end.name, diag::Nc110BlockName, EndWord(end.kind), name, expected)
      .notes.push_back({innermost.keyword, "the open block begins here"});
  for (size_t depth = open_blocks_.size(); depth-- > 0;) {
    const Block& outer = program_.blocks[open_blocks_[depth].block];
    if (outer.name.begin != outer.name.end && SameName(outer.name, end.name) && outer.kind == end.kind) {
      open_blocks_.resize(depth + 1);
      return;
    }
  }
}

/// END alone, or ENDIF: where its block is not closed otherwise, that is one fault with the missing end.
bool Parser::IsMeantEnd(std::string_view run, source::Range range) {
  const std::string capitals = Capitals(run);
  if (failed_ || open_blocks_.empty() || (capitals != "END" && capitals != "ENDIF")) {
    return false;
  }
  OpenBlock& open = open_blocks_.back();
  if (open.reported || open.lone_end.begin != 0) {
    return false;
  }
  open.lone_end = range;
  return true;
}

namespace {

void NoteLoneEnd(source::Range lone_end, diag::Diagnostic& report) {
  if (lone_end.begin != 0) {
    report.notes.push_back({lone_end, "this is no end of a block: its letter F, E or W is missing"});
  }
}

}  // namespace

void Parser::ReportOpenBlocksAtMark(source::Range mark) {
  for (OpenBlock& open : open_blocks_) {
    if (!std::exchange(open.reported, true)) {
      const Block& block = program_.blocks[open.block];
      diag::Diagnostic& report =
          diagnostics_.Report(block.keyword, diag::Nc110BlockCycleMark, HeadWord(block.kind), EndWord(block.kind));
      report.notes.push_back({mark, "'$' stands here"});
      NoteLoneEnd(open.lone_end, report);
    }
  }
}

void Parser::ReportOpenBlocksAtEnd() {
  for (const OpenBlock& open : open_blocks_) {
    if (!open.reported) {
      const Block& block = program_.blocks[open.block];
      NoteLoneEnd(open.lone_end,
                  diagnostics_.Report(block.keyword, diag::Nc110BlockOpen, HeadWord(block.kind), EndWord(block.kind)));
    }
  }
}

}  // namespace plcxx::nc110
