// Directives, TITLE, ALARMS, MCODES (specification 9).
#include <algorithm>

#include "transpiler/dialects/host50/parser/internal.h"

namespace plcxx::host50 {
namespace {

std::string InCapitals(std::string_view word) {
  std::string capitals(word);
  for (char& c : capitals) c = Upper(c);
  return capitals;
}

std::string_view Trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The severity that a text names before its first '-'; the text loses it.
std::optional<Severity> TakeSeverityPrefix(std::string& text) {
  const size_t dash = text.find('-');
  if (dash == std::string::npos) return std::nullopt;
  for (const SeverityInfo& row : Severities()) {
    if (Trim(std::string_view(text).substr(0, dash)) != row.prefix) continue;
    text = Trim(std::string_view(text).substr(dash + 1));
    return row.severity;
  }
  return std::nullopt;
}

std::optional<Severity> SeverityByName(std::string_view word) {
  for (const SeverityInfo& row : Severities()) {
    if (EqualIgnoringCase(row.keyword, word)) return row.severity;
  }
  return std::nullopt;
}

}  // namespace

void Parser::ReadDirectives() {
  for (const Place& place : directives_) {
    file_ = place.file;
    EnterFile(files_[file_]);
    ReadDirective(files_[file_].lines[place.line]);
  }
  ApplyOptions(options_, program_.settings);
}

void Parser::ReadDirective(const Line& line) {
  Begin(line);
  const std::string word = InCapitals(TextOf(Peek()));
  if (word == "OPTION") return ReadOption();
  const source::Range keyword = Peek().range;
  if (!given_directives_.insert(word).second) Fault(keyword, diag::Host50DirectiveTwice, word);
  ReadNumberDirective(word);
}

/// SLOWDIV n, CHANNELS c.
void Parser::ReadNumberDirective(std::string_view word) {
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
  if (failed_) return;
  (is_slowdiv ? program_.settings.slowdiv : program_.settings.channels) = static_cast<uint32_t>(value);
}

/// OPTION name = value.
void Parser::ReadOption() {
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
  if (!given_directives_.insert(key).second) Fault(name.range, diag::Host50DirectiveTwice, key);
  Take(), Take(), Take();
  ExpectEnd();
  if (!failed_) program_.settings = changed;
}

void Parser::ReadTables() {
  // A name, a text and a title are needed by nothing that stands in the same tables: one walk is enough.
  for (const Table& table : tables_) {
    file_ = table.file;
    EnterFile(files_[file_]);
    for (uint32_t i = table.first; i < table.last; ++i) {
      const Line& line = files_[file_].lines[i];
      if (line.kind != LineKind::kStatement || line.consumed) continue;
      Begin(line);
      if (FaultOfBadToken()) continue;
      if (table.part == PartKind::kTitle) ReadTitleRow(line);
      if (table.part == PartKind::kSymbols) ReadSymbolRow(line);
      if (table.part == PartKind::kAlarms) ReadAlarmRow(line);
      if (table.part == PartKind::kMCodes) ReadMCodeRow(line);
    }
  }
  if (program_.settings.predefined == PredefinedOption::kOn) AddPredefinedSymbols();
}

/// The string that ends a row.
std::string Parser::ReadLastString(std::string_view what) {
  if (!At(TokenKind::kString)) {
    FaultOfMissing(what);
    return {};
  }
  std::string text = StringOf(Take());
  ExpectEnd();
  return text;
}

void Parser::ReadTitleRow(const Line& line) {
  const Token word = Peek();
  const auto keys = TitleKeys();
  const auto row =
      std::ranges::find_if(keys, [&](const TitleKeyInfo& key) { return EqualIgnoringCase(key.name, TextOf(word)); });
  if (word.kind != TokenKind::kWord || row == keys.end()) {
    Fault(word.range, diag::Host50UnknownInstruction, TextOf(word));
    return;
  }
  if (!title_keys_.insert(row->key).second) Fault(word.range, diag::Host50DirectiveTwice, row->name);
  Take();
  TitleField field{.key = row->key, .text = ReadLastString("a text in double quotes"), .range = line.range};
  if (!failed_) program_.title.push_back(std::move(field));
}

void Parser::ReadAlarmRow(const Line& line) {
  const Token token = Peek();
  if (token.kind != TokenKind::kAddress) {
    Fault(token.range, diag::Host50AddressExpected, Found());
    return;
  }
  const AddressText address = ReadAddressText(TextOf(token), program_.settings.channels);
  const bool is_alarm = address.fault == AddressFault::kNone && address.address.area == Area::kQ &&
                        address.address.number >= kFirstAlarm && address.address.number < kFirstAlarm + kAlarmCount;
  if (address.fault != AddressFault::kNone && address.fault != AddressFault::kRange) {
    ResolveAddress(token);
  } else if (!is_alarm) {
    Fault(token.range, diag::Host50AlarmAddress, TextOf(token));
  }
  Take();
  Alarm alarm{.index = is_alarm ? address.address.number - kFirstAlarm : 0, .range = line.range};
  std::optional<Severity> severity;
  if (At(TokenKind::kWord)) {
    severity = SeverityByName(TextOf(Peek()));
    if (!severity) return FaultOfMissing("NOTICE, CAUTION, WARNING or a text in double quotes");
    Take();
  }
  alarm.text = ReadLastString("a text in double quotes");
  if (!severity) severity = TakeSeverityPrefix(alarm.text);
  alarm.severity = severity.value_or(Severity::kNotice);
  if (is_alarm && !alarms_.insert(alarm.index).second) {
    Fault(token.range, diag::Host50DuplicateAlarm, TextOf(token));
  }
  if (!failed_) program_.alarms.push_back(std::move(alarm));
}

void Parser::ReadMCodeRow(const Line& line) {
  const Token token = Peek();
  if (token.kind != TokenKind::kInteger || !IsDigit(TextOf(token).front())) {
    return FaultOfMissing("the number of an M code");
  }
  const int64_t value = IntegerOf(token, TextOf(token)).value;
  if (value > kGreatestMCode) Fault(token.range, diag::Host50MCodeRange, TextOf(token));
  Take();
  MCode code{
      .number = static_cast<uint32_t>(value), .text = ReadLastString("a text in double quotes"), .range = line.range};
  if (!failed_ && !mcodes_.insert(code.number).second) Fault(token.range, diag::Host50DuplicateMCode, value);
  if (!failed_) program_.mcodes.push_back(std::move(code));
}

}  // namespace plcxx::host50
