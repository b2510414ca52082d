#include "transpiler/soak/steering.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/scenarios/control.h"

namespace plcxx::soak {
namespace {

constexpr uint64_t kManyInputs = 6;
constexpr size_t kNewest = 16;

}  // namespace

terms::Random RandomOf(uint64_t chance) {
  chance = (chance ^ chance >> 30) * 0xBF58476D1CE4E5B9;
  chance = (chance ^ chance >> 27) * 0x94D049BB133111EB;
  return terms::Random((chance ^ chance >> 31) | 1);
}

Beginning ChooseBeginning(const Known& known, terms::Random& random) {
  const uint64_t from = random.Next() % 16;
  if (from % 4 == 3 && !known.standing.empty()) {
    // What makes it go, if anything does?
    const Standing& standing = known.standing[random.Next() % known.standing.size()];
    return {.from = standing.entry, .sought = standing.writers.empty() ? nullptr : &standing.writers};
  }
  if (from >= 4 && !known.entries.empty()) {
    // The newest more often: they have seen what nothing else has.
    const size_t count = known.entries.size();
    const size_t among = random.OneIn(2) ? count : std::min(count, kNewest);
    return {.from = known.entries[count - 1 - random.Next() % among]};
  }
  if (from == 0 || known.scenarios.empty()) return {};
  return {.from = nullptr, .scenario = &known.scenarios[random.Next() % known.scenarios.size()]};
}

uint64_t ChooseValue(const Known& known, uint32_t number, sim::Engine& machine, terms::Random& random) {
  const Input& input = known.inputs.all()[number];
  const uint64_t now = input.location.cell ? 0 : scenarios::ReadLocation(machine, input.location);
  return known.inputs.ValueFor(input, now, random);
}

void ChooseTime(const Known& known, terms::Random& random, Stimulus& stimulus) {
  const ir::Schedule& schedule = known.plan.program().schedule;
  const uint64_t what = random.Next() % 16;
  if (what < 2) {
    const std::vector<uint32_t>& waits = known.inputs.waits_ms();
    stimulus.ms = waits[random.Next() % waits.size()];
  } else if (what == 2 && schedule.fast_done.valid()) {
    stimulus.fast = 1;
  } else if (what < 6) {
    stimulus.ms = std::max(1U, schedule.period_ms);
  } else {
    stimulus.slow = 1 + static_cast<uint32_t>(random.OneIn(4) ? random.Next() % 12 : 0);
  }
}

const Stimulus* PickOtherStep(const Known& known, terms::Random& random) {
  if (known.scenarios.empty() || !random.OneIn(8)) return nullptr;
  const Stimuli& other = known.scenarios[random.Next() % known.scenarios.size()];
  return &other[random.Next() % other.size()];
}

void PutWord(Stimulus& stimulus, std::pair<std::string, std::string> word) {
  // A scenario may set it several times before time passes; the last one counts.
  const auto same = std::ranges::find(stimulus.words.rbegin(), stimulus.words.rend(), word.first,
                                      &std::pair<std::string, std::string>::first);
  if (same == stimulus.words.rend()) {
    stimulus.words.push_back(std::move(word));
  } else {
    *same = std::move(word);
  }
}

void ChooseInputs(const Known& known, const std::vector<uint32_t>* sought, terms::Random& random,
                  const std::function<void(uint32_t input)>& set) {
  const std::vector<Input>& inputs = known.inputs.all();
  if (inputs.empty()) return;
  const bool all_done = random.OneIn(2);
  for (uint32_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].is_request && all_done && random.OneIn(4)) set(i);
  }
  if ((sought != nullptr || !known.open.empty()) && random.OneIn(2)) {
    const ir::StatementId goal = sought != nullptr ? ir::StatementId((*sought)[random.Next() % sought->size()])
                                                   : known.open[random.Next() % known.open.size()];
    for (uint64_t i = 1 + random.Next() % 4; i > 0; --i) {
      if (const std::optional<uint32_t> input = known.inputs.Towards(goal, random)) {
        set(*input);
      }
    }
  } else if (random.OneIn(kManyInputs)) {
    const uint64_t one_in = uint64_t{2} << random.Next() % 5;
    for (uint32_t i = 0; i < inputs.size(); ++i) {
      if (random.OneIn(one_in)) set(i);
    }
  } else {
    for (uint64_t i = random.Next() % 4; i > 0; --i) {
      set(static_cast<uint32_t>(random.Next() % inputs.size()));
    }
  }
}

Stimulus AsItHappens(Stimulus stimulus, const ir::Schedule& schedule) {
  const bool slow_alone = schedule.fast_ms != 0, fast_alone = !schedule.fast_done.valid();
  const uint32_t period = std::max(1U, schedule.period_ms);
  if (stimulus.slow != 0 && slow_alone) {
    stimulus.ms = stimulus.slow * period;
    stimulus.slow = stimulus.fast = 0;
  } else if (stimulus.slow == 0 && stimulus.fast != 0 && fast_alone) {
    // It runs once in a period, or has its own.
    stimulus.ms = stimulus.fast * (schedule.fast_ms != 0 ? schedule.fast_ms : period);
    stimulus.fast = 0;
  }
  return stimulus;
}

}  // namespace plcxx::soak
