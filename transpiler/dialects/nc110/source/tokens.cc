#include "transpiler/dialects/nc110/source/tokens.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

namespace plcxx::nc110 {
namespace {

constexpr std::string_view kFunctionNames[] = {
#define PLCXX_WORD_FUNCTION(Kind, NameText, ...) NameText,
#include "transpiler/dialects/nc110/machine/functions.def"
    "SGN", "MUX"};

bool Same(std::string_view run, std::string_view capitals) {
  if (run.size() != capitals.size()) {
    return false;
  }
  for (size_t i = 0; i < run.size(); ++i) {
    if (Upper(run[i]) != capitals[i]) {
      return false;
    }
  }
  return true;
}

/// Reads a run from left to right by the fields of an operand.
class FieldReader {
 public:
  explicit FieldReader(std::string_view run) : run_(run) {}

  bool Digits(size_t max_digits, uint32_t& value) {
    const size_t begin = position_;
    value = 0;
    while (position_ < run_.size() && IsDigit(run_[position_])) {
      value = value * 10 + static_cast<uint32_t>(run_[position_++] - '0');
      if (position_ - begin > max_digits) {
        return false;
      }
    }
    return position_ > begin;
  }
  char Letter() { return position_ < run_.size() ? Upper(run_[position_++]) : '\0'; }
  bool AtEnd() const { return position_ == run_.size(); }

 private:
  std::string_view run_;
  size_t position_ = 1;
};

bool ToPackage(char letter, Package& package) {
  switch (letter) {
    case 'A':
      package = Package::kA;
      return true;
    case 'K':
      package = Package::kK;
      return true;
    case 'N':
      package = Package::kN;
      return true;
    case 'T':
      package = Package::kT;
      return true;
    default:
      return false;
  }
}

Decoded DecodeMemory(OperandKind kind, FieldReader fields) {
  Decoded result;
  uint32_t connector = 0;
  uint32_t index = 0;
  if (!fields.Digits(3, connector) || !ToPackage(fields.Letter(), result.operand.package)) {
    return result;
  }
  const bool word = kind == OperandKind::kWord;
  if (fields.AtEnd()) {
    result.fault = word ? OperandFault::kWordIndexMissing : OperandFault::kBitMissing;
    return result;
  }
  if (!fields.Digits(2, index) || !fields.AtEnd()) {
    return result;
  }
  result.operand.kind = kind;
  result.operand.number = static_cast<uint16_t>(connector);
  result.operand.index = static_cast<uint8_t>(index);
  if (connector > ConnectorLimit(result.operand.package)) {
    result.fault = OperandFault::kConnector;
    result.found = connector;
  } else if (index > (word ? 3u : 31u)) {
    result.fault = word ? OperandFault::kWordIndex : OperandFault::kBit;
    result.found = index;
  } else {
    result.fault = OperandFault::kNone;
  }
  return result;
}

OperandKind TimerSignal(char letter) {
  switch (letter) {
    case 'I':
      return OperandKind::kTimerInput;
    case 'A':
      return OperandKind::kTimerHold;
    case 'U':
      return OperandKind::kTimerElapsed;
    case 'D':
      return OperandKind::kTimerRunning;
    default:
      return OperandKind::kNone;
  }
}

OperandKind CounterSignal(char letter) {
  switch (letter) {
    case 'I':
      return OperandKind::kCounterInput;
    case 'R':
      return OperandKind::kCounterCarry;
    case 'Z':
      return OperandKind::kCounterReset;
    case 'A':
      return OperandKind::kCounterDown;
    case 'W':
      return OperandKind::kCounterValue;
    default:
      return OperandKind::kNone;
  }
}

Decoded DecodeNumbered(OperandKind kind, uint32_t number, uint32_t limit, OperandFault fault) {
  Decoded result;
  if (kind != OperandKind::kNone) {
    result.operand.kind = kind;
    result.operand.number = static_cast<uint16_t>(number);
    result.fault = number > limit ? fault : OperandFault::kNone;
    result.found = number;
  }
  return result;
}

bool IsHexDigit(char c) { return IsDigit(c) || (Upper(c) >= 'A' && Upper(c) <= 'F'); }

uint32_t DigitValue(char c) { return static_cast<uint32_t>(IsDigit(c) ? c - '0' : Upper(c) - 'A' + 10); }

}  // namespace

std::string_view Name(TokenKind kind) {
  constexpr std::string_view kNames[] = {
#define NC110_TOKEN(Key, Printed, ...) Printed,
#include "transpiler/dialects/nc110/source/tokens.def"
  };
  return kNames[static_cast<size_t>(kind)];
}

std::string_view Name(Function function) { return kFunctionNames[static_cast<size_t>(function)]; }

ExprKind ExprKindOf(Function function) {
  switch (function) {
#define PLCXX_WORD_FUNCTION(Kind, ...) \
  case Function::k##Kind:              \
    return ExprKind::k##Kind;
#include "transpiler/dialects/nc110/machine/functions.def"
    case Function::kSgn:
      return ExprKind::kSgn;
    case Function::kMux:
      break;
  }
  PLCXX_UNREACHABLE();
}

Word Classify(std::string_view run) {
  if (IsDigit(run[0])) {
    return {TokenKind::kNumber};
  }
  if (run.size() == 3) {
    for (size_t i = 0; i < std::size(kFunctionNames); ++i) {
      if (Same(run, kFunctionNames[i])) {
        return {TokenKind::kFunction, static_cast<Function>(i)};
      }
    }
  }
  struct Keyword {
    std::string_view name;
    TokenKind kind;
  };
  constexpr Keyword kKeywords[] = {
#define NC110_KEYWORD(Key, Text) {Text, TokenKind::k##Key},
#include "transpiler/dialects/nc110/source/tokens.def"
  };
  for (const Keyword& keyword : kKeywords) {
    if (Same(run, keyword.name)) {
      return {keyword.kind};
    }
  }
  const OperandFault fault = Decode(run).fault;
  const bool shaped =
      fault != OperandFault::kUnknown && fault != OperandFault::kBitMissing && fault != OperandFault::kWordIndexMissing;
  return {shaped ? TokenKind::kOperand : TokenKind::kRun};
}

bool IsBlockWord(TokenKind kind) { return kind >= TokenKind::kDof && kind <= TokenKind::kEndw; }

bool IsKeyword(TokenKind kind) { return kind >= TokenKind::kFunction && kind <= TokenKind::kMsg; }

Decoded Decode(std::string_view run) {
  FieldReader fields(run);
  uint32_t number = 0;
  switch (Upper(run[0])) {
    case 'I':
      return DecodeMemory(OperandKind::kInput, fields);
    case 'U':
      return DecodeMemory(OperandKind::kOutput, fields);
    case 'W':
      return DecodeMemory(OperandKind::kWord, fields);
    case 'T':
      if (fields.Digits(3, number)) {
        const OperandKind kind = TimerSignal(fields.Letter());
        if (fields.AtEnd()) {
          return DecodeNumbered(kind, number, 254, OperandFault::kTimer);
        }
      }
      return {};
    case 'C':
      if (fields.Digits(3, number)) {
        const OperandKind kind = CounterSignal(fields.Letter());
        if (fields.AtEnd()) {
          return DecodeNumbered(kind, number, 99, OperandFault::kCounter);
        }
      }
      return {};
    case 'P':
      if (fields.Digits(3, number) && fields.AtEnd()) {
        return DecodeNumbered(OperandKind::kOneShot, number, 99, OperandFault::kOneShot);
      }
      return {};
    default:
      return {};
  }
}

uint32_t ConnectorLimit(Package package) {
  switch (package) {
    case Package::kA:
      return 31;
    case Package::kK:
    case Package::kN:
      return 255;
    case Package::kT:
      return 15;
  }
  PLCXX_UNREACHABLE();
}

Number Evaluate(std::string_view run) {
  constexpr uint32_t kSaturated = 1'000'000;
  uint32_t base = 10;
  std::string_view digits = run;
  const char last = Upper(run.back());
  if (last == 'H' || last == 'O' || last == 'D') {
    digits.remove_suffix(1);
    base = last == 'H' ? 16 : last == 'O' ? 8 : 10;
  }
  Number result;
  if (digits.empty()) {
    return result;
  }
  for (const char c : digits) {
    if (!IsHexDigit(c) || DigitValue(c) >= base) {
      return result;
    }
    result.value = result.value * base + DigitValue(c);
    result.value = result.value > kSaturated ? kSaturated : result.value;
  }
  result.well_formed = true;
  return result;
}

std::string LookAlike(std::string_view run) {
  constexpr size_t kLongestOperand = 8;
  if (run.size() > kLongestOperand) {
    return {};
  }
  std::string best;
  int best_changes = 100;
  for (uint32_t choice = 1; choice < (1u << run.size()); ++choice) {
    std::string candidate(run);
    bool changed_all = true;
    for (size_t i = 0; i < run.size() && changed_all; ++i) {
      if ((choice >> i & 1) == 0) {
        continue;
      }
      switch (Upper(run[i])) {
        case 'O':
          candidate[i] = '0';
          break;
        case '0':
          candidate[i] = 'O';
          break;
        case 'I':
          candidate[i] = '1';
          break;
        case '1':
          candidate[i] = 'I';
          break;
        default:
          changed_all = false;
      }
    }
    const int changes = std::popcount(choice);
    if (!changed_all || changes >= best_changes || !IsLetter(candidate[0])) {
      continue;
    }
    if (IsBlockWord(Classify(candidate).kind) || Decode(candidate).fault == OperandFault::kNone) {
      best = candidate;
      best_changes = changes;
    }
  }
  return best;
}

namespace {

struct MeantWord {
  std::string_view word, remedy;
};
/// Words of other languages, and those that are never alone.
constexpr MeantWord kMeantWords[] = {
    {"END", "close a block with ENDF, ENDE or ENDW"},
    {"ENDIF", "close DOF with ENDF, DOE with ENDE"},
    {"ELSE", "write DOE behind the ENDF of the DOF"},
    {"ELSIF", "write DOE and its condition behind the ENDF of the DOF"},
    {"IF", "write DOF: and the condition"},
    {"AND", "AND is written '*'"},
    {"OR", "OR is written '+'"},
    {"NOT", "NOT is written '/' in front of its operand"},
    {"XOR", "exclusive OR is written '&'"},
    {"THEN", "a head is DOF: and the condition; the statements follow on the next lines"},
    {"END_IF", "close DOF with ENDF, DOE with ENDE"},
    {"CASE", "write a DOF block with a comparator for each value, [W1K0=3], or MUX"},
    {"FOR", "a cycle has no loops: count with a word from cycle to cycle, [W1K0+1]"},
    {"WHILE", "a cycle has no loops: write DOF: and the condition, which is asked in each cycle"},
    {"RETURN", "write a DOF block around what is to be left out"},
    {"TRUE", "as a signal write 1"},
    {"FALSE", "as a signal write 0"},
};

/// Q0A1, M1K0, MW3, B3: what other controls call outputs, memory and words.
std::string CauseOfForeignAddress(std::string_view capitals) {
  const auto digit = std::ranges::find_if(capitals, IsDigit);
  const std::string_view letters = capitals.substr(0, static_cast<size_t>(digit - capitals.begin()));
  if (letters.empty() || digit == capitals.end()) return {};
  // What follows the letter is right as it is: M1K0 is U1K0.
  const std::string same(capitals.substr(letters.size()));
  const auto example = [&](char letter, std::string_view otherwise) {
    const std::string changed = letter + same;
    return Decode(changed).fault == OperandFault::kNone ? changed : std::string(otherwise);
  };
  if (letters == "Q" || letters == "Y") return "outputs are written with U: " + example('U', "U4A0");
  if (letters == "E" || letters == "X") return "inputs are written with I: " + example('I', "I0A7");
  if (letters == "M" || letters == "B" || letters == "F" || letters == "R" || letters == "MX") {
    return "bits of the memory are written with U and package K: " + example('U', "U4K3") + "; words " +
           example('W', "W4K0");
  }
  if (letters == "MB" || letters == "MW" || letters == "D" || letters == "DB" || letters == "DW") {
    return "words of the memory are written with W and package K, and have 8 bits: " + example('W', "W4K0");
  }
  return {};
}

/// T5 and C1 without a field, T5Q and C1U with one that there is not.
std::string CauseOfField(const std::string& capitals) {
  const bool lettered = capitals.size() > 2 && IsLetter(capitals.back());
  const std::string name = lettered ? capitals.substr(0, capitals.size() - 1) : capitals;
  if (!std::ranges::all_of(std::string_view(name).substr(1), IsDigit)) return CauseOfForeignAddress(capitals);
  if (name.front() == 'T') {
    return "name a field of the timer: " + name + "I starts it, " + name + "U is 1 when it is over, " + name +
           "D while it runs, " + name + "A stops it";
  }
  if (name.front() == 'C') {
    return "name a field of the counter: " + name + "I counts, " + name + "A turns the direction, " + name +
           "Z resets, " + name + "W is the value, " + name + "R the carry";
  }
  return CauseOfForeignAddress(capitals);
}

}  // namespace

std::string Capitals(std::string_view run) {
  std::string capitals(run);
  std::ranges::transform(capitals, capitals.begin(), Upper);
  return capitals;
}

std::string CauseOfUnknown(std::string_view run) {
  const std::string capitals = Capitals(run);
  for (const MeantWord& meant : kMeantWords) {
    if (capitals == meant.word) return std::string(meant.remedy);
  }
  if (capitals.size() < 2) return {};
  const std::string_view inner = std::string_view(capitals).substr(0, capitals.size() - 1);
  if (capitals.back() == 'H' && std::ranges::all_of(inner, IsHexDigit)) {
    return "a hexadecimal number begins with a digit: 0" + capitals;
  }
  return CauseOfField(capitals);
}

Operand OperandFromText(std::string_view text) {
  if (text.empty() || !std::all_of(text.begin(), text.end(), [](char c) { return IsLetter(c) || IsDigit(c); })) {
    return {};
  }
  const Decoded decoded = Decode(text);
  return decoded.fault == OperandFault::kNone ? decoded.operand : Operand{};
}

}  // namespace plcxx::nc110
