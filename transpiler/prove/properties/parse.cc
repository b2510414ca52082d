// Recursive descent over the words of a line; each line by itself, so that every wrong line is reported.
#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/prove/properties/property.h"
#include "transpiler/prove/properties/words.h"

namespace plcxx::prove::properties {
namespace {

constexpr int kMostNested = 200;

/// Words with a meaning of their own; as locations they stand in quotes.
constexpr std::array<std::string_view, 17> kWords = {"bit",  "and", "or",    "not",     "implies", "within",
                                                     "for",  "in",  "is",    "exactly", "one",     "at",
                                                     "most", "of",  "never", "always",  "stuck"};

class LineParser {
 public:
  LineParser(const PropertyLine& line, uint32_t number, const PropertyContext& context)
      : words_(line.words), context_(context) {
    property_.line = number;
    property_.column = line.words.front().column;
    property_.text = line.text;
    if (line.unclosed) Fail(line.words[line.words.size() - 2], {"a quote without its partner", "a name in quotes"});
  }

  void Parse();
  Property& property() { return property_; }
  std::optional<PropertyError>& error() { return error_; }

 private:
  const PropertyWord& Now() const { return words_[at_]; }
  const PropertyWord& Ahead(size_t words) const { return words_[std::min(at_ + words, words_.size() - 1)]; }
  bool Is(const PropertyWord& word, std::string_view text) const { return !word.quoted && word.text == text; }
  bool IsSequence(std::initializer_list<std::string_view> texts) const {
    size_t i = 0;
    return std::ranges::all_of(texts, [&](std::string_view text) { return Is(Ahead(i++), text); });
  }
  bool Take(std::initializer_list<std::string_view> texts) {
    if (failed() || !IsSequence(texts)) return false;
    at_ += texts.size();
    return true;
  }
  bool failed() const { return error_.has_value(); }

  void Fail(const PropertyWord& word, PropertyFault fault, std::vector<std::string> words) {
    if (failed()) return;
    error_ = PropertyError{.line = property_.line,
                           .column = word.column,
                           .length = std::max(1U, word.length),
                           .fault = fault,
                           .words = std::move(words)};
  }
  void Fail(const PropertyWord& word, std::vector<std::string> words) {
    Fail(word, PropertyFault::kSyntax, std::move(words));
  }
  void Expected(std::string what) {
    Fail(Now(), {Now().is_end ? "the end of the line" : "'" + Now().text + "'", std::move(what)});
  }
  uint32_t Add(Condition condition) {
    property_.conditions.push_back(std::move(condition));
    return static_cast<uint32_t>(property_.conditions.size() - 1);
  }

  uint32_t Periods();
  uint32_t AnyOf();
  uint32_t AllOf();
  uint32_t Negation();
  uint32_t Held();
  uint32_t Primary();
  /// A list in a list stands in parentheses: whose a comma is could not be seen.
  uint32_t CountOf(ConditionKind kind);
  uint32_t Comparison();
  uint32_t Range(uint32_t value, const PropertyWord& word);
  uint32_t BitOf();
  /// A location or a number.
  uint32_t Value();
  std::optional<int64_t> Number();
  uint32_t Operand(PropertyOperand operand);

  bool IsNumber(uint32_t condition) const { return property_.conditions[condition].kind == ConditionKind::kNumber; }
  const PropertyOperand* OperandOf(uint32_t condition) const {
    const Condition& what = property_.conditions[condition];
    return what.kind == ConditionKind::kOperand ? &property_.operands[what.operand] : nullptr;
  }
  /// `who` takes true or false.
  void CheckBit(uint32_t condition, const PropertyWord& word, const std::string& who);
  void CheckFits(const PropertyOperand& operand, int64_t value, const PropertyWord& word);

  const std::vector<PropertyWord>& words_;
  const PropertyContext& context_;
  size_t at_ = 0;
  int depth_ = 0;
  bool in_list_ = false;
  Property property_;
  std::optional<PropertyError> error_;
};

void LineParser::Parse() {
  if (failed()) return;
  const bool never = Take({"never"});
  if (!never) Take({"always"});
  const PropertyWord first = Now();
  property_.condition = AnyOf();
  if (failed()) return;
  CheckBit(property_.condition, first, "a property");
  if (never) {
    property_.condition = Add({.kind = ConditionKind::kNot, .children = {property_.condition}});
  } else if (const size_t before_stuck = at_; Take({"is", "never", "stuck"})) {
    const PropertyOperand* const operand = OperandOf(property_.condition);
    const size_t words = first.text == "bit" && !first.quoted ? 4 : 1;
    if (operand == nullptr || before_stuck != words) Fail(words_[0], {"a condition", "one output"});
    property_.kind = PropertyKind::kNeverStuck;
    property_.periods = kStuckPeriods;
    if (Take({"within"})) property_.periods = Periods();
  } else if (Take({"implies"})) {
    const PropertyWord word = Now();
    property_.consequence = AnyOf();
    if (!failed()) CheckBit(property_.consequence, word, "'implies'");
    property_.kind = PropertyKind::kResponse;
    if (Take({"within"})) property_.periods = Periods();
  }
  if (!failed() && !Now().is_end) {
    Expected(property_.kind == PropertyKind::kAlways && !never
                 ? "'and', 'or', 'implies', a comparison or the end of the line"
                 : "the end of the line");
  }
}

/// After "within" and "for".
uint32_t LineParser::Periods() {
  if (failed()) return 1;
  const PropertyWord number_word = Now();
  const std::optional<int64_t> number = context_.number(number_word.text);
  if (number_word.quoted || !number) {
    Expected("a number of slow, fast or ms");
    return 1;
  }
  ++at_;
  const PropertyTiming& timing = context_.timing;
  constexpr int64_t kMost = 1'000'000'000;
  const int64_t count = std::clamp<int64_t>(*number, -1, kMost);
  const std::string unit = Now().text;
  int64_t periods = 0;
  if (Take({"slow"})) {
    periods = count * timing.slow_periods;
  } else if (Take({"fast"})) {
    periods = (count * timing.fast_periods + timing.fast_per_period - 1) / timing.fast_per_period;
  } else if (Take({"ms"})) {
    periods = (count + timing.period_ms - 1) / timing.period_ms;
  } else {
    Expected("slow, fast or ms");
    return 1;
  }
  if (count < 1 || periods > kMostPropertyPeriods) {
    Fail(number_word, PropertyFault::kTooLong,
         {number_word.text + " " + unit, std::to_string(std::max<int64_t>(periods, 0)),
          std::to_string(kMostPropertyPeriods)});
    return 1;
  }
  return static_cast<uint32_t>(periods);
}

uint32_t LineParser::AnyOf() {
  const PropertyWord word = Now();
  const uint32_t first = AllOf();
  if (failed() || !IsSequence({"or"})) return first;
  CheckBit(first, word, "'or'");
  std::vector<uint32_t> children{first};
  while (Take({"or"})) {
    const PropertyWord next = Now();
    children.push_back(AllOf());
    if (!failed()) CheckBit(children.back(), next, "'or'");
  }
  return Add({.kind = ConditionKind::kOr, .children = std::move(children)});
}

uint32_t LineParser::AllOf() {
  const PropertyWord word = Now();
  const uint32_t first = Negation();
  if (failed() || !IsSequence({"and"})) return first;
  CheckBit(first, word, "'and'");
  std::vector<uint32_t> children{first};
  while (Take({"and"})) {
    const PropertyWord next = Now();
    children.push_back(Negation());
    if (!failed()) CheckBit(children.back(), next, "'and'");
  }
  return Add({.kind = ConditionKind::kAnd, .children = std::move(children)});
}

uint32_t LineParser::Negation() {
  bool negated = false;
  while (Take({"not"})) negated = !negated;
  const PropertyWord word = Now();
  const uint32_t condition = Held();
  if (!negated || failed()) return condition;
  CheckBit(condition, word, "'not'");
  return Add({.kind = ConditionKind::kNot, .children = {condition}});
}

uint32_t LineParser::Held() {
  const PropertyWord word = Now();
  uint32_t condition = Primary();
  if (failed()) return condition;
  while (Take({"for"})) {
    CheckBit(condition, word, "'for'");
    const uint32_t periods = Periods();
    condition = Add({.kind = ConditionKind::kHeld, .children = {condition}, .periods = periods});
  }
  return condition;
}

uint32_t LineParser::Primary() {
  if (failed()) return 0;
  if (in_list_ && (IsSequence({"at", "most", "one", "of"}) || IsSequence({"exactly", "one", "of"}))) {
    Expected("'(' in front of a list in a list");
    return 0;
  }
  if (Take({"at", "most", "one", "of"})) return CountOf(ConditionKind::kAtMostOne);
  if (Take({"exactly", "one", "of"})) return CountOf(ConditionKind::kExactlyOne);
  if (!Take({"("})) return Comparison();
  if (++depth_ > kMostNested) {
    Expected("fewer than " + std::to_string(kMostNested) + " nested parentheses");
    return 0;
  }
  const PropertyWord word = Now();
  const bool in_list = std::exchange(in_list_, false);
  const uint32_t condition = AnyOf();
  in_list_ = in_list;
  if (!failed()) CheckBit(condition, word, "a condition in parentheses");
  if (!failed() && !Take({")"})) Expected("')'");
  --depth_;
  return condition;
}

uint32_t LineParser::CountOf(ConditionKind kind) {
  std::vector<uint32_t> children;
  in_list_ = true;
  do {
    const PropertyWord word = Now();
    children.push_back(Negation());
    if (!failed()) CheckBit(children.back(), word, "a list");
  } while (Take({","}));
  in_list_ = false;
  if (!failed() && children.size() < 2) Expected("','");
  return Add({.kind = kind, .children = std::move(children)});
}

uint32_t LineParser::Comparison() {
  const PropertyWord first = Now();
  const uint32_t left = Value();
  if (failed()) return left;
  if (Take({"in"})) return Range(left, first);
  struct Sign {
    std::string_view text;
    ConditionKind kind;
    bool swapped, negated;
  };
  constexpr std::array<Sign, 8> kSigns = {{{"=", ConditionKind::kEqual, false, false},
                                           {"==", ConditionKind::kEqual, false, false},
                                           {"!=", ConditionKind::kEqual, false, true},
                                           {"<>", ConditionKind::kEqual, false, true},
                                           {"<", ConditionKind::kLess, false, false},
                                           {">", ConditionKind::kLess, true, false},
                                           {"<=", ConditionKind::kLess, true, true},
                                           {">=", ConditionKind::kLess, false, true}}};
  std::optional<Sign> sign;
  for (const Sign& one : kSigns) {
    if (!sign && Take({one.text})) sign = one;
  }
  if (!sign && !IsSequence({"is", "never"}) && Take({"is"})) {
    sign = Sign{.text = "is", .kind = ConditionKind::kEqual, .swapped = false, .negated = Take({"not"})};
  }
  if (!sign) {
    if (IsNumber(left)) Fail(first, {"'" + first.text + "'", "a location or a comparison"});
    return left;
  }
  const PropertyWord second = Now();
  const uint32_t right = Value();
  if (failed()) return left;
  const PropertyOperand *left_operand = OperandOf(left), *right_operand = OperandOf(right);
  if (left_operand == nullptr && right_operand == nullptr) Fail(first, {"'" + first.text + "'", "a location"});
  if (left_operand != nullptr && IsNumber(right)) {
    CheckFits(*left_operand, property_.conditions[right].low, second);
  } else if (right_operand != nullptr && IsNumber(left)) {
    CheckFits(*right_operand, property_.conditions[left].low, first);
  }
  const uint32_t comparison =
      Add({.kind = sign->kind, .children = sign->swapped ? std::vector{right, left} : std::vector{left, right}});
  return sign->negated ? Add({.kind = ConditionKind::kNot, .children = {comparison}}) : comparison;
}

uint32_t LineParser::Range(uint32_t value, const PropertyWord& word) {
  const PropertyOperand* const operand = OperandOf(value);
  if (operand == nullptr) Fail(word, {"'" + word.text + "'", "a location"});
  const PropertyWord low_word = Now();
  const std::optional<int64_t> low = Number();
  if (low && !Take({".."})) Expected("'..'");
  const PropertyWord high_word = Now();
  const std::optional<int64_t> high = Number();
  if (!low || !high || failed()) return value;
  if (*low > *high) Fail(low_word, PropertyFault::kRange, {low_word.text, high_word.text});
  CheckFits(*operand, *low, low_word);
  CheckFits(*operand, *high, high_word);
  return Add({.kind = ConditionKind::kRange, .children = {value}, .low = *low, .high = *high});
}

std::optional<int64_t> LineParser::Number() {
  if (failed()) return std::nullopt;
  const std::optional<int64_t> number = Now().quoted || Now().is_end ? std::nullopt : context_.number(Now().text);
  if (!number) {
    Expected("a number");
    return std::nullopt;
  }
  ++at_;
  return number;
}

/// After "bit": one bit of a word, counted from the least significant one.
uint32_t LineParser::BitOf() {
  const PropertyWord number_word = Now();
  const std::optional<int64_t> number = Number();
  if (number && !Take({"of"})) Expected("'of'");
  if (failed()) return 0;
  const PropertyWord word = Now();
  const uint32_t value = Value();
  if (failed()) return value;
  if (OperandOf(value) == nullptr) {
    Fail(word, {"'" + word.text + "'", "a location"});
    return value;
  }
  PropertyOperand& operand = property_.operands[property_.conditions[value].operand];
  if (*number < 0 || *number >= operand.width) {
    Fail(number_word, PropertyFault::kNoFit,
         {number_word.text, "a bit of " + operand.text, "0 to " + std::to_string(operand.width - 1)});
    return value;
  }
  operand.low_bit = static_cast<uint8_t>(*number);
  operand.width = 1;
  operand.is_bit = true;
  return value;
}

uint32_t LineParser::Value() {
  if (Take({"bit"})) return BitOf();
  const PropertyWord word = Now();
  const bool is_word = !word.quoted && std::ranges::find(kWords, word.text) != kWords.end();
  const bool is_sign = !word.quoted && word.text.find_first_not_of("=<>(),!.") == std::string::npos;
  if (failed() || word.is_end || is_word || is_sign) {
    Expected("a location, a number or '('");
    return 0;
  }
  ++at_;
  const char first = word.text.empty() ? ' ' : word.text[0];
  const bool like_number = !word.quoted && ((first >= '0' && first <= '9') || first == '-' || first == '+');
  std::optional<int64_t> number = like_number ? context_.number(word.text) : std::nullopt;
  if (!number) {
    const std::optional<LocatedOperand> located = context_.locate(word.text);
    if (located && std::holds_alternative<PropertyOperand>(*located)) {
      return Operand(std::get<PropertyOperand>(*located));
    }
    if (located) {
      Fail(word, PropertyFault::kNotMemory, {word.text, std::get<std::string>(*located)});
      return 0;
    }
    if (!word.quoted) number = context_.number(word.text);
  }
  if (number) return Add({.kind = ConditionKind::kNumber, .low = *number});
  Fail(word, PropertyFault::kLocation, {word.text});
  return 0;
}

uint32_t LineParser::Operand(PropertyOperand operand) {
  property_.operands.push_back(std::move(operand));
  return Add({.kind = ConditionKind::kOperand, .operand = static_cast<uint32_t>(property_.operands.size() - 1)});
}

void LineParser::CheckBit(uint32_t condition, const PropertyWord& word, const std::string& who) {
  const PropertyOperand* const operand = OperandOf(condition);
  if (operand == nullptr || operand->is_bit) return;
  Fail(word, PropertyFault::kBitNeeded, {operand->text, who});
}

void LineParser::CheckFits(const PropertyOperand& operand, int64_t value, const PropertyWord& word) {
  const int width = operand.width;
  int64_t low = 0, high = width >= 63 ? INT64_MAX : (int64_t{1} << width) - 1;
  if (operand.has_sign && !operand.is_bit) {
    low = width >= 64 ? INT64_MIN : -(int64_t{1} << (width - 1));
    high = width >= 64 ? INT64_MAX : (int64_t{1} << (width - 1)) - 1;
  }
  if (low <= value && value <= high) return;
  Fail(word, PropertyFault::kNoFit, {word.text, operand.text, std::to_string(low) + " to " + std::to_string(high)});
}

}  // namespace

Properties ParseProperties(std::string_view text, const PropertyContext& context) {
  Properties result;
  bool any = false;
  for (uint32_t number = 1; !text.empty(); ++number) {
    const size_t end = text.find('\n');
    const PropertyLine line = SplitProperty(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.words.size() == 1) continue;
    any = true;
    LineParser parser(line, number, context);
    parser.Parse();
    if (parser.error()) {
      result.errors.push_back(std::move(*parser.error()));
    } else {
      result.properties.push_back(std::move(parser.property()));
    }
  }
  if (!any) result.errors.push_back({.line = 1, .column = 1, .fault = PropertyFault::kNothing});
  return result;
}

}  // namespace plcxx::prove::properties
