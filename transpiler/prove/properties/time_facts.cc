#include "transpiler/prove/properties/time_facts.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/state_runs.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostRegisters = 16, kMostLimits = 4, kMostBits = 6, kMostWhile = 48, kMostGuesses = 9000,
                 kMostOffsets = 8;
constexpr size_t kMostOwnLimits = 3;  // of a register
constexpr size_t kMostSimulatedTerms = 60'000;
constexpr int kShortRuns = 8, kRuns = 24, kPeriods = 700;
constexpr size_t kMostTermsAfter = 2'000'000;  // computed in a run behind a step that ends a guess
constexpr uint32_t kMostRefills = 8;           // weaker guesses for those that have failed
constexpr uint64_t kNeverChanged = uint64_t{1} << 60;
constexpr uint64_t kMostPeriodsAway = 100;  // of a clock from the time
constexpr uint64_t kMostLimit = uint64_t{1} << 24;
constexpr uint32_t kMostSlack = 2;  // periods that a count may be ahead
constexpr size_t kAtStart = ~size_t{0};
constexpr uint8_t kLeastWidth = 25;  // of sums; one that wraps is a guess that fails

enum class Reading : uint8_t {
  kValue,
  kAhead,  // of the clock
  kBehind  // it
};

struct Register {
  std::vector<terms::TermId> variables;
  Reading reading = Reading::kValue;
  uint8_t width = 0;
  uint64_t greatest = 0;         // in the runs that were tried
  std::vector<uint64_t> limits;  // with which it is compared, the greatest ones first
};

enum class Form : uint8_t {
  kGrows,    // register + slack >= scale * count
  kFalls,    // register + scale * count <= limit + slack, or the count is 0
  kAtMost,   // register <= limit
  kExactly,  // register = limit
  kWhile,    // while it is counted, a bit has a value
  kLong,     // scale * count <= limit + slack
  kBits      // one of three bits has a value
};

struct Guess {
  Form form{};
  uint32_t of_register = 0, counter = 0;
  uint64_t scale = 1, slack = 0;
  std::optional<uint64_t> limit;  // of kGrows: or the register has come that far
  std::optional<std::pair<terms::TermId, bool>> unless, also_unless, or_unless;
  bool operator==(const Guess&) const = default;
};

/// The numbers of one state, by index of registers, counters and bits.
struct Sample {
  std::vector<uint64_t> registers, counters;
  std::map<terms::TermId, uint64_t> bits;
};

bool IsOfRegister(Form form) {
  return form == Form::kGrows || form == Form::kFalls || form == Form::kAtMost || form == Form::kExactly;
}
bool IsOfCounter(Form form) {
  return form == Form::kGrows || form == Form::kFalls || form == Form::kWhile || form == Form::kLong;
}

bool HoldsIn(const Guess& guess, const Sample& sample) {
  for (const auto& bit : {guess.unless, guess.also_unless, guess.or_unless}) {
    if (bit && (sample.bits.at(bit->first) != 0) == bit->second) return true;
  }
  if (guess.form == Form::kBits) return false;
  // There may be no register at all.
  const uint64_t passed = IsOfCounter(guess.form) ? sample.counters[guess.counter] * guess.scale : 0;
  if (guess.form == Form::kWhile) return passed == 0;
  if (guess.form == Form::kLong) return passed <= *guess.limit + guess.slack;
  const uint64_t number = sample.registers[guess.of_register];
  if (guess.form == Form::kAtMost) return number <= *guess.limit;
  if (guess.form == Form::kExactly) return number == *guess.limit;
  if (guess.form == Form::kGrows) return passed <= number + guess.slack || (guess.limit && *guess.limit <= number);
  return passed == 0 || number + passed <= *guess.limit + guess.slack;
}

class Finder {
 public:
  explicit Finder(const TimeQuestion& question)
      : question_(question), terms_(question.reach.terms), end_ms_(question.reach.rest_ms() / 2) {}

  std::vector<terms::TermId> Find();

 private:
  using State = StateRuns::State;

  /// Its value before (part 0) or after part `part` - 1, or after power-on.
  terms::TermId ValueOf(terms::TermId variable, size_t part);
  terms::TermId NumberOf(const Register& one, size_t part);
  terms::TermId ConditionOf(const Guess& guess, size_t part);
  bool Late() const { return question_.reach.rest_ms() <= end_ms_; }
  void CloseOver();
  void AddRegisters();
  void AddGuesses();
  void AddGuessesOfBits(std::span<const std::optional<std::pair<terms::TermId, bool>>> bits,
                        const std::set<uint64_t>& scales);
  void AddWhile(size_t known_bits);
  std::vector<uint64_t> Offsets() const;
  static std::vector<uint64_t> SlacksOf(uint64_t scale, std::span<const uint64_t> offsets);
  void DropWrongAtStart();
  void LookForGreatest();
  void DropClocks();
  std::vector<Guess> Strongest() const;
  void DropContradicted();
  void DropContradictedFrom(const State& state);
  void ForEachSample(int runs, const std::function<void(const Sample&)>& visit);
  Sample SampleOf(const State& state) const;
  void DropContradictedBy(const Sample& sample);
  bool Prove();

  const TimeQuestion& question_;
  terms::Terms& terms_;
  uint32_t end_ms_;
  std::map<terms::TermId, StateWord> words_;
  std::vector<Register> registers_;
  std::vector<uint64_t> limits_;
  std::vector<Guess> guesses_;
  std::optional<StateRuns> runs_;
};

terms::TermId Finder::ValueOf(terms::TermId variable, size_t part) {
  if (part == 0) return variable;
  const auto word = words_.find(variable);
  if (word == words_.end()) return variable;
  return part == kAtStart ? word->second.start : word->second.next[part - 1];
}

terms::TermId Finder::NumberOf(const Register& one, size_t part) {
  terms::TermId number;
  for (const terms::TermId variable : one.variables) {
    const terms::TermId value = ValueOf(variable, part);
    number = number.valid() ? terms_.Concat(value, number) : value;
  }
  switch (one.reading) {
    case Reading::kValue:
      return number;
    case Reading::kAhead:
      return terms_.Sub(number, ValueOf(question_.now, part));
    case Reading::kBehind:
      return terms_.Sub(ValueOf(question_.now, part), number);
  }
  PLCXX_UNREACHABLE();
}

terms::TermId Finder::ConditionOf(const Guess& guess, size_t part) {
  terms::TermId holds = terms_.Bit(false);
  for (const auto& bit : {guess.unless, guess.also_unless, guess.or_unless}) {
    if (!bit) continue;
    const terms::TermId value = ValueOf(bit->first, part);
    holds = terms_.Or(holds, bit->second ? value : terms_.Not(value));
  }
  if (guess.form == Form::kBits) return holds;
  uint8_t width = kLeastWidth;
  if (IsOfRegister(guess.form)) {
    const int bits = registers_[guess.of_register].width + 1;
    width = static_cast<uint8_t>(std::clamp<int>(bits, kLeastWidth, 64));
  }
  const auto constant = [&](uint64_t value) { return terms_.Const(value, width); };
  terms::TermId number, count, passed;
  if (IsOfRegister(guess.form)) number = terms_.Zext(NumberOf(registers_[guess.of_register], part), width);
  if (IsOfCounter(guess.form)) {
    count = terms_.Zext(ValueOf(question_.counters[guess.counter], part), width);
    passed = terms_.Mul(count, constant(guess.scale));
  }
  switch (guess.form) {
    case Form::kBits:
      break;
    case Form::kAtMost:
      return terms_.Or(holds, terms_.Ule(number, constant(*guess.limit)));
    case Form::kExactly:
      return terms_.Or(holds, terms_.Eq(number, constant(*guess.limit)));
    case Form::kWhile:
      return terms_.Or(holds, terms_.Eq(count, constant(0)));
    case Form::kLong:
      return terms_.Or(holds, terms_.Ule(passed, constant(*guess.limit + guess.slack)));
    case Form::kGrows:
      holds = terms_.Or(holds, terms_.Ule(passed, terms_.Add(number, constant(guess.slack))));
      return guess.limit ? terms_.Or(holds, terms_.Ule(constant(*guess.limit), number)) : holds;
    case Form::kFalls:
      holds = terms_.Or(holds, terms_.Eq(count, constant(0)));
      return terms_.Or(holds, terms_.Ule(terms_.Add(number, passed), constant(*guess.limit + guess.slack)));
  }
  PLCXX_UNREACHABLE();
}

/// All state on which what must not happen depends, in any number of periods.
void Finder::CloseOver() {
  std::set<terms::TermId> seen;
  std::vector<terms::TermId> roots{question_.reach.bad};
  roots.insert(roots.end(), question_.counters.begin(), question_.counters.end());
  if (question_.now.valid()) roots.push_back(question_.now);
  while (!roots.empty() && !Late()) {
    std::vector<terms::TermId> next;
    for (const terms::TermId id : terms::ConeOf(terms_, roots)) {
      if (terms_[id].kind != terms::TermKind::kVariable || !seen.insert(id).second) continue;
      const std::optional<StateWord> word = question_.reach.state_of(id);
      if (!word) continue;
      next.insert(next.end(), word->next.begin(), word->next.end());
      words_[id] = *word;
    }
    roots = std::move(next);
  }
}

void Finder::AddRegisters() {
  std::vector<terms::TermId> roots{question_.reach.bad};
  for (const auto& [variable, word] : words_) roots.insert(roots.end(), word.next.begin(), word.next.end());
  const std::map<terms::TermId, std::set<uint64_t>> compared = ConstantsComparedWith(terms_, roots);
  for (const std::vector<terms::TermId>& variables : question_.registers) {
    const bool known =
        std::ranges::all_of(variables, [&](terms::TermId variable) { return words_.contains(variable); });
    if (!known || registers_.size() >= kMostRegisters) continue;
    std::vector<terms::TermId> next;
    uint8_t width = 0;
    std::set<uint64_t> limits;
    for (const terms::TermId variable : variables) {
      next.push_back(words_[variable].next.back());
      width = static_cast<uint8_t>(width + terms_.Width(variable));
      if (const auto found = compared.find(variable); found != compared.end())
        limits.insert(found->second.lower_bound(2), found->second.lower_bound(kMostLimit));
    }
    const std::vector<terms::TermId> cone = terms::ConeOf(terms_, next);
    const bool tells_time = std::ranges::find(cone, question_.now) != cone.end();
    // The greatest ones: presets and periods, not steps on the way to them.
    std::vector<uint64_t> own(limits.rbegin(), limits.rend());
    if (own.size() > kMostOwnLimits) own.resize(kMostOwnLimits);
    for (const uint64_t limit : own) {
      if (limits_.size() < kMostLimits && std::ranges::find(limits_, limit) == limits_.end()) limits_.push_back(limit);
    }
    registers_.push_back({.variables = variables, .reading = Reading::kValue, .width = width, .limits = own});
    if (!question_.now.valid() || !tells_time || width != terms_.Width(question_.now)) continue;
    for (const Reading reading : {Reading::kAhead, Reading::kBehind})
      registers_.push_back({.variables = variables, .reading = reading, .width = width, .limits = own});
  }
}

/// What a count says about bits alone: it is what the others need where a timer
/// has come to its end.
void Finder::AddGuessesOfBits(std::span<const std::optional<std::pair<terms::TermId, bool>>> bits,
                              const std::set<uint64_t>& scales) {
  std::set<uint64_t> limits(limits_.begin(), limits_.end());
  for (const Register& one : registers_) {
    if (one.greatest < kMostLimit) limits.insert(one.greatest);
  }
  const auto is_same = [&bits](size_t i, size_t j) { return bits[i]->first == bits[j]->first; };
  for (size_t i = 1; i < bits.size(); ++i) {
    for (size_t j = i + 1; j < bits.size(); ++j) {
      for (size_t k = j + 1; k < bits.size(); ++k) {
        if (is_same(i, j) || is_same(j, k)) continue;
        guesses_.push_back(
            {.form = Form::kBits, .limit = {}, .unless = bits[i], .also_unless = bits[j], .or_unless = bits[k]});
      }
    }
  }
  for (uint32_t counter = 0; counter < question_.counters.size(); ++counter) {
    for (size_t i = 1; i < bits.size(); ++i) {
      guesses_.push_back({.form = Form::kWhile, .counter = counter, .limit = {}, .unless = bits[i], .also_unless = {}});
      for (size_t j = i + 1; j < bits.size(); ++j) {
        if (is_same(i, j)) continue;
        guesses_.push_back(
            {.form = Form::kWhile, .counter = counter, .limit = {}, .unless = bits[i], .also_unless = bits[j]});
      }
      for (const uint64_t scale : scales) {
        for (const uint64_t limit : limits) {
          for (uint64_t slack = 0; slack <= kMostSlack * scale; slack += scale) {
            guesses_.push_back({.form = Form::kLong,
                                .counter = counter,
                                .scale = scale,
                                .slack = slack,
                                .limit = limit,
                                .unless = bits[i],
                                .also_unless = {}});
          }
        }
      }
    }
  }
}

/// While it is counted, one bit has a value: a timer's input, what stands behind the condition. These are few, and
/// cheap.
void Finder::AddWhile(size_t known_bits) {
  for (size_t i = known_bits; i < std::min(question_.bits.size(), kMostWhile); ++i) {
    if (!words_.contains(question_.bits[i])) continue;
    for (uint32_t counter = 0; counter < question_.counters.size(); ++counter) {
      for (const bool value : {true, false}) {
        guesses_.push_back({.form = Form::kWhile,
                            .counter = counter,
                            .limit = {},
                            .unless = std::pair(question_.bits[i], value),
                            .also_unless = {}});
      }
    }
  }
}

/// What may have passed before a register goes on: nothing, or presets of others, one after the other.
std::vector<uint64_t> Finder::Offsets() const {
  std::set<uint64_t> times;
  for (const uint64_t limit : limits_) {
    if (limit < 2 * uint64_t{question_.period_ms}) continue;
    const std::set<uint64_t> before = times;
    times.insert(limit);
    for (const uint64_t time : before) times.insert(time + limit);
  }
  std::vector<uint64_t> offsets{0};
  for (const uint64_t time : times) {
    if (offsets.size() < kMostOffsets) offsets.push_back(time);
  }
  return offsets;
}

std::vector<uint64_t> Finder::SlacksOf(uint64_t scale, std::span<const uint64_t> offsets) {
  std::vector<uint64_t> slacks;
  for (const uint64_t offset : offsets) {
    for (uint64_t slack = 0; slack <= kMostSlack * scale; slack += scale) slacks.push_back(offset + slack);
  }
  return slacks;
}

void Finder::AddGuesses() {
  std::vector<std::optional<std::pair<terms::TermId, bool>>> unless{std::nullopt};
  for (const terms::TermId bit : question_.bits) {
    if (unless.size() > 2 * kMostBits || !words_.contains(bit)) continue;
    for (const bool value : {true, false}) unless.emplace_back(std::pair(bit, value));
  }
  const std::vector<uint64_t> offsets = Offsets();
  std::set<uint64_t> scales{1, question_.period_ms};
  if (question_.period_ms % 10 == 0) scales.insert(question_.period_ms / 10);
  for (uint32_t i = 0; i < registers_.size(); ++i) {
    const uint64_t greatest = registers_[i].greatest;
    std::vector<std::optional<uint64_t>> limits(registers_[i].limits.begin(), registers_[i].limits.end());
    // That it is at least 0 says nothing.
    if (greatest != 0 && greatest < kMostLimit && std::ranges::find(limits, greatest) == limits.end())
      limits.emplace_back(greatest);
    std::vector<std::optional<uint64_t>> or_none{std::nullopt};
    or_none.insert(or_none.end(), limits.begin(), limits.end());
    if (greatest < kMostLimit) {
      for (const Form form : {Form::kAtMost, Form::kExactly})
        guesses_.push_back({.form = form, .of_register = i, .limit = greatest, .unless = {}});
    }
    for (uint32_t counter = 0; counter < question_.counters.size(); ++counter) {
      for (const auto& bit : unless) {
        for (const uint64_t scale : scales) {
          const bool may_be_second = !bit && registers_[i].reading == Reading::kValue;
          for (const uint64_t slack : SlacksOf(scale, std::span(offsets).first(may_be_second ? offsets.size() : 1))) {
            Guess guess{.form = Form::kGrows, .of_register = i, .counter = counter, .scale = scale, .slack = slack};
            guess.unless = bit;
            for (const std::optional<uint64_t>& limit : bit ? std::span(or_none).first(1) : std::span(or_none)) {
              guess.limit = limit;
              guesses_.push_back(guess);
            }
            guess.form = Form::kFalls;
            for (const std::optional<uint64_t>& limit : limits) {
              guess.limit = limit;
              guesses_.push_back(guess);
            }
          }
        }
      }
    }
  }
  AddGuessesOfBits(unless, scales);
  if (guesses_.size() > kMostGuesses) guesses_.resize(kMostGuesses);
  AddWhile(unless.size() / 2);
}

Sample Finder::SampleOf(const State& state) const {
  Sample sample;
  for (const Register& one : registers_) {
    uint64_t number = 0, shift = 0;
    for (const terms::TermId variable : one.variables) {
      number |= state.at(variable) << shift;
      shift += terms_.Width(variable);
    }
    if (one.reading == Reading::kAhead) number = terms::Masked(number - state.at(question_.now), one.width);
    if (one.reading == Reading::kBehind) number = terms::Masked(state.at(question_.now) - number, one.width);
    sample.registers.push_back(number);
  }
  for (const terms::TermId counter : question_.counters) sample.counters.push_back(state.at(counter));
  for (const terms::TermId bit : std::span(question_.bits).first(std::min(question_.bits.size(), kMostWhile))) {
    const auto value = state.find(bit);
    sample.bits[bit] = value == state.end() ? 0 : value->second;
  }
  return sample;
}

/// Runs from power-on in which inputs stand for long.
void Finder::ForEachSample(int runs, const std::function<void(const Sample&)>& visit) {
  runs_->BeginAgain();
  for (int run = 0; run < runs && !Late(); ++run) {
    const auto draw = [&] { return run == 0 ? ~uint64_t{0} : runs_->Draw(); };
    const uint64_t one_in = uint64_t{4} << (run % 8);
    runs_->DrawInputs(1, draw);
    runs_->Run(
        runs_->Start(), kPeriods, [&] { runs_->DrawInputs(one_in, draw); },
        [&](const State& state) {
          visit(SampleOf(state));
          return !Late();
        });
  }
}

/// All that is left holds in the state, and what a run from there ends is no induction. With inputs that stay as they
/// are much is counted to its end, that of a count that no run from power-on has begun, too.
void Finder::DropContradictedFrom(const State& state) {
  const size_t periods = std::clamp<size_t>(kMostTermsAfter / std::max<size_t>(1, runs_->cost()), 1, kPeriods);
  const std::vector<uint64_t> inputs = runs_->inputs();
  DropContradictedBy(SampleOf(state));
  for (const uint64_t one_in : {kNeverChanged, uint64_t{200}}) {
    runs_->SetInputs(inputs);
    runs_->Run(
        state, periods, [&] { runs_->DrawInputs(one_in, [this] { return runs_->Draw(); }); },
        [this](const State& later) {
          DropContradictedBy(SampleOf(later));
          return !Late();
        });
  }
}

void Finder::LookForGreatest() {
  ForEachSample(kShortRuns, [this](const Sample& sample) {
    for (size_t i = 0; i < registers_.size(); ++i)
      registers_[i].greatest = std::max(registers_[i].greatest, sample.registers[i]);
  });
}

/// A distance from the clock that is sometimes very long says nothing; where it
/// is short the register is a clock itself.
void Finder::DropClocks() {
  std::set<terms::TermId> clocks;
  for (const Register& one : registers_) {
    if (one.reading != Reading::kValue && one.greatest <= kMostPeriodsAway * question_.period_ms)
      clocks.insert(one.variables.front());
  }
  std::erase_if(registers_, [&clocks](const Register& one) {
    const bool is_clock = clocks.contains(one.variables.front());
    return one.reading == Reading::kValue ? is_clock : one.greatest >= kMostLimit;
  });
}

void Finder::DropContradictedBy(const Sample& sample) {
  std::erase_if(guesses_, [&sample](const Guess& guess) { return !HoldsIn(guess, sample); });
}

void Finder::DropContradicted() {
  ForEachSample(kRuns, [this](const Sample& sample) { DropContradictedBy(sample); });
}

/// Of guesses that say the same of the same, the strongest: the others follow.
std::vector<Guess> Finder::Strongest() const {
  const auto bound = [](const Guess& guess) {
    const bool is_sum = guess.form == Form::kFalls || guess.form == Form::kLong;
    return guess.slack + (is_sum ? *guess.limit : 0);
  };
  const auto is_weaker = [&](const Guess& guess, const Guess& other) {
    // Of two bits one may be enough.
    if (guess.form == Form::kWhile) {
      return guess.also_unless && !other.also_unless &&
             (other.unless == guess.unless || other.unless == guess.also_unless);
    }
    if (other.unless && other.unless != guess.unless) return false;
    const bool more_cases = guess.form == Form::kGrows && other.limit && other.limit != guess.limit;
    if (more_cases || bound(other) > bound(guess)) return false;
    return bound(other) < bound(guess) || (guess.unless && !other.unless) ||
           (guess.form == Form::kGrows && guess.limit && !other.limit);
  };
  std::map<std::tuple<Form, uint32_t, uint32_t, uint64_t>, std::vector<size_t>> of_the_same;
  for (size_t i = 0; i < guesses_.size(); ++i) {
    const Guess& guess = guesses_[i];
    of_the_same[{guess.form, guess.of_register, guess.counter, guess.scale}].push_back(i);
  }
  std::vector<bool> is_kept(guesses_.size());
  for (const auto& [what, group] : of_the_same) {
    for (const size_t i : group) {
      is_kept[i] = std::get<Form>(what) == Form::kBits ||
                   std::ranges::none_of(group, [&](size_t j) { return is_weaker(guesses_[i], guesses_[j]); });
    }
  }
  std::vector<Guess> strongest;
  for (size_t i = 0; i < guesses_.size(); ++i) {
    if (is_kept[i]) strongest.push_back(guesses_[i]);
  }
  return strongest;
}

/// By induction, all together. What a stronger one said counts when that one is gone.
bool Finder::Prove() {
  for (uint32_t round = 1;; ++round) {
    const std::vector<Guess> tried = Strongest();
    std::vector<terms::TermId> conditions = question_.reach.known, fails;
    terms::TermId any = terms_.Bit(false);
    for (const Guess& guess : tried) {
      conditions.push_back(ConditionOf(guess, 0));
      terms::TermId fails_somewhere = terms_.Bit(false);
      for (size_t part = 1; part <= question_.reach.parts; ++part)
        fails_somewhere = terms_.Or(fails_somewhere, terms_.Not(ConditionOf(guess, part)));
      fails.push_back(fails_somewhere);
      any = terms_.Or(any, fails_somewhere);
    }
    solver::Answer answer = solver::Answer::kNever;
    if (!terms_.IsFalse(any)) {
      conditions.push_back(any);
      const uint32_t rest_ms = question_.reach.rest_ms();
      if (rest_ms <= end_ms_) return false;
      answer = question_.solver.Check(conditions, solver::Limit::Clock(rest_ms - end_ms_));
    }
    if (answer == solver::Answer::kUnknown) return false;
    if (answer == solver::Answer::kNever) {
      guesses_ = tried;
      return true;
    }
    // What has not been seen to fail by now mostly holds: weaker ones would only be asked about one by one.
    if (round == kMostRefills) guesses_ = tried;
    const size_t count = guesses_.size();
    runs_->Set([this](terms::TermId variable) { return question_.solver.ValueOf(variable); });
    std::erase_if(guesses_, [&](const Guess& guess) {
      const auto at = std::ranges::find(tried, guess);
      return at != tried.end() && question_.solver.ValueOf(fails[at - tried.begin()]) != 0;
    });
    const std::vector<uint64_t> before = runs_->inputs();
    for (size_t part = 0; part < question_.reach.parts; ++part) {
      runs_->SetInputs(before);
      DropContradictedFrom(runs_->After(part));
    }
    if (guesses_.size() == count) return false;
  }
}

/// After power-on a fact has to hold, too.
void Finder::DropWrongAtStart() {
  std::erase_if(guesses_, [this](const Guess& guess) {
    const terms::TermId holds = ConditionOf(guess, kAtStart);
    return !terms_.IsConst(holds) || terms_.IsFalse(holds);
  });
}

std::vector<terms::TermId> Finder::Find() {
  CloseOver();
  if (Late()) return {};
  AddRegisters();
  runs_.emplace(terms_, words_, question_.reach.parts);
  if (runs_->cost() > kMostSimulatedTerms) return {};
  LookForGreatest();
  DropClocks();
  AddGuesses();
  DropWrongAtStart();
  DropContradicted();
  if (Late() || !Prove()) return {};
  std::vector<terms::TermId> facts;
  for (const Guess& guess : guesses_) facts.push_back(ConditionOf(guess, 0));
  return facts;
}

}  // namespace

std::vector<terms::TermId> FindTimeFacts(const TimeQuestion& question) { return Finder(question).Find(); }

}  // namespace plcxx::prove::properties
