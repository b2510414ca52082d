#include "transpiler/ir/reader.h"

#include <cstdio>
#include <cstdlib>

#include "transpiler/ir/reader_state.h"

namespace plcxx::ir {
namespace {

void SplitLines(Reader& reader, std::string_view text) {
  uint32_t number = 0;
  while (!text.empty() && !reader.error) {
    ++number;
    const size_t end = std::min(text.find('\n'), text.size());
    std::optional<std::vector<text::Token>> tokens = text::Tokens(text.substr(0, end));
    if (!tokens) {
      reader.error = ReadError{number, "string without end, or with an unknown escape"};
    } else if (!tokens->empty()) {
      reader.lines.push_back({number, std::move(*tokens)});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// From a line that opens braces to the one that closes them.
void SkipBraces(Reader& reader) {
  int depth = 0;
  const size_t head = reader.line;
  for (; reader.line < reader.lines.size(); ++reader.line) {
    for (const text::Token& token : reader.lines[reader.line].tokens) {
      if (token.kind != text::TokenKind::kPunctuation) continue;
      depth += token.text == "{" ? 1 : token.text == "}" ? -1 : 0;
    }
    if (depth == 0) return;
  }
  reader.line = head;
  reader.Fail("'{' without '}'");
}

}  // namespace

void Reader::Fail(std::string message) {
  if (!error) error = ReadError{line < lines.size() ? lines[line].number : 0, std::move(message)};
}

bool Reader::Accept(std::string_view wanted) {
  if (AtEnd()) return false;
  const text::Token& next = lines[line].tokens[token];
  if (next.kind == text::TokenKind::kString || next.text != wanted) return false;
  ++token;
  return true;
}

void Reader::Expect(std::string_view wanted) {
  if (!Accept(wanted)) Fail(std::string("'").append(wanted) + "' expected");
}

void Reader::ExpectEnd() {
  if (!error && !AtEnd()) Fail(std::string("'").append(lines[line].tokens[token].text) + "' is too much on this line");
}

std::string Reader::Name() {
  if (error) return {};
  if (AtEnd() || lines[line].tokens[token].kind == text::TokenKind::kPunctuation) {
    Fail("name expected");
    return {};
  }
  return lines[line].tokens[token++].text;
}

bool Reader::AtString() const { return !AtEnd() && lines[line].tokens[token].kind == text::TokenKind::kString; }

uint64_t Reader::Number() {
  const std::string word = Name();
  const std::optional<uint64_t> value = text::Number(word);
  if (!value) Fail("number expected, found '" + word + "'");
  return value.value_or(0);
}

Type Reader::TypeName() {
  const std::string word = Name();
  for (const Type type : text::kTypes) {
    if (ir::Name(type) == word) return type;
  }
  Fail("type expected, found '" + word + "'");
  return Type::kNone;
}

size_t Reader::OneOf(std::span<const std::string_view> spellings, std::string_view what) {
  const std::string word = Name();
  for (size_t i = 0; i < spellings.size(); ++i) {
    if (spellings[i] == word) return i;
  }
  Fail(std::string(what) + " expected, found '" + word + "'");
  return 0;
}

std::variant<Program, ReadError> Read(std::string_view text) {
  Reader reader;
  SplitLines(reader, text);
  std::vector<size_t> schedule;  // names routines, which may stand further down
  for (; reader.line < reader.lines.size() && !reader.error; ++reader.line) {
    reader.token = 0;
    const std::string keyword = reader.Name();
    if (keyword == "schedule") {
      schedule.push_back(reader.line);
      continue;
    }
    const size_t head = reader.line;
    reader.ReadDeclaration(keyword);
    reader.ExpectEnd();
    if (keyword != "routine" || reader.error) continue;
    reader.bodies.emplace_back(RoutineId(reader.program.routines.size() - 1), head);
    SkipBraces(reader);
  }
  for (const size_t entry : schedule) {
    if (reader.error) break;
    reader.line = entry;
    reader.token = 1;
    reader.ReadScheduleEntry();
    reader.ExpectEnd();
  }
  for (const auto& [routine, head] : reader.bodies) {
    if (reader.error) break;
    reader.line = head + 1;
    reader.ReadBody(routine);
  }
  if (reader.error) return *reader.error;
  return std::move(reader.program);
}

Program ReadOrDie(std::string_view text) {
  std::variant<Program, ReadError> result = Read(text);
  if (const ReadError* error = std::get_if<ReadError>(&result)) {
    std::fprintf(stderr, "line %u: %s\n", error->line, error->message.c_str());
    std::abort();
  }
  return std::get<Program>(std::move(result));
}

}  // namespace plcxx::ir
