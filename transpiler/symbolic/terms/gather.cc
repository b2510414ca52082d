#include "transpiler/symbolic/terms/gather.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace plcxx::terms {
namespace {

constexpr uint32_t kMostSteps = 60;  // choices in choices

class Gatherer {
 public:
  explicit Gatherer(Terms& terms) : terms_(terms) {}

  /// None: they have nothing in common.
  TermId Run(std::span<const TermId> bits) {
    if (bits.size() == 1) return bits.front();
    if (++steps_ > kMostSteps) return {};
    if (std::ranges::all_of(bits, [this](TermId bit) { return terms_.IsConst(bit); })) return InOrder(bits);
    if (const TermId whole = OfOneWord(bits); whole.valid()) return whole;
    return OfOneChoice(bits);
  }

  TermId InOrder(std::span<const TermId> bits) {
    TermId value = bits.front();
    for (const TermId bit : bits.subspan(1)) value = terms_.Concat(bit, value);
    return value;
  }

 private:
  /// Bits of a sum and of what is negated may look otherwise, and the lowest ones are those of another word: the word
  /// is known from others.
  TermId OfOneWord(std::span<const TermId> bits) {
    Term refused;
    for (size_t i = 0; i < bits.size(); ++i) {
      const Term term = terms_[bits[i]];
      if (term.kind != TermKind::kExtract || term.width != 1 || term.b < i) continue;
      const TermId word(term.a);
      const auto low = static_cast<uint8_t>(term.b - i);
      const Term tried{TermKind::kExtract, 1, term.a, low};
      if (tried == std::exchange(refused, tried)) continue;
      const auto is_its = [&](size_t k) { return terms_.Extract(word, static_cast<uint8_t>(low + k), 1) == bits[k]; };
      size_t same = 0;
      while (low + bits.size() <= terms_.Width(word) && same < bits.size() && is_its(same)) ++same;
      if (same == bits.size()) return terms_.Extract(word, low, static_cast<uint8_t>(bits.size()));
    }
    return {};
  }

  /// By what a bit may be chosen; the second one may be none, and both.
  std::array<TermId, 2> ConditionsOf(TermId bit) {
    const Term term = terms_[bit];
    const auto plain = [this](uint32_t id) {
      return terms_[TermId(id)].kind == TermKind::kNot ? TermId(terms_[TermId(id)].a) : TermId(id);
    };
    if (term.kind == TermKind::kIte) return {TermId(term.a), TermId()};
    if (term.kind == TermKind::kAnd || term.kind == TermKind::kOr) return {plain(term.a), plain(term.b)};
    return {};
  }

  /// What a bit is where the condition holds and where it does not; none: it is no choice by this condition.
  std::optional<std::pair<TermId, TermId>> ChoiceBy(TermId condition, TermId bit) {
    const Term term = terms_[bit];
    const TermId zero = terms_.Bit(false), one = terms_.Bit(true);
    if (term.kind == TermKind::kConst) return std::pair(bit, bit);
    if (bit == condition) return std::pair(one, zero);
    if (term.kind == TermKind::kNot && TermId(term.a) == condition) return std::pair(zero, one);
    if (term.kind == TermKind::kIte && TermId(term.a) == condition) return std::pair(TermId(term.b), TermId(term.c));
    if (term.kind != TermKind::kAnd && term.kind != TermKind::kOr) return std::nullopt;
    const TermId decided = term.kind == TermKind::kAnd ? zero : one;
    const TermId negated = terms_.Not(condition);
    for (const auto& [by, rest] : {std::pair(term.a, term.b), std::pair(term.b, term.a)}) {
      const bool decides_where_true = TermId(by) == (term.kind == TermKind::kAnd ? negated : condition);
      const bool decides_where_false = TermId(by) == (term.kind == TermKind::kAnd ? condition : negated);
      if (decides_where_true) return std::pair(decided, TermId(rest));
      if (decides_where_false) return std::pair(TermId(rest), decided);
    }
    return std::nullopt;
  }

  /// A choice of words whose one branch is a constant has bits that are written as "and" and "or".
  TermId OfOneChoice(std::span<const TermId> bits) {
    const auto first = std::ranges::find_if(bits, [this](TermId bit) { return ConditionsOf(bit).front().valid(); });
    if (first == bits.end()) return {};
    for (const TermId condition : ConditionsOf(*first)) {
      if (!condition.valid()) break;
      if (const TermId whole = OfChoiceBy(condition, bits); whole.valid()) return whole;
    }
    return {};
  }

  TermId OfChoiceBy(TermId condition, std::span<const TermId> bits) {
    std::vector<TermId> then, otherwise;
    for (const TermId bit : bits) {
      auto choice = ChoiceBy(condition, bit);
      // A bit that both words have is no choice any more: the lowest one of a number and of the number negated.
      if (!choice && !ConditionsOf(bit).front().valid()) choice = {bit, bit};
      if (!choice) return {};
      then.push_back(choice->first);
      otherwise.push_back(choice->second);
    }
    const TermId one = Run(then);
    if (!one.valid()) return {};
    const TermId other = Run(otherwise);
    return other.valid() ? terms_.Ite(condition, one, other) : TermId();
  }

  Terms& terms_;
  uint32_t steps_ = 0;
};

}  // namespace

TermId Gather(Terms& terms, std::span<const TermId> bits) {
  Gatherer gatherer(terms);
  const TermId whole = gatherer.Run(bits);
  if (whole.valid()) return whole;
  constexpr size_t kByte = 8;
  std::vector<TermId> bytes;
  for (size_t at = 0; bits.size() > kByte && at < bits.size(); at += kByte)
    bytes.push_back(Gather(terms, bits.subspan(at, std::min(kByte, bits.size() - at))));
  return gatherer.InOrder(bytes.empty() ? bits : std::span<const TermId>(bytes));
}

}  // namespace plcxx::terms
