#include "transpiler/dialects/technol/parser/parsing_context.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/macros.h"
#include "transpiler/support/near_words.h"

namespace plcxx::technol {
namespace {

/// FFFFh: digits of a hexadecimal number that begins with a letter.
bool IsHexadecimal(std::string_view name) {
  if (name.size() < 2 || (name.back() != 'H' && name.back() != 'h')) return false;
  name.remove_suffix(1);
  return std::ranges::all_of(name,
                             [](char c) { return IsDigit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f'); });
}

/// 0FFh for OFFh: the number that was typed with letters O in place of zeros; empty when it is none.
std::string WithZeros(std::string_view name) {
  if (name.empty() || (name.front() != 'O' && name.front() != 'o')) return {};
  std::string number(name);
  std::ranges::replace_if(number, [](char c) { return c == 'O' || c == 'o'; }, '0');
  const bool decimal = std::ranges::all_of(number, IsDigit);
  return decimal || IsHexadecimal(number) ? number : std::string();
}

}  // namespace

void ParsingContext::ReportUndefined(std::string_view name, source::Range range) {
  if (IsExcused(name)) return Forgive();
  if (faulty) return;
  if (!undefined_.insert(names.Fold(name)).second) return Forgive();
  const SymbolId symbol = names.Find(name);
  if (symbol.valid()) {
    Report(range, diag::TechnolUndefinedYet, name).notes.push_back({names[symbol].range, "it is defined here"});
  } else if (IsHexadecimal(name)) {
    Report(range, diag::TechnolUndefinedHexadecimal, name);
  } else if (const std::string number = WithZeros(name); !number.empty()) {
    Report(range, diag::TechnolUndefinedNear, name, number);
  } else if (const std::string near = NearName(name); !near.empty()) {
    Report(range, diag::TechnolUndefinedNear, name, near);
  } else {
    Report(range, diag::TechnolUndefined, name);
  }
}

/// Only so many times: each looks at all names.
std::string ParsingContext::NearName(std::string_view name) {
  constexpr uint32_t kMostSearches = 50;
  if (++near_searches_ > kMostSearches) return {};
  const std::string folded = names.Fold(name);
  for (const bool of_source : {true, false}) {  // the control's names are many: the program's own come first
    std::vector<std::string> spelled;
    for (const Symbol& symbol : program.symbols) {
      if ((symbol.origin == SymbolOrigin::kSource) == of_source) spelled.push_back(names.Fold(symbol.name));
    }
    const std::vector<std::string_view> words(spelled.begin(), spelled.end());
    const std::string_view near = support::NearestWord(folded, words);
    if (!near.empty()) return program.symbols[names.Find(near)].name;
  }
  return {};
}

bool ParsingContext::IsShort(const Token& token) {
  const std::string_view name = WrittenName(token.text);
  if (name.size() <= kNameLength) return true;
  if (too_long_.insert(names.Fold(name)).second) {
    Report(token.range, diag::TechnolNameTooLong, name, static_cast<int64_t>(name.size()));
  }
  Forgive();
  return false;
}

bool ParsingContext::IsName(const Token& token) {
  if (!IsShort(token)) return false;
  if (token.text == "?") {
    Report(token.range, diag::TechnolSyntax, "'?'", "a name");
    return false;
  }
  if (IsReserved(Upper(token.text))) {
    ReportReserved(token, {});
    return false;
  }
  return true;
}

void ParsingContext::ReportReserved(const Token& token, std::string_view behind) {
  const std::string word = Upper(token.text);
  const bool takes_point = word == "CNST" || word == "BYTE" || word == "WORD" || word == "DWRD";
  if (word == "DWORD" && !behind.empty()) {
    Report(token.range, diag::TechnolReservedMeant, token.text, "the prefix of 32 bits is DWRD");
  } else if (takes_point && !behind.empty()) {
    Report(token.range, diag::TechnolReservedMeant, token.text, "write " + word + "." + std::string(behind));
  } else if (word == "NOT" && !behind.empty()) {
    Report(token.range, diag::TechnolReservedMeant, token.text,
           "write -" + std::string(behind) + " for the negated bit");
  } else if (!reserved_.insert(word).second) {
    Forgive();
  } else if (word == "START") {
    Report(token.range, diag::TechnolReservedMeant, token.text,
           "START is another word for DATA_END: choose another name");
  } else if (RegisterByName(word) != Register::kNone) {
    Report(token.range, diag::TechnolReservedMeant, token.text, word + " is a register: choose another name");
  } else if (OpByMnemonic(word) != Op::kUnknown) {
    Report(token.range, diag::TechnolReservedMeant, token.text, word + " is an instruction: choose another name");
  } else {
    Report(token.range, diag::TechnolReserved, token.text);
  }
}

bool ParsingContext::IsTaken(const Token& name) {
  const SymbolId taken = names.Find(name.text);
  if (!taken.valid()) return false;
  Symbol& symbol = names[taken];
  if (symbol.origin != SymbolOrigin::kSource) {
    Report(name.range, diag::TechnolPredefined, name.text);
  } else {
    Report(name.range, diag::TechnolAlreadyDefined, name.text)
        .notes.push_back({symbol.range, "it is defined here as " + std::string(KindText(symbol))});
  }
  symbol.faulty |= symbol.origin == SymbolOrigin::kSource;  // nobody knows which of the two its uses mean
  return true;
}

SymbolId ParsingContext::Define(const Token& name, Symbol symbol) {
  if (!IsName(name) || IsTaken(name)) return {};
  symbol.name = name.text;
  symbol.range = name.range;
  return names.Add(std::move(symbol), statement);
}

std::string Shown(const Token* token) {
  if (token == nullptr || token->kind == TokenKind::kComment) return "the end of the line";
  if (token->kind == TokenKind::kString || token->kind == TokenKind::kQuoted) return std::string(token->text);
  return "'" + std::string(token->text) + "'";
}

}  // namespace plcxx::technol
