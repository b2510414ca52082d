#include "transpiler/plant/condition.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "transpiler/plant/numbers.h"

namespace plcxx::plant {
namespace {

constexpr int kMaxNested = 50;

struct ConditionWord {
  std::string text;
  bool is_quoted = false;
  bool is_end = false;
};

constexpr std::string_view kSigns[] = {"!=", "<>", "<=", ">=", "==", "=", "<", ">", "(", ")"};

std::string_view SignAt(std::string_view text) {
  for (const std::string_view sign : kSigns) {
    if (text.starts_with(sign)) return sign;
  }
  return {};
}

/// None: a quote has no partner.
std::optional<std::vector<ConditionWord>> SplitCondition(std::string_view text) {
  std::vector<ConditionWord> words;
  for (size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '\t' || text[at] == '\n') {
      ++at;
      continue;
    }
    if (text[at] == '\'') {
      const size_t close = text.find('\'', at + 1);
      if (close == std::string_view::npos) return std::nullopt;
      words.push_back({.text = std::string(text.substr(at + 1, close - at - 1)), .is_quoted = true});
      at = close + 1;
      continue;
    }
    size_t end = at;
    if (const std::string_view sign = SignAt(text.substr(at)); !sign.empty()) {
      end = at + sign.size();
    } else {
      // "!LAMP" is a name, and so is "K!A"; "A!=B" is not.
      while (end < text.size() && text[end] != ' ' && text[end] != '\t' && text[end] != '\n' &&
             (end == at || SignAt(text.substr(end)).empty())) {
        ++end;
      }
    }
    words.push_back({.text = std::string(text.substr(at, end - at))});
    at = end;
  }
  words.push_back({.text = {}, .is_end = true});
  return words;
}

class ConditionParser {
 public:
  ConditionParser(std::vector<ConditionWord> words, yaml::Place mark, LocationNames& reads)
      : words_(std::move(words)), mark_(mark), reads_(reads) {}

  std::optional<uint32_t> Parse() {
    const uint32_t whole = AnyOf();
    if (wrong_.empty() && !Now().is_end) Expected("'and', 'or', a comparison or the end");
    if (!wrong_.empty()) return std::nullopt;
    return whole;
  }
  const std::string& wrong() const { return wrong_; }
  std::vector<ConditionNode>& nodes() { return nodes_; }

 private:
  const ConditionWord& Now() const { return words_[at_]; }
  bool Is(std::string_view text) const { return !Now().is_quoted && !Now().is_end && Now().text == text; }
  bool Take(std::string_view text) {
    if (!wrong_.empty() || !Is(text)) return false;
    ++at_;
    return true;
  }
  void Expected(const std::string& what) {
    if (wrong_.empty())
      wrong_ = (Now().is_end ? "the end" : "'" + Now().text + "'") + " stands where " + what + " is expected";
  }
  uint32_t Add(ConditionNode node) {
    nodes_.push_back(node);
    return static_cast<uint32_t>(nodes_.size()) - 1;
  }
  uint32_t Not(uint32_t node) { return Add({.kind = ConditionKind::kNot, .first = node}); }

  uint32_t AnyOf() {
    uint32_t left = AllOf();
    while (Take("or")) left = Add({.kind = ConditionKind::kOr, .first = left, .second = AllOf()});
    return left;
  }
  uint32_t AllOf() {
    uint32_t left = Negation();
    while (Take("and")) left = Add({.kind = ConditionKind::kAnd, .first = left, .second = Negation()});
    return left;
  }
  uint32_t Negation() {
    bool is_negated = false;
    while (Take("not")) is_negated = !is_negated;
    const uint32_t node = Comparison();
    return is_negated ? Not(node) : node;
  }
  uint32_t Comparison() {
    if (Take("(")) {
      if (++depth_ > kMaxNested) {
        Expected("fewer than " + std::to_string(kMaxNested) + " nested parentheses");
        return 0;
      }
      const uint32_t node = AnyOf();
      if (!Take(")")) Expected("')'");
      --depth_;
      return node;
    }
    const uint32_t left = Value();
    if (Take("is")) {
      const bool is_negated = Take("not");
      const uint32_t equal = Add({.kind = ConditionKind::kEqual, .first = left, .second = Value()});
      return is_negated ? Not(equal) : equal;
    }
    if (Take("=") || Take("==")) return Add({.kind = ConditionKind::kEqual, .first = left, .second = Value()});
    if (Take("!=") || Take("<>")) return Not(Add({.kind = ConditionKind::kEqual, .first = left, .second = Value()}));
    if (Take("<")) return Add({.kind = ConditionKind::kLess, .first = left, .second = Value()});
    if (Take(">=")) return Not(Add({.kind = ConditionKind::kLess, .first = left, .second = Value()}));
    if (Take(">")) return Add({.kind = ConditionKind::kLess, .first = Value(), .second = left});
    if (Take("<=")) return Not(Add({.kind = ConditionKind::kLess, .first = Value(), .second = left}));
    return left;
  }
  uint32_t Value() {
    if (!wrong_.empty()) return 0;
    constexpr std::string_view kWords[] = {"and", "or", "not", "is"};
    const bool is_word = !Now().is_quoted && (std::ranges::find(kWords, Now().text) != std::end(kWords) ||
                                              std::ranges::find(kSigns, Now().text) != std::end(kSigns));
    if (Now().is_end || is_word || Now().text.empty()) {
      Expected("a location");
      return 0;
    }
    const ConditionWord word = Now();
    ++at_;
    if (!word.is_quoted) {
      if (const std::optional<int64_t> number = WholeNumber(word.text)) {
        return Add({.kind = ConditionKind::kNumber, .number = *number});
      }
    }
    return Add({.kind = ConditionKind::kRead, .read = reads_.Add({word.text, mark_})});
  }

  std::vector<ConditionWord> words_;
  yaml::Place mark_;
  LocationNames& reads_;
  size_t at_ = 0;
  int depth_ = 0;
  std::string wrong_;
  std::vector<ConditionNode> nodes_;
};

}  // namespace

uint32_t LocationNames::Add(const yaml::MarkedText& name) {
  const auto known = std::ranges::find(names_, name.text, &yaml::MarkedText::text);
  if (known != names_.end()) return static_cast<uint32_t>(known - names_.begin());
  names_.push_back(name);
  return static_cast<uint32_t>(names_.size()) - 1;
}

std::variant<Condition, std::string> Condition::Parse(const yaml::MarkedText& text, LocationNames& reads) {
  constexpr size_t kMaxText = 4096;
  if (text.text.size() > kMaxText) return "a condition is too long";
  std::optional<std::vector<ConditionWord>> words = SplitCondition(text.text);
  if (!words) return "a quote has no partner";
  ConditionParser parser(std::move(*words), text.mark, reads);
  if (!parser.Parse()) return parser.wrong();
  return Condition(std::move(parser.nodes()));
}

Condition Condition::Not(Condition condition) {
  const auto whole = static_cast<uint32_t>(condition.nodes_.size()) - 1;
  condition.nodes_.push_back({.kind = ConditionKind::kNot, .first = whole});
  return condition;
}

int64_t Condition::ValueOf(uint32_t node, std::span<const int64_t> reads) const {
  const ConditionNode& at = nodes_[node];
  switch (at.kind) {
    case ConditionKind::kNumber:
      return at.number;
    case ConditionKind::kRead:
      return reads[at.read];
    case ConditionKind::kNot:
      return ValueOf(at.first, reads) == 0 ? 1 : 0;
    case ConditionKind::kAnd:
      return ValueOf(at.first, reads) != 0 && ValueOf(at.second, reads) != 0 ? 1 : 0;
    case ConditionKind::kOr:
      return ValueOf(at.first, reads) != 0 || ValueOf(at.second, reads) != 0 ? 1 : 0;
    case ConditionKind::kEqual:
      return ValueOf(at.first, reads) == ValueOf(at.second, reads) ? 1 : 0;
    case ConditionKind::kLess:
      return ValueOf(at.first, reads) < ValueOf(at.second, reads) ? 1 : 0;
  }
  return 0;
}

}  // namespace plcxx::plant
