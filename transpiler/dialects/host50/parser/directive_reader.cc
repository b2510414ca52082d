#include "transpiler/dialects/host50/parser/directive_reader.h"

namespace plcxx::host50 {
namespace {

std::string InCapitals(std::string_view word) {
  std::string capitals(word);
  for (char& c : capitals) c = Upper(c);
  return capitals;
}

}  // namespace

void DirectiveReader::ReadDirectives(std::span<const DirectiveLine> directives) {
  for (const DirectiveLine& place : directives) {
    EnterFile(place.file);
    ReadDirective(files_[place.file].lines[place.line]);
  }
}

void DirectiveReader::ReadDirective(const Line& line) {
  Begin(line);
  const std::string word = InCapitals(TextOf(Peek()));
  if (word == "OPTION") return ReadOption();
  const source::Range keyword = Peek().range;
  if (!given_.insert(word).second) Fault(keyword, diag::Host50DirectiveTwice, word);
  ReadNumberDirective(word);
}

/// SLOWDIV n, CHANNELS c.
void DirectiveReader::ReadNumberDirective(std::string_view word) {
  Take();
  const bool is_slowdiv = word == "SLOWDIV";
  const uint32_t most = is_slowdiv ? kMostSlowdiv : kMostChannels;
  const Token token = Peek();
  const bool plain = token.kind == TokenKind::kInteger && IsDigit(TextOf(token).front());
  const int64_t value = plain ? IntegerOf(token, TextOf(token)).value : 0;
  if (value < 1 || value > most) {
    if (!FaultOfBadToken()) {
      const std::string found = At(TokenKind::kEnd) ? "without a number" : std::string(TextOf(token));
      Fault(token.range, is_slowdiv ? diag::Host50Slowdiv : diag::Host50Channels, found);
    }
    return;
  }
  Take();
  ExpectEnd();
  if (now_.failed) return;
  (is_slowdiv ? program_.settings.slowdiv : program_.settings.channels) = static_cast<uint32_t>(value);
}

/// OPTION name = value.
void DirectiveReader::ReadOption() {
  Take();
  const Token name = Peek();
  const bool formed = name.kind == TokenKind::kWord && Peek(1).kind == TokenKind::kEquals &&
                      (Peek(2).kind == TokenKind::kWord || Peek(2).kind == TokenKind::kInteger);
  if (!formed) {
    while (Peek().kind == TokenKind::kWord || Peek().kind == TokenKind::kEquals) Take();
    if (!FaultOfBadToken()) Fault(Peek().range, diag::Host50OptionForm, Found());
    return;
  }
  const Token value = Peek(2);
  Settings changed = program_.settings;
  switch (ApplyOption(TextOf(name), TextOf(value), changed)) {
    case OptionFault::kName:
      Fault(name.range, diag::Host50OptionName, TextOf(name), ExpectedOption(TextOf(name)));
      return;
    case OptionFault::kValue:
      Fault(value.range, diag::Host50OptionValue, TextOf(name), TextOf(value), ExpectedOption(TextOf(name)));
      return;
    case OptionFault::kNone:
      break;
  }
  const std::string key = "option " + InCapitals(TextOf(name));
  if (!given_.insert(key).second) Fault(name.range, diag::Host50DirectiveTwice, key);
  Take(), Take(), Take();
  ExpectEnd();
  if (!now_.failed) program_.settings = changed;
}

}  // namespace plcxx::host50
