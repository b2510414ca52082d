#include "transpiler/dialects/host50/parser/symbol_reader.h"

#include <algorithm>
#include <vector>

#include "transpiler/dialects/host50/machine/signals.h"
#include "transpiler/source/characters.h"
#include "transpiler/support/near_words.h"

namespace plcxx::host50 {
namespace {

/// The name between the apostrophes, and the attribute after them.
struct QuotedName {
  std::string_view name;
  std::string_view attribute;
};
QuotedName SplitQuoted(std::string_view text) {
  const size_t close = text.find('\'', 1);
  return {text.substr(1, close - 1), close + 1 < text.size() ? text.substr(close + 2) : std::string_view()};
}

}  // namespace

void SymbolReader::ReadSymbolRow(const Line& line) {
  const Token token = Peek();
  Symbol symbol{.range = line.range};
  bool bare = false;
  if (token.kind == TokenKind::kAddress) {
    const Resolved resolved = ResolveAddress(token);
    symbol.address = resolved.address;
    bare = resolved.ok && resolved.address.attribute == Attribute::kNone;
    if (resolved.ok && !bare) Fault(token.range, diag::Host50AddressAttribute, TextOf(token));
  } else {
    Fault(token.range, diag::Host50AddressExpected, Found());
  }
  Take();
  if (token.kind == TokenKind::kWord && At(TokenKind::kAddress)) {  // the other way round: the name is known
    poisoned_names_.insert(std::string(TextOf(token)));
    Take();
  }
  if (At(TokenKind::kWord) || At(TokenKind::kQuotedSymbol)) {
    const Token name = Take();
    const std::string_view text = TextOf(name);
    const QuotedName quoted = name.kind == TokenKind::kWord ? QuotedName{text, {}} : SplitQuoted(text);
    if (!quoted.attribute.empty())
      Fault(name.range, diag::Host50SurplusOperand, "'." + std::string(quoted.attribute) + "'");
    symbol.name = quoted.name;
    symbol.name_range = name.range;
  }
  if (At(TokenKind::kString)) {
    symbol.comment_range = Peek().range;
    symbol.comment = StringOf(Take());
  }
  ExpectEnd();
  const bool address_is_new = !bare || named_addresses_.emplace(symbol.address.area, symbol.address.number).second;
  if (!address_is_new) Fault(token.range, diag::Host50DuplicateSymbolAddress, ToText(symbol.address));
  if (!symbol.name.empty() && names_.contains(symbol.name)) {
    Fault(symbol.name_range, diag::Host50DuplicateSymbol, symbol.name);
    return;
  }
  if (!bare) {  // its uses are not reported again
    if (!symbol.name.empty()) poisoned_names_.insert(symbol.name);
    return;
  }
  const std::string name = symbol.name;
  const SymbolId id = program_.symbols.Add(std::move(symbol));
  if (!name.empty()) names_.emplace(name, id);
}

void SymbolReader::AddPredefinedSymbols() {
  for (const Signal& signal : Signals()) {
    if (names_.contains(signal.name) || poisoned_names_.contains(signal.name)) continue;
    names_.emplace(
        signal.name,
        program_.symbols.Add(
            {.name = signal.name, .address = signal.address, .comment = signal.meaning, .predefined = true}));
  }
}

SymbolId SymbolReader::SymbolNamed(std::string_view name) {
  const auto found = names_.find(name);
  return found == names_.end() ? SymbolId() : found->second;
}

std::string SymbolReader::RangesText(Area area) const { return RangesOf(area, program_.settings.channels); }

SymbolReader::Resolved SymbolReader::ReadAddress() {
  const Token token = Take();
  if (token.kind == TokenKind::kAddress) return ResolveAddress(token);
  const std::string_view text = TextOf(token);
  if (token.kind == TokenKind::kQuotedSymbol) {
    const QuotedName quoted = SplitQuoted(text);
    return ResolveName(token, quoted.name, quoted.attribute);
  }
  // The whole word is a symbol, or what stands before its last '.' is one with an attribute.
  const size_t dot = text.rfind('.');
  const bool has_attribute = dot != std::string_view::npos && dot > 0 && !SymbolNamed(text).valid() &&
                             AttributeByName(text.substr(dot + 1)) != Attribute::kNone;
  if (has_attribute) {
    const std::string_view name = text.substr(0, dot);
    const SymbolId symbol = SymbolNamed(name);
    const Type type = symbol.valid() ? Info(program_.symbols[symbol].address.area).type : Type::kUnknown;
    if (type == Type::kTimer || type == Type::kCounter || poisoned_names_.contains(name)) {
      return ResolveName(token, name, text.substr(dot + 1));
    }
  }
  return ResolveName(token, text, {});
}

/// A full-width sign right after an address is read as a part of it.
void SymbolReader::FaultOfAddressNumber(const Token& token) {
  const std::string_view text = TextOf(token);
  for (size_t at = 0; at < text.size();) {
    const source::CodePoint point = source::FirstCodePoint(text.substr(at));
    if (const char narrow = NarrowOf(point.value); narrow != '\0') {
      const source::Offset begin = token.range.begin + static_cast<source::Offset>(at);
      const std::string replacement(1, narrow);
      Fault(token.range, diag::Host50AddressWide, text, text.substr(at, point.length), replacement)
          .fixits.push_back({{begin, begin + point.length}, replacement});
      return;
    }
    at += point.length;
  }
  Fault(token.range, diag::Host50AddressNumber, text);
}

SymbolReader::Resolved SymbolReader::ResolveAddress(const Token& token) {
  const std::string_view text = TextOf(token);
  const AddressText address = ReadAddressText(text, program_.settings.channels);
  switch (address.fault) {
    case AddressFault::kNone:
      return {.ok = true, .address = address.address};
    case AddressFault::kArea:
      Fault(token.range, diag::Host50AddressArea, text);
      break;
    case AddressFault::kNumber:
      FaultOfAddressNumber(token);
      break;
    case AddressFault::kAttribute:
      if (IsDigit(text.back())) {
        Fault(token.range, diag::Host50AddressBit, text);
      } else {
        Fault(token.range, diag::Host50AddressAttribute, text);
      }
      break;
    case AddressFault::kRange:
      Fault(token.range, diag::Host50AddressRange, text, "%" + std::string(Info(address.area).name),
            RangesText(address.area));
      break;
  }
  return {};
}

/// I0 for %I0.
bool SymbolReader::IsAddressWithoutSign(std::string_view name) const {
  return ReadAddressText("%" + std::string(name), program_.settings.channels).fault == AddressFault::kNone;
}

/// In an expression `axis4-` is the name axis4 and a minus: the symbol that the text from here on spells, if one does.
std::string SymbolReader::SymbolWithSign(const Token& token) {
  constexpr size_t kLongest = 64;
  const std::string_view line =
      std::string_view(now_.source->text).substr(token.range.begin - now_.source->base, kLongest);
  for (size_t length = std::min(line.find_first_of(" \t,;'\"\r\n"), line.size()); length > 0; --length) {
    const std::string_view candidate = line.substr(0, length);
    const bool sign = candidate.find_first_of("+-/.#") != std::string_view::npos;
    if (sign && SymbolNamed(candidate).valid()) return std::string(candidate);
  }
  return {};
}

/// Only so many are compared with all symbols.
void SymbolReader::FaultOfUnknownName(const Token& token, std::string_view name) {
  constexpr uint32_t kMostSearches = 50;
  if (EqualIgnoringCase(name, "NOT")) {
    Fault(token.range, diag::Host50NotInOperand, name);
    return;
  }
  const size_t behind = token.range.end - now_.source->base;
  const size_t hash = name.find('#');
  const bool has_hash =
      hash != std::string_view::npos || (behind < now_.source->text.size() && now_.source->text[behind] == '#');
  const std::string_view kind = name.substr(0, hash);
  if (has_hash && (EqualIgnoringCase(kind, "T") || EqualIgnoringCase(kind, "TIME"))) {
    Fault(token.range, diag::Host50UnknownSymbolForeign, name,
          "a time is a number in the unit of its timer: TONS %TM0, 30 waits for 30 seconds");
    return;
  }
  std::vector<std::string_view> names;
  if (++near_searches_ <= kMostSearches) {
    for (const Symbol& symbol : program_.symbols) names.push_back(symbol.name);
  }
  const std::string_view near = support::NearestName(name, names);
  if (near.empty()) {
    Fault(token.range, diag::Host50UnknownSymbol, name);
  } else {
    Fault(token.range, diag::Host50UnknownSymbolNear, name, near);
  }
}

SymbolReader::Resolved SymbolReader::ResolveName(const Token& token, std::string_view name,
                                                 std::string_view attribute) {
  if (poisoned_names_.contains(name)) {
    now_.failed = program_.faulty = true;  // reported where it is defined
    return {};
  }
  const SymbolId symbol = SymbolNamed(name);
  if (!symbol.valid()) {
    const std::string quoted = SymbolWithSign(token);
    if (quoted.empty() && IsAddressWithoutSign(name)) {
      Fault(token.range, diag::Host50UnknownSymbolAddress, name);
    } else if (quoted.empty()) {
      FaultOfUnknownName(token, name);
    } else {
      Fault(token.range, diag::Host50UnknownSymbolQuoted, name, quoted);
    }
    return {};
  }
  Resolved resolved{.ok = true, .address = program_.symbols[symbol].address, .symbol = symbol};
  if (attribute.empty()) return resolved;
  const Type type = Info(resolved.address.area).type;
  resolved.address.attribute = AttributeByName(attribute);
  if ((type != Type::kTimer && type != Type::kCounter) || resolved.address.attribute == Attribute::kNone) {
    Fault(token.range, diag::Host50AddressAttribute, TextOf(token));
    return {};
  }
  return resolved;
}

}  // namespace plcxx::host50
