#include "transpiler/dialects/nc110/parser/parser.h"

#include <algorithm>

#include "transpiler/dialects/nc110/parser/internal.h"

namespace plcxx::nc110 {

constexpr size_t kMaxFiles = 10;

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

const Token& Parser::Take() {
  const Token& token = Peek();
  if (position_ + 1 < lexed_.tokens.size()) {
    ++position_;
  }
  failed_ = failed_ || token.faulty;
  return token;
}

bool Parser::TakeIf(TokenKind kind) {
  if (!At(kind)) {
    return false;
  }
  Take();
  return true;
}

std::string_view Parser::TextOf(const Token& token) const {
  if (token.mapped) {
    return lexed_.mapped.at(token.range.begin);
  }
  return std::string_view(file_->text).substr(token.range.begin - file_->base, token.range.end - token.range.begin);
}

std::string Parser::Found() const {
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

source::Range Parser::MissingAt() const {
  const Token& token = Peek();
  // Section 10.2: the line of the offending token, also when that begins the next line. The end of the file has none.
  if (position_ == 0 || token.kind != TokenKind::kEndOfFile) {
    return token.range;
  }
  return BehindPrevious();
}

source::Range Parser::BehindPrevious() const {
  const source::Offset end = lexed_.tokens[position_ - 1].range.end;
  return {end, end};
}

void Parser::CheckCase(const Token& token) {
  if (!token.lower_case || token.faulty) {
    return;
  }
  if (options_.strict_case) {
    Fault(token.range, diag::Nc110LowerCaseRejected, TextOf(token));
  } else if (!std::exchange(case_warned_, true)) {
    diagnostics_.Report(token.range, diag::Nc110LowerCase, TextOf(token), Capitals(TextOf(token)));
  }
}

ExprId Parser::Expected(std::string_view what) {
  failed_ = failed_ || At(TokenKind::kBad);  // its character has been reported
  return HardFault(MissingAt(), diag::Nc110Expected, what, Found());
}

bool Parser::Require(TokenKind kind, std::string_view what) {
  if (panic_) {
    return false;
  }
  if (TakeIf(kind)) {
    return true;
  }
  if (kind == TokenKind::kAssign && At(TokenKind::kColon)) {
    HardFault(MissingAt(), diag::Nc110ExpectedHint, what, Found(), "assign with '=' alone");
  } else if (kind == TokenKind::kColon) {
    failed_ = failed_ || At(TokenKind::kBad);  // its character has been reported
    HardFault(MissingAt(), diag::Nc110ExpectedHint, what, Found(),
              "a head is DOF, DOE or DOW, its name if any, a colon and the condition: DOF LAMP: I0A0");
  } else {
    Expected(what);
  }
  return false;
}

bool Parser::LooksLikeTarget(size_t ahead) const {
  const Token& token = Peek(ahead);
  const TokenKind next = Peek(ahead + 1).kind;
  if (token.kind == TokenKind::kRun) return next == TokenKind::kAssign;
  const bool is_named = token.kind == TokenKind::kOperand || token.kind == TokenKind::kSymbol;
  return is_named && (next == TokenKind::kAssign || next == TokenKind::kOpenParenthesis);
}

bool Parser::AtItemStart() const {
  constexpr TokenKind kStarts[] = {TokenKind::kEndOfFile, TokenKind::kCycleMark, TokenKind::kMsg,
                                   TokenKind::kOperand,   TokenKind::kSymbol,    TokenKind::kRun,
                                   TokenKind::kSlash,     TokenKind::kEnd,       TokenKind::kBad};
  return std::ranges::find(kStarts, Peek().kind) != std::end(kStarts) || IsBlockWord(Peek().kind);
}

/// After a fault. An operand in front of '=' inside of brackets is part of a comparison, unless it begins a line.
void Parser::SkipToNextItem(size_t item_begin) {
  for (;; Take()) {
    const Token& token = Peek();
    if (token.kind == TokenKind::kEndOfFile) {
      return;
    }
    if (position_ == item_begin) {
      continue;
    }
    if (token.kind == TokenKind::kCycleMark || token.kind == TokenKind::kMsg || IsBlockWord(token.kind)) {
      return;
    }
    if (token.kind == TokenKind::kOpenBracket) {
      ++open_brackets_;
    } else if (token.kind == TokenKind::kCloseBracket && open_brackets_ > 0) {
      --open_brackets_;
    }
    const bool target = LooksLikeTarget(token.kind == TokenKind::kSlash ? 1 : 0);
    if (target && (token.first_on_line || open_brackets_ == 0)) {
      return;
    }
  }
}

/// A token that begins nothing.
void Parser::ReportNoStatement() {
  const Token& token = Peek();
  panic_ = true;
  if (token.kind == TokenKind::kBad) {
    failed_ = true;
    return;
  }
  if (token.kind == TokenKind::kMinus) {
    Fault(token.range, diag::Nc110MinusOutside);
    return;
  }
  if (token.kind == TokenKind::kFunction) {
    ParseFunction(token.function == Function::kSgn ? Type::kWord : Type::kSignal);
    panic_ = true;
    return;
  }
  if (token.kind == TokenKind::kEnd) {
    FaultOfUnknown(TextOf(token), token.range);
    return;
  }
  if (token.kind == TokenKind::kNumber && !Evaluate(TextOf(token)).well_formed) {
    ReportMalformedNumber(token);
    return;
  }
  const TokenKind next = Peek(1).kind;
  const bool second_slash = position_ > 0 && lexed_.tokens[position_ - 1].kind == TokenKind::kSlash;
  const bool comment = (token.kind == TokenKind::kSlash && (second_slash || next == TokenKind::kSlash)) ||
                       (token.kind == TokenKind::kOpenParenthesis && next == TokenKind::kStar) ||
                       (token.kind == TokenKind::kSlash && next == TokenKind::kStar);
  if (comment) {
    Fault(token.range, diag::Nc110StatementExpectedHint, Found(), "a comment begins with ';' and ends with its line");
  } else {
    Fault(token.range, diag::Nc110StatementExpected, Found());
  }
}

void Parser::ParseCycleMark(Item& item) {
  const Token& mark = Take();
  item.kind = ItemKind::kCycleMark;
  if (program_.first_cycle_mark.valid()) {
    Warn(mark.range, diag::Nc110SecondCycleMark);
  } else {
    program_.first_cycle_mark = ItemId(program_.items.size());
  }
  ReportOpenBlocksAtMark(mark.range);
}

void Parser::ParseItem() {
  failed_ = panic_ = in_condition_ = extension_warned_ = false;
  open_brackets_ = parentheses_ = operands_ = 0;
  primary_name_ = "expression";
  const size_t begin = position_;
  Item item;
  const TokenKind kind = Peek().kind;
  const bool block_word = IsBlockWord(kind);
  const BlockId chain_before = chain_;
  if (!(kind == TokenKind::kDoe)) {
    chain_ = BlockId();
  }
  if (kind == TokenKind::kCycleMark) {
    ParseCycleMark(item);
  } else if (kind == TokenKind::kMsg) {
    ParseMessage(item);
  } else if (kind == TokenKind::kDof || kind == TokenKind::kDoe || kind == TokenKind::kDow) {
    ParseBlockHead(item);
  } else if (block_word) {
    ParseBlockEnd(item);
  } else if (AtOperand() || kind == TokenKind::kSlash) {
    ParseAssignment(item);
  } else {
    ReportNoStatement();
    chain_ = chain_before;
  }
  if (!panic_ && !Peek().first_on_line) {
    if (!AtItemStart() && !failed_) {
      ReportNoStatement();
    }
    // What follows a fault on its line and is no target is a part of the faulty statement.
    panic_ = panic_ || (failed_ && (!AtItemStart() || (AtOperand() && !LooksLikeTarget(0))));
  }
  if (panic_) {
    SkipToNextItem(begin);
  }
  if (!block_word) {
    chain_unsure_ = item.kind == ItemKind::kError;
  }
  item.faulty = failed_;
  item.range = {lexed_.tokens[begin].range.begin, lexed_.tokens[position_ - 1].range.end};
  AttachComments(item, Peek().range.begin);
  program_.statement_count += item.kind != ItemKind::kCycleMark && item.kind != ItemKind::kError;
  program_.items.Add(item);
}

void Parser::ParseLogicFile(source::FileId file) {
  file_ = &sources_.Get(file);
  lexed_ = Lex(sources_, file, options_.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject, diagnostics_);
  position_ = next_comment_ = 0;
  case_warned_ = constant_warned_ = false;
  logic_file_seen_ = true;
  for (OpenBlock& open : open_blocks_) {
    if (!std::exchange(open.continued, true) && !open.reported) {
      const Block& block = program_.blocks[open.block];
      diagnostics_.Report(block.keyword, diag::Nc110BlockAcrossFiles, Plain(block.keyword));
    }
  }
  SourceFile& entry = program_.files.back();
  entry.items.first = program_.items.size();
  SplitOffHeader(entry);
  while (!At(TokenKind::kEndOfFile)) {
    ParseItem();
  }
  entry.items.count = program_.items.size() - entry.items.first;
  entry.rest.first = static_cast<uint32_t>(program_.comments.size());
  for (; next_comment_ < lexed_.comments.size(); ++next_comment_) {
    program_.comments.push_back(lexed_.comments[next_comment_]);
    program_.comments.back().place = CommentPlace::kRest;
  }
  entry.rest.count = static_cast<uint32_t>(program_.comments.size()) - entry.rest.first;
  if (entry.items.count == 0) {
    diagnostics_.Report({file_->base, file_->base}, diag::Nc110NoStatements);
  }
}

Program Parser::Run(std::span<const source::FileId> files) {
  if (files.size() > kMaxFiles) {
    const source::Offset base = sources_.Get(files[kMaxFiles]).base;
    diagnostics_.Report({base, base}, diag::Nc110SourceCount, static_cast<diag::Number>(files.size()));
    return std::move(program_);
  }
  size_t bytes = 0;
  for (const source::FileId file : files) {
    bytes += sources_.Get(file).text.size();
  }
  // Typical programs have one expression node per 6 bytes and one statement per 30.
  program_.exprs.Reserve(bytes / 6);
  program_.items.Reserve(bytes / 30);
  program_.assignments.Reserve(bytes / 30);
  for (const source::FileId file : files) {
    SourceFile entry;
    entry.file = file;
    entry.is_symbol_file = sources_.Get(file).text.starts_with('*');
    entry.line_count = sources_.LineCount(file);
    program_.line_count += entry.line_count;
    program_.files.push_back(entry);
    if (entry.is_symbol_file) {
      ParseSymbolFile(file);
    } else {
      ParseLogicFile(file);
    }
  }
  ReportOpenBlocksAtEnd();
  ReportProgramWarnings();
  return std::move(program_);
}

void Parser::ReportProgramWarnings() {
  const SourceFile* first = nullptr;
  bool empty_reported = false;
  for (const SourceFile& file : program_.files) {
    if (!file.is_symbol_file) {
      first = first == nullptr ? &file : first;
      empty_reported = empty_reported || file.items.count == 0;
    }
  }
  if (first == nullptr) {
    return;
  }
  const source::Offset base = sources_.Get(first->file).base;
  if (program_.statement_count == 0) {
    if (!empty_reported) {
      diagnostics_.Report({base, base}, diag::Nc110NoStatements);
    }
  } else if (!program_.first_cycle_mark.valid()) {
    diagnostics_.Report({base, base}, diag::Nc110NoCycleMark);
  }
}

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const ParseOptions& options,
              diag::Engine& diagnostics) {
  return Parser(sources, options, diagnostics).Run(files);
}

}  // namespace plcxx::nc110
