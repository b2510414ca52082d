#include "transpiler/prove/verify/loop_guess.h"

#include <algorithm>
#include <utility>

namespace plcxx::prove::verify {
namespace {

constexpr size_t kMostGuesses = 12;
constexpr size_t kMostGuessesOfLater = 6;
constexpr size_t kFewestLater = 6;  // samples after an entry

enum Likelihood : uint8_t { kSame, kFixed, kApart, kMasked, kApartSinceEntry, kScaled };

/// A word in the width of the item: extended, or a part of it.
struct Form {
  Guess term;
  std::vector<uint64_t> values;
};

std::vector<Form> FormsOf(const SampledValue& word, size_t number, uint8_t width) {
  std::vector<Form> forms;
  const auto add = [&](Guess term, auto&& value) {
    Form form{.term = std::move(term), .values = {}};
    for (const uint64_t one : word.values) form.values.push_back(terms::Masked(value(one), width));
    forms.push_back(std::move(form));
  };
  if (word.width <= width) {
    add([number, width](terms::Terms& terms,
                        std::span<const terms::TermId> words) { return terms.Zext(words[number], width); },
        [](uint64_t value) { return value; });
  }
  if (word.width < width) {
    add([number, width](terms::Terms& terms,
                        std::span<const terms::TermId> words) { return terms.Sext(words[number], width); },
        [&](uint64_t value) { return static_cast<uint64_t>(terms::AsSigned(value, word.width)); });
  }
  for (uint8_t low = 0; word.width > width && low + width <= word.width; low = static_cast<uint8_t>(low + 8)) {
    add([number, low, width](terms::Terms& terms,
                             std::span<const terms::TermId> words) { return terms.Extract(words[number], low, width); },
        [low](uint64_t value) { return value >> low; });
  }
  return forms;
}

class Guesser {
 public:
  Guesser(const SampledValue& item, terms::TermId at_entry, const SampledLoop& loop)
      : item_(item), at_entry_(at_entry), loop_(loop), count_(item.values.size()) {}

  std::vector<RatedGuess> Run();

 private:
  /// Of which samples guesses are: all; or those after the entry, where the item begins as something else.
  enum class Of : uint8_t { kAll, kLater };
  void Try(Of of);
  bool IsAsked(size_t sample) const { return of_ == Of::kAll || loop_.entries[sample] != sample; }
  uint64_t Bits(uint64_t value) const { return terms::Masked(value, item_.width); }
  /// Whether all samples satisfy it.
  template <class Test>
  bool All(Test&& test) const {
    for (size_t i = 0; i < count_; ++i) {
      if (IsAsked(i) && !test(i)) return false;
    }
    return true;
  }
  uint64_t AtEntry(size_t sample) const { return item_.values[loop_.entries[sample]]; }
  void Add(Likelihood likelihood, Guess guess) { found_.emplace_back(likelihood, std::move(guess)); }
  Guess BehindEntry(Guess guess) const;
  void TryForm(const Form& form);
  void TryApart(const Form& form);
  void TryMasked(const Form& form);
  void TryScaled(const Form& form);

  const SampledValue& item_;
  terms::TermId at_entry_;
  const SampledLoop& loop_;
  size_t count_;
  Of of_ = Of::kAll;
  size_t base_ = 0;  // a sample that is asked
  std::vector<std::pair<Likelihood, Guess>> found_;
};

Guess Guesser::BehindEntry(Guess guess) const {
  return [guess = std::move(guess), entry = at_entry_, later = loop_.later](terms::Terms& terms,
                                                                            std::span<const terms::TermId> words) {
    return terms.Ite(words[later], guess(terms, words), entry);
  };
}

void Guesser::TryApart(const Form& form) {
  const uint8_t width = item_.width;
  const uint64_t apart = Bits(item_.values[base_] - form.values[base_]),
                 sum = Bits(item_.values[base_] + form.values[base_]);
  if (All([&](size_t i) { return Bits(item_.values[i] - form.values[i]) == apart; })) {
    Add(kApart, [term = form.term, apart, width](terms::Terms& terms, std::span<const terms::TermId> words) {
      return terms.Add(term(terms, words), terms.Const(apart, width));
    });
  } else if (All([&](size_t i) { return Bits(item_.values[i] + form.values[i]) == sum; })) {
    Add(kApart, [term = form.term, sum, width](terms::Terms& terms, std::span<const terms::TermId> words) {
      return terms.Sub(terms.Const(sum, width), term(terms, words));
    });
  }
}

void Guesser::TryMasked(const Form& form) {
  const uint8_t width = item_.width;
  uint64_t differs = 0, varies = 0, changes = 0;
  for (size_t i = 0; i < count_; ++i) {
    differs |= item_.values[i] ^ form.values[i];
    varies |= item_.values[i] ^ item_.values[0];
    changes |= item_.values[i] ^ AtEntry(i);
  }
  // What does not vary is no evidence.
  if ((changes & ~differs) == 0) return;
  if ((differs & varies) == 0) {
    const uint64_t fixed = item_.values[0] & differs;
    Add(kMasked, [term = form.term, differs, fixed, width](terms::Terms& terms, std::span<const terms::TermId> words) {
      return terms.Or(terms.And(term(terms, words), terms.Const(~differs, width)), terms.Const(fixed, width));
    });
  } else if ((differs & changes) == 0) {
    Add(kMasked, [term = form.term, differs, entry = at_entry_, width](terms::Terms& terms,
                                                                       std::span<const terms::TermId> words) {
      return terms.Or(terms.And(term(terms, words), terms.Const(~differs, width)),
                      terms.And(entry, terms.Const(differs, width)));
    });
  }
}

/// Where the word has changed by 1 since the entry, the item shows its own step.
void Guesser::TryScaled(const Form& form) {
  const auto changed = [&](size_t i) { return Bits(form.values[i] - form.values[loop_.entries[i]]); };
  size_t one = count_;
  for (size_t i = 0; i < count_ && one == count_; ++i) {
    if (changed(i) == 1) one = i;
  }
  if (one == count_) return;
  const uint8_t width = item_.width;
  const uint64_t step = Bits(item_.values[one] - AtEntry(one));
  if (step == 0 || !All([&](size_t i) { return Bits(item_.values[i] - AtEntry(i)) == Bits(step * changed(i)); }))
    return;
  Add(step == 1 ? kApartSinceEntry : kScaled,
      [term = form.term, step, width, entry = at_entry_, before = loop_.words_at_entry](
          terms::Terms& terms, std::span<const terms::TermId> words) {
        const terms::TermId since = terms.Sub(term(terms, words), term(terms, *before));
        return terms.Add(entry, terms.Mul(terms.Const(step, width), since));
      });
}

void Guesser::TryForm(const Form& form) {
  if (All([&](size_t i) { return item_.values[i] == form.values[i]; })) {
    Add(kSame, form.term);
    return;
  }
  TryApart(form);
  if (of_ == Of::kLater) return;
  TryMasked(form);
  TryScaled(form);
}

void Guesser::Try(Of of) {
  of_ = of;
  base_ = 0;
  while (base_ < count_ && !IsAsked(base_)) ++base_;
  if (base_ == count_) return;
  if (All([&](size_t i) { return item_.values[i] == item_.values[base_]; })) {
    Add(kFixed, [value = item_.values[base_], width = item_.width](
                    terms::Terms& terms, std::span<const terms::TermId>) { return terms.Const(value, width); });
  } else if (of == Of::kAll && All([&](size_t i) { return item_.values[i] == AtEntry(i); })) {
    Add(kFixed, [entry = at_entry_](terms::Terms&, std::span<const terms::TermId>) { return entry; });
  }
  for (size_t number = 0; number < loop_.words.size(); ++number) {
    for (const Form& form : FormsOf(loop_.words[number], number, item_.width)) TryForm(form);
  }
  std::ranges::stable_sort(found_, {}, &std::pair<Likelihood, Guess>::first);
}

std::vector<RatedGuess> Guesser::Run() {
  if (count_ == 0) return {};
  std::vector<RatedGuess> guesses;
  Try(Of::kAll);
  for (auto& [likelihood, guess] : found_) {
    if (guesses.size() < kMostGuesses) guesses.push_back({std::move(guess), likelihood == kFixed});
  }
  found_.clear();
  size_t later = 0;
  for (size_t i = 0; i < count_; ++i) later += loop_.entries[i] != i ? 1 : 0;
  if (later < kFewestLater) return guesses;
  const size_t of_all = guesses.size();
  Try(Of::kLater);
  for (auto& [likelihood, guess] : found_) {
    if (guesses.size() < of_all + kMostGuessesOfLater)
      guesses.push_back({BehindEntry(std::move(guess)), likelihood == kFixed});
  }
  return guesses;
}

}  // namespace

std::vector<RatedGuess> GuessesFor(const SampledValue& item, terms::TermId at_entry, const SampledLoop& loop) {
  return Guesser(item, at_entry, loop).Run();
}

}  // namespace plcxx::prove::verify
