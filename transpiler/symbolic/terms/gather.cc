#include "transpiler/symbolic/terms/gather.h"

#include <algorithm>
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
  /// Bits of a sum and of what is negated may look otherwise: the word is known from those that do not.
  TermId OfOneWord(std::span<const TermId> bits) {
    for (size_t i = 0; i < bits.size(); ++i) {
      const Term term = terms_[bits[i]];
      if (term.kind != TermKind::kExtract || term.width != 1 || term.b < i) continue;
      const TermId word(term.a);
      const auto low = static_cast<uint8_t>(term.b - i);
      if (low + bits.size() > terms_.Width(word)) return {};
      for (size_t k = 0; k < bits.size(); ++k) {
        if (terms_.Extract(word, static_cast<uint8_t>(low + k), 1) != bits[k]) return {};
      }
      return terms_.Extract(word, low, static_cast<uint8_t>(bits.size()));
    }
    return {};
  }

  TermId OfOneChoice(std::span<const TermId> bits) {
    const Term first = terms_[bits.front()];
    if (first.kind != TermKind::kIte) return {};
    std::vector<TermId> then, otherwise;
    for (const TermId bit : bits) {
      const Term term = terms_[bit];
      if (term.kind != TermKind::kIte || term.a != first.a) return {};
      then.emplace_back(term.b);
      otherwise.emplace_back(term.c);
    }
    const TermId one = Run(then);
    if (!one.valid()) return {};
    const TermId other = Run(otherwise);
    return other.valid() ? terms_.Ite(TermId(first.a), one, other) : TermId();
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
