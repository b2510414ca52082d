#include "transpiler/symbolic/terms/likely_values.h"

#include <algorithm>
#include <utility>

namespace plcxx::terms {

void AddConstants(const Terms& terms, std::span<const TermId> cone, std::vector<uint64_t>& constants) {
  constexpr size_t kMost = 4096;
  for (const TermId id : cone) {
    if (terms.IsConst(id) && terms.Width(id) > 1) constants.push_back(terms.Value(id));
  }
  std::ranges::sort(constants);
  constants.erase(std::ranges::unique(constants).begin(), constants.end());
  if (constants.size() > kMost) constants.resize(kMost);
}

void LikelyValues::NoteComparison(TermId compared, uint64_t value) {
  // An index is compared after its base is taken off, in whatever width.
  for (;;) {
    const Term term = terms_[compared];
    const TermId a(term.a), b(term.b);
    if (term.kind == TermKind::kConcat && terms_.IsZero(a)) {
      compared = b;
    } else if (term.kind == TermKind::kExtract) {
      value <<= term.b;
      compared = a;
    } else if (term.kind == TermKind::kAdd && (terms_.IsConst(a) || terms_.IsConst(b))) {
      value = Masked(value - terms_.Value(terms_.IsConst(a) ? a : b), term.width);
      compared = terms_.IsConst(a) ? b : a;
    } else {
      break;
    }
  }
  const Term term = terms_[compared];
  if (term.kind == TermKind::kVariable) compared_[compared.index].push_back(value);
  if (term.kind == TermKind::kApply && terms_.Info(FunctionId(term.a)).evaluate == nullptr)
    results_[term.a].push_back(value);
}

void LikelyValues::NoteComparisons(std::span<const TermId> cone) {
  for (const TermId id : cone) {
    const Term term = terms_[id];
    if (term.kind != TermKind::kEq && term.kind != TermKind::kUlt && term.kind != TermKind::kSlt) continue;
    for (const auto& [one, other] : {std::pair(TermId(term.a), TermId(term.b)), {TermId(term.b), TermId(term.a)}}) {
      if (!terms_.IsConst(other)) continue;
      NoteComparison(one, terms_.Value(other));
      if (term.kind != TermKind::kEq) NoteComparison(one, terms_.Value(other) - 1);
    }
  }
}

uint64_t LikelyValues::Any(int vector, uint8_t width) {
  const uint64_t random = random_.Next();
  if (width == 1) {
    const uint64_t density = vector % 4 == 0 ? 128 : vector % 4 == 1 ? 16 : vector % 4 == 2 ? 240 : 64;
    return (random & 255) < density ? 1 : 0;
  }
  switch (random >> 8 & 7) {
    case 0:
      return 0;
    case 1:
      return random >> 16 & 3;
    case 2:
      return ~uint64_t{0} - (random >> 16 & 3);
    case 3:
    case 4:
      return random_.Next();
    default:
      return constants_.empty() ? random : constants_[(random >> 16) % constants_.size()] + (random >> 11 & 3) - 1;
  }
}

uint64_t LikelyValues::Of(int vector, TermId variable) {
  const auto own = compared_.find(variable.index);
  const uint64_t random = random_.Next();
  if (own == compared_.end() || (random & 1) != 0) return Any(vector, terms_.Width(variable));
  return own->second[(random >> 1) % own->second.size()];
}

uint64_t LikelyValues::ResultOf(int vector, const Term& application, uint64_t made_up) const {
  constexpr uint8_t kLeastWidth = 8;
  const bool has_meaning = terms_.Info(FunctionId(application.a)).evaluate != nullptr;
  // Two results, as inputs that the host answers, are hardly ever equal else.
  if (vector % 4 == 3 && !has_meaning && application.width >= kLeastWidth) return made_up >> 7 & 1;
  const auto own = results_.find(application.a);
  if ((made_up & 1) == 0 || own == results_.end()) return made_up;
  return Masked(own->second[(made_up >> 1) % own->second.size()], application.width);
}

}  // namespace plcxx::terms
