#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/support/check.h"

#include <algorithm>
#include <limits>

namespace plcxx::technol {
namespace {

// Brackets and signs within each other: each is a call of this parser.
constexpr uint32_t kMostLevels = 200;

using Value = std::optional<int64_t>;

class ExpressionReader {
 public:
  ExpressionReader(TokenReader& reader, ParsingContext& context) : reader_(reader), context_(context) {}

  Value Or() {
    Value left = And();
    while (left) {
      if (reader_.TakeWord("OR")) {
        left = Join(left, And(), [](int64_t a, int64_t b) { return Value(a | b); });
      } else if (reader_.TakeWord("XOR")) {
        left = Join(left, And(), [](int64_t a, int64_t b) { return Value(a ^ b); });
      } else {
        break;
      }
    }
    return left;
  }

  Value Term() {
    Value left = Signed();
    while (left) {
      if (reader_.TakePunctuation('*')) {
        left = Join(left, Signed(), [this](int64_t a, int64_t b) { return Exact(a, b, Product); });
      } else if (reader_.TakePunctuation('/')) {
        left = Join(left, Signed(), [this](int64_t a, int64_t b) { return Quotient(a, b); });
      } else if (reader_.TakeWord("MOD")) {
        left = Join(left, Signed(), [this](int64_t a, int64_t b) { return Remainder(a, b); });
      } else if (reader_.TakeWord("SHL")) {
        left = Join(left, Signed(), [this](int64_t a, int64_t b) { return ShiftLeft(a, b); });
      } else if (reader_.TakeWord("SHR")) {
        left = Join(left, Signed(), [this](int64_t a, int64_t b) { return ShiftRight(a, b); });
      } else {
        break;
      }
    }
    return left;
  }

 private:
  using Overflowing = bool (*)(int64_t, int64_t, int64_t*);
  static bool Product(int64_t a, int64_t b, int64_t* into) { return __builtin_mul_overflow(a, b, into); }
  static bool Sum(int64_t a, int64_t b, int64_t* into) { return __builtin_add_overflow(a, b, into); }
  static bool Difference(int64_t a, int64_t b, int64_t* into) { return __builtin_sub_overflow(a, b, into); }

  Value And() {
    Value left = Sums();
    while (left && reader_.TakeWord("AND")) {
      left = Join(left, Sums(), [](int64_t a, int64_t b) { return Value(a & b); });
    }
    return left;
  }

  Value Sums() {
    Value left = Term();
    while (left) {
      if (reader_.TakePunctuation('+')) {
        left = Join(left, Term(), [this](int64_t a, int64_t b) { return Exact(a, b, Sum); });
      } else if (reader_.TakePunctuation('-')) {
        left = Join(left, Term(), [this](int64_t a, int64_t b) { return Exact(a, b, Difference); });
      } else {
        break;
      }
    }
    return left;
  }

  Value Signed() {
    if (++levels_ > kMostLevels) {
      context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "an expression with fewer brackets");
      return std::nullopt;
    }
    const Value value = SignedBelow();
    --levels_;
    return value;
  }

  Value SignedBelow() {
    if (reader_.TakePunctuation('+')) return Signed();
    if (reader_.TakePunctuation('-')) {
      const Value value = Signed();
      return value ? Exact(0, *value, Difference) : value;
    }
    if (reader_.TakeWord("NOT")) {
      const Value value = Signed();
      return value ? Value(~*value) : value;
    }
    return Primary();
  }

  Value Primary() {
    const size_t first = reader_.position();
    const Token* token = reader_.Peek();
    if (token == nullptr) return Missing();
    if (reader_.TakePunctuation('(')) {
      const Value value = Or();
      if (!value) return value;
      if (reader_.TakePunctuation(')')) return value;
      context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "')'")
          .notes.push_back({token->range, "to match this '('"});
      return std::nullopt;
    }
    switch (token->kind) {
      case TokenKind::kNumber:
        reader_.Take();
        return Literal(*token);
      case TokenKind::kString:
        if (token->text.size() != 3) return Missing();
        reader_.Take();
        return static_cast<unsigned char>(token->text[1]);
      case TokenKind::kWord:
        if (reader_.TakeWord("SIZE")) return Size(first);
        if (token->text == "?" || IsReserved(Upper(token->text))) return Missing();
        reader_.Take();
        return Named(*token);
      case TokenKind::kQuoted:
      case TokenKind::kOpenString:
      case TokenKind::kPunctuation:
      case TokenKind::kPath:
      case TokenKind::kText:
      case TokenKind::kComment:
      case TokenKind::kInvalid:
        return Missing();
    }
    PLCXX_UNREACHABLE();
  }

  Value Literal(const Token& token) {
    const Number number = ReadNumber(token.text);
    if (number.fault == NumberFault::kNone) return number.value;
    if (number.fault == NumberFault::kRange) {
      context_.Report(token.range, diag::TechnolNumberRange, token.text);
    } else {
      context_.Report(token.range, diag::TechnolMalformedNumber, token.text);
    }
    return std::nullopt;
  }

  Value Named(const Token& token) {
    const SymbolId id = context_.names.Find(token.text);
    if (!id.valid()) {
      context_.ReportUndefined(token.text, token.range);
      return std::nullopt;
    }
    Symbol& symbol = context_.names[id];
    ++symbol.uses;
    const bool constant = symbol.kind == SymbolKind::kConstant || symbol.kind == SymbolKind::kField;
    if (symbol.faulty) {
      context_.Forgive();
    } else if (!constant) {
      context_.Report(token.range, diag::TechnolUndefinedAs, token.text, "a constant", KindText(symbol));
    } else if (!context_.names.IsDefinedAt(id, context_.statement)) {
      context_.ReportUndefined(token.text, token.range);
    } else {
      return context_.names.ValueAt(id, context_.statement);
    }
    return std::nullopt;
  }

  Value Size(size_t first) {
    const Token* name = reader_.Peek();
    if (name == nullptr || name->kind != TokenKind::kWord) return Missing();
    reader_.Take();
    const SymbolId id = context_.names.Find(name->text);
    if (!id.valid() ||
        (context_.names[id].kind == SymbolKind::kStructure && !context_.names.IsDefinedAt(id, context_.statement))) {
      context_.ReportUndefined(name->text, name->range);
      return std::nullopt;
    }
    Symbol& symbol = context_.names[id];
    ++symbol.uses;
    if (symbol.kind == SymbolKind::kStructure && !symbol.faulty) return symbol.bytes;
    if (symbol.faulty) {
      context_.Forgive();
    } else {
      context_.Report(reader_.RangeFrom(first), diag::TechnolUndefinedAs, name->text, "a structure", KindText(symbol));
    }
    return std::nullopt;
  }

  Value Missing() {
    const Token* token = reader_.Peek();
    const bool word = token != nullptr && token->kind == TokenKind::kWord;
    const std::string upper = word ? Upper(token->text) : std::string();
    if (token != nullptr && token->kind == TokenKind::kOpenString) {
      context_.Report(token->range, diag::TechnolStringOpen, token->text);
    } else if (word && token->text != "?" && IsReserved(upper) && RegisterByName(upper) == Register::kNone) {
      context_.Report(token->range, diag::TechnolReserved, token->text);
    } else {
      context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(token), "a constant");
    }
    return std::nullopt;
  }

  template <class Function>
  static Value Join(Value left, Value right, Function function) {
    return left && right ? function(*left, *right) : std::nullopt;
  }

  Value Exact(int64_t a, int64_t b, Overflowing operation) {
    int64_t result = 0;
    return operation(a, b, &result) ? OutOfRange() : Value(result);
  }

  Value Quotient(int64_t a, int64_t b) {
    if (b == 0) return ByZero();
    return b == -1 ? Exact(0, a, Difference) : Value(a / b);
  }

  Value Remainder(int64_t a, int64_t b) {
    if (b == 0) return ByZero();
    return b == -1 ? 0 : a % b;
  }

  Value ShiftLeft(int64_t a, int64_t count) {
    constexpr int64_t kBits = 63;
    if (count < 0) return OutOfRange();
    if (a == 0 || count == 0) return a;
    return count >= kBits ? OutOfRange() : Exact(a, int64_t{1} << count, Product);
  }

  Value ShiftRight(int64_t a, int64_t count) {
    constexpr int64_t kBits = 63;
    if (count < 0) return OutOfRange();
    return a >> std::min(count, kBits);
  }

  Value ByZero() {
    context_.Report(reader_.RangeFrom(first_), diag::TechnolDivisionByZero, reader_.TextFrom(first_));
    return std::nullopt;
  }

  Value OutOfRange() {
    context_.Report(reader_.RangeFrom(first_), diag::TechnolNumberRange, reader_.TextFrom(first_));
    return std::nullopt;
  }

  TokenReader& reader_;
  ParsingContext& context_;
  size_t first_ = reader_.position();
  uint32_t levels_ = 0;
};

std::optional<uint32_t> DigitValue(char c) {
  if (IsDigit(c)) return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return std::nullopt;
}

bool HasDigitsOf(std::string_view text, uint32_t base) {
  return !text.empty() && std::ranges::all_of(text, [base](char c) {
    const auto digit = DigitValue(c);
    return digit && *digit < base;
  });
}

/// The base that the last letter tells, and the digits without it; base 0: malformed.
std::pair<std::string_view, uint32_t> Split(std::string_view text) {
  const std::string_view digits = text.substr(0, text.size() - 1);
  switch (text.back()) {
    case 'H':
    case 'h':
      return {digits, 16};
    case 'O':
    case 'o':
    case 'Q':
    case 'q':
      return {digits, 8};
    case 'B':
    case 'b':
      return {digits, 2};
    case 'D':
    case 'd':
      return {digits, 10};
    default:
      return {text, 10};
  }
}

Value InRange(Value value, TokenReader& reader, ParsingContext& context, size_t first) {
  if (!value || (*value >= kLeastNumber && *value <= kGreatestNumber)) return value;
  context.Report(reader.RangeFrom(first), diag::TechnolNumberRange, reader.TextFrom(first));
  return std::nullopt;
}

}  // namespace

Number ReadNumber(std::string_view text) {
  const auto [digits, base] = Split(text);
  if (!HasDigitsOf(digits, base)) return {.value = 0, .fault = NumberFault::kMalformed};
  int64_t value = 0;
  for (const char c : digits) {
    value = value * base + *DigitValue(c);
    if (value > kGreatestNumber) return {.value = 0, .fault = NumberFault::kRange};
  }
  return {.value = value};
}

std::optional<int64_t> ReadConstant(TokenReader& reader, ParsingContext& context) {
  const size_t first = reader.position();
  return InRange(ExpressionReader(reader, context).Or(), reader, context, first);
}

std::optional<int64_t> ReadConstantTerm(TokenReader& reader, ParsingContext& context) {
  const size_t first = reader.position();
  return InRange(ExpressionReader(reader, context).Term(), reader, context, first);
}

}  // namespace plcxx::technol
