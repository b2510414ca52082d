#include "transpiler/dialects/prostep/parser/parser.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/prostep/parser/internal.h"

namespace plcxx::prostep {

void Parser::TakeFile(source::FileId file) {
  file_ = file;
  file_has_items_ = false;
  blank_line_before_ = false;
  program_.files.push_back({.file = file});
  const LexedFile lexed = Lex(sources_, file, diagnostics_);
  for (const Line& line : lexed.lines) TakeLine(lexed, line);
  EndOfFile();
  program_.line_count += static_cast<uint32_t>(lexed.lines.size());
}

void Parser::TakeLine(const LexedFile& lexed, const Line& line) {
  switch (line.kind) {
    case LineKind::kBlank:
      blank_line_before_ = true;
      return;
    case LineKind::kHeader:
      return;
    case LineKind::kComment:
      return AddComment(lexed.tokens[line.tokens.first].range, CommentPlace::kLeading);
    case LineKind::kDeclaration:
      return TakeDeclaration(lexed, line);
    case LineKind::kStatement:
      return TakeStatement(lexed, line);
  }
}

Parser::Statement Parser::Split(const LexedFile& lexed, const Line& line) const {
  Statement statement;
  bool behind_colon = false;
  for (uint32_t i = 0; i < line.tokens.count; ++i) {
    const Token& token = lexed.tokens[line.tokens.first + i];
    if (token.kind == TokenKind::kColon) {
      behind_colon = true;
      statement.range = {token.range.end, token.range.end};
    } else if (!behind_colon) {
      statement.labels.push_back(token);
    } else if (token.kind == TokenKind::kComment) {
      statement.comment = token;
    } else {
      if (statement.tokens.empty()) statement.range.begin = token.range.begin;
      statement.range.end = token.range.end;
      statement.tokens.push_back(token);
    }
  }
  return statement;
}

void Parser::TakeStatement(const LexedFile& lexed, const Line& line) {
  const Statement statement = Split(lexed, line);
  if (statement.tokens.empty()) return EmptyStatement(statement);
  const TokenKind first = statement.tokens.front().kind;
  if (first == TokenKind::kModuleMark) {
    FinishWaiting();
    const bool opens = ModuleMarkByName(UpperOf(statement.tokens.front())) == ModuleMark::kOpen;
    return opens ? OpenModule(statement) : CloseModule(statement);
  }
  if (!module_.valid()) return ReportOutside(statement);
  // Junk at the beginning is a 'K' that runs into a character which may not stand there.
  if (first == TokenKind::kClass || first == TokenKind::kJunk) return TakeOperandLine(statement);
  if (first == TokenKind::kUnknown && IsWrongOperand(statement)) return;
  FinishWaiting();
  TakeInstruction(statement);
}

/// A colon and nothing more, perhaps with a label or a comment.
void Parser::EmptyStatement(const Statement& statement) {
  if (!statement.labels.empty()) {
    if (!module_.valid()) return ReportOutside(statement);
    // Its label stands between an instruction and its operand lines: they are missing, but may still come.
    if (waiting_.found < waiting_.fewest && !waiting_.reported) {
      const Waiting before = waiting_;
      FinishWaiting();
      waiting_ = before;
      waiting_.reported = true;
    }
    if (const Token* label = TheLabel(statement)) DefineLabel(*label);
  }
  if (statement.has_comment()) AddComment(statement.comment.range, CommentPlace::kLeading);
  blank_line_before_ = false;
}

bool Parser::IsReported(const Statement& statement) const {
  const auto faulty = [](const Token& token) { return token.faulty; };
  return std::ranges::any_of(statement.labels, faulty) || std::ranges::any_of(statement.tokens, faulty);
}

void Parser::ReportOutside(const Statement& statement) {
  if (statement.has_comment()) AddComment(statement.comment.range, CommentPlace::kLeading);
  if (forgiving_ || IsReported(statement)) return;
  if (statement.labels.size() > 1) {  // a comment rather than an instruction
    TheLabel(statement);
    return;
  }
  if (statement.tokens.empty()) {
    const source::Range range = {statement.labels.front().range.begin, statement.labels.back().range.end};
    diagnostics_.Report(range, diag::ProstepOutside, sources_.Text(range));
    return;
  }
  const bool operand = statement.tokens.front().kind == TokenKind::kClass;
  const std::string text = operand ? OperandText(statement.tokens, 0) : std::string(sources_.Text(statement.range));
  diagnostics_.Report(statement.range, diag::ProstepOutside, text);
}

Program Parser::Finish() {
  program_.statement_count = program_.instructions.size();
  return std::move(program_);
}

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, diag::Engine& diagnostics) {
  Parser parser(sources, diagnostics);
  for (const source::FileId file : files) parser.TakeFile(file);
  return parser.Finish();
}

std::string ToText(const Program& program, const Instruction& instruction) {
  std::string text(Info(instruction.op).mnemonic);
  if (instruction.target.valid()) return text + " " + program.labels[instruction.target].name;
  if (instruction.operand.exists()) text += " " + ToText(instruction.operand);
  return text;
}

}  // namespace plcxx::prostep
