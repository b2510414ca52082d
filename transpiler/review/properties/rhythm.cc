#include "transpiler/review/properties/rhythm.h"

#include <algorithm>
#include <array>

namespace plcxx::review::properties {
namespace {

constexpr std::array<uint32_t, 10> kPaces{1, 1, 1, 1, 2, 3, 5, 20, 100, 400};  // passes from one change to the next
constexpr size_t kNear = 6;                                                    // words that mostly have a pace
constexpr uint64_t kMostPaced = 3;
constexpr size_t kMostEvents = 100'000;

/// A value that a word may have: of a bit one of two, else nothing or what the program knows.
uint64_t AnyValue(const RhythmInputs& inputs, size_t bits, terms::Random& random) {
  if (bits == 1) return random.Next() >> 7 & 1;
  if (inputs.constants.empty() || random.OneIn(3)) return 0;
  return inputs.constants[(random.Next() >> 20) % inputs.constants.size()];
}

void Set(const std::vector<execute::CellId>& word, uint64_t value, uint64_t period, RunPlan& plan) {
  for (size_t bit = 0; bit < word.size(); ++bit)
    plan.events.push_back({static_cast<uint32_t>(period), word[bit], bit < 64 && (value >> bit & 1) != 0});
}

}  // namespace

RunPlan MakeRhythm(const RhythmInputs& inputs, uint64_t passes, terms::Random& random) {
  RunPlan plan;
  plan.periods = static_cast<uint32_t>(passes * inputs.pass_periods);
  std::vector<uint64_t> held;
  for (const std::vector<execute::CellId>& word : inputs.words) {
    held.push_back(AnyValue(inputs, word.size(), random));
    if (held.back() != 0) Set(word, held.back(), 1, plan);
  }
  for (uint64_t left = inputs.words.empty() ? 0 : 1 + (random.Next() >> 9) % kMostPaced; left > 0; --left) {
    const size_t among = random.OneIn(3) ? inputs.words.size() : std::min(inputs.words.size(), kNear);
    const size_t at = (random.Next() >> 20) % among;
    const std::vector<execute::CellId>& word = inputs.words[at];
    const uint64_t other = word.size() == 1 ? 1 - held[at] : AnyValue(inputs, word.size(), random);
    const uint64_t pace = uint64_t{kPaces[(random.Next() >> 20) % kPaces.size()]} * inputs.pass_periods;
    bool is_other = false;
    for (uint64_t period = 1 + pace; period <= plan.periods && plan.events.size() < kMostEvents; period += pace) {
      is_other = !is_other;
      Set(word, is_other ? other : held[at], period, plan);
    }
  }
  std::ranges::stable_sort(plan.events, {}, &RunEvent::period);
  return plan;
}

}  // namespace plcxx::review::properties
