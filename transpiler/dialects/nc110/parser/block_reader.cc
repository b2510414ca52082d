#include "transpiler/dialects/nc110/parser/block_reader.h"

#include <algorithm>

#include "transpiler/support/near_words.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kMaxNesting = 9;

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

void BlockReader::ParseBlockHead(Item& item) {
  const Token& word = Take();
  CheckCase(word);
  ParseHead(item, word.range, KindOf(word.kind));
}

bool BlockReader::IsMisspeltHead() const {
  if (!At(TokenKind::kRun)) return false;
  return Peek(1).kind == TokenKind::kColon || (CanBeName(Peek(1).kind) && Peek(2).kind == TokenKind::kColon);
}

void BlockReader::ParseMisspeltHead(Item& item, const Token& word) {
  constexpr std::string_view kWords[] = {"DOF", "DOE", "ELSE"};
  const std::string capitals = Capitals(TextOf(word));
  const bool is_doe = capitals == "ELSE" || support::NearestWord(capitals, kWords) == "DOE";
  ParseHead(item, word.range, is_doe ? BlockKind::kDoe : BlockKind::kDof);
}

void BlockReader::ParseHead(Item& item, source::Range word, BlockKind kind) {
  Block block;
  block.kind = kind;
  block.keyword = word;
  block.head = ItemId(program_.items.size());
  block.level = static_cast<uint8_t>(std::min<size_t>(open_blocks_.size() + 1, 255));
  block.parent = open_blocks_.empty() ? BlockId() : open_blocks_.innermost();
  const BlockId id(program_.blocks.size());
  if (block.kind == BlockKind::kDow && !options_.enable_dow) {
    Fault(word, diag::Nc110DowDisabled, "DOW");
  }
  if (block.kind == BlockKind::kDoe) {
    LinkChain(id, block);
  }
  if (open_blocks_.size() == kMaxNesting) {
    Fault(word, diag::Nc110BlockNesting);
  }
  chain_ = BlockId();
  chain_unsure_ = false;
  PassSecondHeadWord();
  if (CanBeName(Peek().kind) && !LooksLikeTarget(0)) {
    block.name = open_blocks_.TakeName();
  }
  const source::Range colon = Peek().range;
  if (Require(TokenKind::kColon, "':'")) {
    ParseCondition(block, colon);
  } else {
    block.condition = ErrorExpr(word);
  }
  item.kind = ItemKind::kBlockHead;
  item.detail = program_.blocks.Add(block).index;
  open_blocks_.Open(id);
}

/// "DOF DOF : I0A0" is one block, as the colon shows.
void BlockReader::PassSecondHeadWord() {
  const TokenKind kind = Peek().kind;
  const bool is_head = kind == TokenKind::kDof || kind == TokenKind::kDoe || kind == TokenKind::kDow;
  const bool has_colon =
      Peek(1).kind == TokenKind::kColon || (CanBeName(Peek(1).kind) && Peek(2).kind == TokenKind::kColon);
  if (!is_head || Peek().first_on_line || !has_colon) return;
  Fault(Peek().range, diag::Nc110ExpectedHint, "':'", Found(),
        "one of DOF, DOE and DOW begins a head: delete the other");
  Take();
}

bool BlockReader::NoConditionHere() const {
  const Token& token = Peek();
  return token.first_on_line || token.kind == TokenKind::kEndOfFile || token.kind == TokenKind::kCycleMark ||
         token.kind == TokenKind::kMsg || IsBlockWord(token.kind) ||
         LooksLikeTarget(token.kind == TokenKind::kSlash ? 1 : 0);
}

void BlockReader::ParseCondition(Block& block, source::Range colon) {
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
  now_.primary_name = "condition";
  now_.in_condition = true;
  block.condition = expressions_.ParseExpression(Type::kSignal);
  const Expr& condition = program_.exprs[block.condition];
  if (condition.kind == ExprKind::kConstant) {
    Warn(condition.range, diag::Nc110ConstantCondition, HeadWord(block.kind));
  }
}

void BlockReader::LinkChain(BlockId id, Block& block) {
  if (!chain_.valid()) {
    const bool waits = !chain_unsure_ && !now_.failed && open_blocks_.KeepLoneDoe(block.keyword);
    if (waits) {
      now_.failed = true;
    } else if (!chain_unsure_) {
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

void BlockReader::PassItem(const Item& item) {
  chain_ = BlockId();
  chain_unsure_ = item.kind == ItemKind::kError;
}

void BlockReader::ParseBlockEnd(Item& item) {
  chain_ = BlockId();
  const Token& word = Take();
  CheckCase(word);
  BlockEnd end;
  end.kind = KindOf(word.kind);
  const TokenKind after_name = Peek(1).kind;
  if (CanBeName(Peek().kind) && !Peek().first_on_line && after_name != TokenKind::kAssign &&
      after_name != TokenKind::kOpenParenthesis) {
    end.name = open_blocks_.TakeName();
  }
  chain_unsure_ = false;
  const bool closes_loop = !open_blocks_.empty() && program_.blocks[open_blocks_.innermost()].kind == BlockKind::kDow;
  if (end.kind == BlockKind::kDow && !options_.enable_dow && !closes_loop) {
    Fault(word.range, diag::Nc110DowDisabled, "ENDW");
    chain_unsure_ = true;
  } else if (open_blocks_.empty()) {
    Fault(word.range, diag::Nc110EndWithoutBlock, EndWord(end.kind));
    chain_unsure_ = true;
  } else {
    open_blocks_.Close(end, word);
    chain_ = end.kind == BlockKind::kDow ? BlockId() : end.block;
  }
  item.kind = ItemKind::kBlockEnd;
  item.detail = program_.block_ends.Add(end).index;
}

}  // namespace plcxx::nc110
