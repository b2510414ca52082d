#include "transpiler/dialects/prostep/parser/file_reader.h"

#include <algorithm>

namespace plcxx::prostep {

void FileReader::TakeFile(source::FileId file) {
  now_.file = file;
  comments_.BeginFile();
  program_.files.push_back({.file = file});
  const LexedFile lexed = Lex(sources_, file, diagnostics_);
  for (const Line& line : lexed.lines) TakeLine(lexed, line);
  lines_.FinishWaiting();
  modules_.EndFile();
  program_.line_count += static_cast<uint32_t>(lexed.lines.size());
}

void FileReader::TakeLine(const LexedFile& lexed, const Line& line) {
  switch (line.kind) {
    case LineKind::kBlank:
      comments_.SetBlankLineBefore(true);
      return;
    case LineKind::kHeader:
      return;
    case LineKind::kComment:
      return comments_.AddComment(lexed.tokens[line.tokens.first].range, CommentPlace::kLeading);
    case LineKind::kDeclaration:
      return declarations_.TakeDeclaration(lexed, line);
    case LineKind::kStatement:
      return TakeStatement(lexed, line);
  }
}

Statement FileReader::Split(const LexedFile& lexed, const Line& line) const {
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

void FileReader::TakeStatement(const LexedFile& lexed, const Line& line) {
  const Statement statement = Split(lexed, line);
  if (statement.tokens.empty()) return EmptyStatement(statement);
  const TokenKind first = statement.tokens.front().kind;
  if (first == TokenKind::kModuleMark) {
    lines_.FinishWaiting();
    const bool opens = ModuleMarkByName(UpperOf(statement.tokens.front())) == ModuleMark::kOpen;
    return opens ? modules_.OpenModule(statement) : modules_.CloseModule(statement);
  }
  if (!now_.module.valid()) return ReportOutside(statement);
  // Junk at the beginning is a 'K' that runs into a character which may not stand there.
  if (first == TokenKind::kClass || first == TokenKind::kJunk) return lines_.TakeOperandLine(statement);
  if (first == TokenKind::kUnknown && lines_.IsWrongOperand(statement)) return;
  lines_.FinishWaiting();
  instructions_.TakeInstruction(statement);
}

void FileReader::EmptyStatement(const Statement& statement) {
  if (!statement.labels.empty()) {
    if (!now_.module.valid()) return ReportOutside(statement);
    // Its label stands between an instruction and its operand lines: they are missing, but may still come.
    if (now_.waiting.found < now_.waiting.fewest && !now_.waiting.reported) {
      const Waiting before = now_.waiting;
      lines_.FinishWaiting();
      now_.waiting = before;
      now_.waiting.reported = true;
    }
    if (const Token* label = labels_.TheLabel(statement)) labels_.DefineLabel(*label);
  }
  if (statement.has_comment()) comments_.AddComment(statement.comment.range, CommentPlace::kLeading);
  comments_.SetBlankLineBefore(false);
}

void FileReader::ReportOutside(const Statement& statement) {
  if (statement.has_comment()) comments_.AddComment(statement.comment.range, CommentPlace::kLeading);
  if (modules_.is_forgiving() || IsReported(statement)) return;
  if (statement.labels.size() > 1) {  // a comment rather than an instruction
    labels_.TheLabel(statement);
    return;
  }
  modules_.BeginOutside();
  if (statement.tokens.empty()) {
    const source::Range range = {statement.labels.front().range.begin, statement.labels.back().range.end};
    diagnostics_.Report(range, diag::ProstepOutside, sources_.Text(range));
    return;
  }
  const bool operand = statement.tokens.front().kind == TokenKind::kClass;
  const std::string text =
      operand ? operands_.OperandText(statement.tokens, 0) : std::string(sources_.Text(statement.range));
  const std::string text_of_message =
      statement.labels.empty() ? std::string() : UpperOf(statement.labels.front()).substr(0, 2);
  if (text_of_message == "DM" || text_of_message == "DT") {
    diagnostics_.Report(statement.range, diag::ProstepOutsideHint, text,
                        "a text begins with a dot and not with a colon: " + text_of_message + " 1 .TEXT");
    return;
  }
  if (UpperOf(statement.tokens.front()).starts_with("MOD")) {
    diagnostics_.Report(statement.range, diag::ProstepOutsideHint, text, "a blank is behind the mnemonic: MOD PM");
    return;
  }
  diagnostics_.Report(statement.range, diag::ProstepOutside, text);
}

}  // namespace plcxx::prostep
