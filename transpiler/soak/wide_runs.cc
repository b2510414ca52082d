#include "transpiler/soak/wide_runs.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <unordered_map>
#include <utility>

#include "transpiler/fleet/fleet.h"
#include "transpiler/fleet/lane.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/soak/wide_fleets.h"

namespace plcxx::soak {
namespace {

constexpr uint64_t kMostParts = 20'000;    // of each machine
constexpr uint64_t kMostBefore = 400'000;  // parts up to the moment where a run begins
constexpr size_t kMostPromises = 16;       // of a run
constexpr size_t kMostNews = 4;            // of a step

/// What one machine did in a step, beside the time that all of them have in common.
struct Done {
  const Stimulus* words = nullptr;                    // of a scenario; may be none
  std::vector<std::pair<uint32_t, uint64_t>> inputs;  // by number, with their values
};

/// What surrounds one lane.
struct Machine {
  Machine(const WideProgram& program, fleet::Fleet& fleet, unsigned number)
      : lane(fleet, number, program.host_only),
        control(program.compilation.program, *program.compilation.dialect, lane,
                scenarios::StubOf(program.compilation)) {
    control.LookAway();
    if (program.plant) control.Attach(program.plant);
  }
  fleet::Lane lane;
  scenarios::ScenarioControl control;
  terms::Random random{1};
  std::vector<Done> done;  // since the run began
};

}  // namespace

std::variant<std::shared_ptr<const WideProgram>, std::string> CompileWide(
    const compilation::Compilation& compilation, std::shared_ptr<const scenarios::BoundPlant> plant, const Goals& goals,
    const WatchPlan& plan, const fleet::LibraryRequest& request) {
  auto program = std::make_shared<WideProgram>(WideProgram{.compilation = compilation,
                                                           .plant = std::move(plant),
                                                           .noted = NoteReached(goals, plan),
                                                           .host_only = {},
                                                           .library = {}});
  fleet::LibraryOrFailure compiled = fleet::CompileFleet(program->noted.program, request);
  if (auto* const failure = std::get_if<std::string>(&compiled)) return std::move(*failure);
  program->host_only = fleet::FindHostOnly(program->noted.program);
  program->library = std::get<std::shared_ptr<const fleet::Library>>(std::move(compiled));
  return std::shared_ptr<const WideProgram>(std::move(program));
}

class WideMachines::Herd {
 public:
  explicit Herd(std::shared_ptr<const WideProgram> program)
      : program_(std::move(program)),
        fleets_(program_->library, kWideMachines),
        clock_(program_->noted.program, {&fleets_}),
        has_control_(scenarios::StubOf(program_->compilation) != nullptr || program_->plant != nullptr) {
    uint32_t first = 0;
    for (const auto& fleet : fleets_.all()) {
      for (unsigned lane = 0; lane < fleet->lanes(); ++lane) {
        machines_.push_back(std::make_unique<Machine>(*program_, *fleet, lane));
      }
      fleet->AnswerHostCalls([this, first](const fleet::FleetCall& call) { Answer(call, first); });
      first += fleet->lanes();
    }
    new_ = std::make_unique<scenarios::ScenarioControl::Saved>(machines_.front()->control.Save());
    clock_.before_period = [this](uint32_t now_ms) {
      for (size_t i = 0; has_control_ && i < awake_; ++i) machines_[i]->control.BeforePeriod(now_ms);
    };
    clock_.after_period = [this](uint32_t now_ms) {
      ++parts_;
      if (awake_ > 1) LookAtOutputs();
      for (size_t i = 0; has_control_ && i < awake_; ++i) machines_[i]->control.AfterPeriod(now_ms);
    };
    clock_.interrupted = [this] { return parts_ >= most_parts_ || (is_late_ && parts_ % 256 == 0 && is_late_()); };
  }

  WideResult Run(const Known& known, Words& words, const WideRequest& request) {
    is_late_ = request.is_late;
    const Beginning start = Begin(known, words, request.run);
    for (uint32_t i = 0; i < machines_.size(); ++i) machines_[i]->random = RandomOf(request.of_machine(i));
    FindOpen(known, start);
    BeginOutputs(known.plan);
    WideResult result;
    terms::Random random = RandomOf(request.run);
    const Stimuli* const scenario = start.scenario;
    const uint64_t most_ms = request.most_ms;
    size_t next_step = 0;
    parts_ = 0;
    most_parts_ = kMostParts;
    steps_.clear();
    uint64_t time_ms = clock_.time_ms();
    for (size_t step = 0; step < kMostSteps && result.machine_ms < most_ms * kWideMachines; ++step) {
      const Stimulus* const follows =
          scenario != nullptr && next_step < scenario->size() ? &(*scenario)[next_step] : nullptr;
      Stimulus common = follows != nullptr ? *follows : Stimulus{};
      common.words.clear();
      if (follows != nullptr && !random.OneIn(4)) ++next_step;
      if (common.slow == 0 && common.fast == 0 && common.ms == 0) ChooseTime(known, random, common);
      common.power_cycle = common.power_cycle || random.OneIn(kMostSteps);
      common = AsItHappens(std::move(common), known.plan.program().schedule);
      const uint64_t period = std::max(1U, known.plan.program().schedule.period_ms);
      const uint64_t left = request.left_ms - std::min(request.left_ms, result.machine_ms / kWideMachines);
      if (common.ms > left) common.ms = static_cast<uint32_t>((left + period - 1) / period * period);
      steps_.push_back(common);
      if (common.power_cycle) time_ms = 0;
      const sim::Step ended = Step(known, words, start.sought, follows, common);
      const uint64_t now = clock_.time_ms();
      result.machine_ms += (now - std::min(now, time_ms)) * kWideMachines;
      result.steps += kWideMachines;
      time_ms = now;
      TakeNews(known, start, result);
      // The scheduler is the same in all machines.
      if (ended == sim::Step::kStuck && !known.causes.contains(WatchPlan::StuckCause(PieceEnd::kStuck).key)) {
        result.promises.push_back({start.from, StimuliOf(known, *machines_.front()), {}});
      }
      if (ended != sim::Step::kDone || result.promises.size() >= kMostPromises) break;
    }
    result.parts = parts_ * kWideMachines;
    result.outputs = std::move(outputs_);
    return result;
  }

 private:
  /// All machines come to where it begins.
  Beginning Begin(const Known& known, Words& words, uint64_t chance) {
    terms::Random random = RandomOf(~chance);
    Beginning start = ChooseBeginning(known, random);
    // One machine comes there, and all others become what it is.
    writes_.clear();
    fleets_.RunFirstAlone(true);
    awake_ = 1;
    Machine& first = *machines_.front();
    PowerOn(first);
    if (start.from && !GoTo(*start.from, known, words, first)) {
      start.from = nullptr;
      PowerOn(first);
    }
    fleets_.BecomeFirst();
    const scenarios::ScenarioControl::Saved saved = first.control.Save();
    for (const auto& machine : machines_) {
      if (machine.get() != &first) {
        machine->control.Restore(saved);
        machine->lane.BecomeLike(first.lane);
      }
      machine->done.clear();
    }
    fleets_.RunFirstAlone(false);
    awake_ = machines_.size();
    return start;
  }

  /// For the first time.
  void PowerOn(Machine& first) {
    fleets_.all().front()->ForgetRetentive();
    first.control.Restore(*new_);
    first.lane.PowerOn();
    clock_.PowerOn();
    first.control.PowerOn();
  }

  /// False: it is too far.
  bool GoTo(const Entry& entry, const Known& known, Words& words, Machine& first) {
    parts_ = 0;
    most_parts_ = kMostBefore;
    return std::ranges::all_of(entry.stimuli, [&](const Stimulus& stimulus) {
      if (stimulus.power_cycle) PowerCycle();
      Set(words, stimulus, first);
      return RunFor(AsItHappens(stimulus, known.plan.program().schedule)) == sim::Step::kDone;
    });
  }

  /// Bits of outputs that were not seen both ways in this run; of all fleets.
  void BeginOutputs(const WatchPlan& plan) {
    outputs_ = {};
    outputs_.ones.resize(plan.outputs().size());
    outputs_.zeros.resize(plan.outputs().size());
    unmoved_.clear();
    for (uint32_t i = 0; i < plan.outputs().size(); ++i) {
      const WatchPlan::OutputByte& byte = plan.outputs()[i];
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if ((byte.mask >> bit & 1) == 0) continue;
        ir::Place place{.type = ir::Type::kBit, .space = byte.space};
        place.offset = byte.offset;
        place.bit = bit;
        unmoved_.push_back({i, place});
      }
    }
  }

  void LookAtOutputs() {
    std::erase_if(unmoved_, [this](const OutputBit& output) {
      const WideFleets::Values values = fleets_.ValuesOf(output.place);
      const auto mask = static_cast<uint8_t>(1U << output.place.bit);
      uint8_t& seen_ones = outputs_.ones[output.number];
      uint8_t& seen_zeros = outputs_.zeros[output.number];
      if (values.one) seen_ones |= mask;
      if (values.zero) seen_zeros |= mask;
      return (seen_ones & seen_zeros & mask) != 0;
    });
  }

  /// What was noted on the way to where it begins is no news.
  void FindOpen(const Known& known, const Beginning& start) {
    open_.clear();
    const NotedProgram& noted = program_->noted;
    for (uint32_t i = 0; i < noted.marks.size(); ++i) {
      const Mark& mark = noted.marks[i];
      const bool is_known = mark.property ? known.causes.contains(known.plan.PropertyCause(*mark.property).key)
                                          : (known.given[mark.inst.index] & mark.given) != 0;
      const bool was_noted = start.from && fleets_.IsSet(0, noted.PlaceOf(i));
      if (!is_known && !was_noted) open_.push_back(i);
    }
  }

  sim::Step Step(const Known& known, Words& words, const std::vector<uint32_t>* sought, const Stimulus* follows,
                 const Stimulus& common) {
    if (common.power_cycle) PowerCycle();
    const std::vector<Input>& inputs = known.inputs.all();
    for (const auto& one : machines_) {
      Machine& machine = *one;
      Done& done = machine.done.emplace_back();
      done.words = follows != nullptr ? follows : PickOtherStep(known, machine.random);
      if (done.words != nullptr) Set(words, *done.words, machine);
      if (follows != nullptr && !machine.random.OneIn(3)) continue;
      ChooseInputs(known, sought, machine.random, [&](uint32_t number) {
        const uint64_t value = ChooseValue(known, number, machine.lane, machine.random);
        const auto same = std::ranges::find(done.inputs, number, &std::pair<uint32_t, uint64_t>::first);
        if (same == done.inputs.end()) {
          done.inputs.emplace_back(number, value);
        } else {
          same->second = value;
        }
      });
      for (const auto& [number, value] : done.inputs) machine.control.Set(inputs[number].location, value);
    }
    return RunFor(common);
  }

  /// What a machine did, as others can do it.
  Stimuli StimuliOf(const Known& known, const Machine& machine) const {
    Stimuli stimuli;
    for (size_t i = 0; i < machine.done.size(); ++i) {
      const Done& done = machine.done[i];
      Stimulus& stimulus = stimuli.emplace_back(steps_[i]);
      if (done.words != nullptr) stimulus.words = done.words->words;
      for (const auto& [number, value] : done.inputs) {
        const Input& input = known.inputs.all()[number];
        PutWord(stimulus, {input.name, Inputs::TextOf(input, value)});
      }
    }
    return stimuli;
  }

  sim::Step RunFor(const Stimulus& time) { return clock_.RunFor(time.slow, time.fast, time.ms); }

  void PowerCycle() {
    for (size_t i = 0; i < awake_; ++i) {
      machines_[i]->control.PowerOff();
      machines_[i]->lane.PowerOn();
    }
    clock_.PowerCycle();
    for (size_t i = 0; i < awake_; ++i) machines_[i]->control.PowerOn();
  }

  /// Words of scenarios and moments, which live as long as the run.
  void Set(Words& words, const Stimulus& stimulus, Machine& machine) {
    const auto [at, is_new] = writes_.try_emplace(&stimulus);
    for (size_t i = 0; is_new && i < stimulus.words.size(); ++i) {
      const std::optional<Words::Write> write = words.Find(stimulus.words[i]);
      if (write) at->second.push_back({*write, &stimulus.words[i].second});
    }
    for (const auto& [write, text] : at->second) {
      if (write.location->text_input) {
        machine.lane.SendText(*text);
      } else {
        machine.control.Set(*write.location, write.value);
      }
    }
  }

  void Answer(const fleet::FleetCall& call, uint32_t first) {
    const ir::HostFunction& function = program_->noted.program.host_functions[call.function];
    std::vector<uint64_t> arguments(function.parameters.size());
    for (unsigned word = 0; word < call.lanes / 64; ++word) {
      for (uint64_t left = call.mask[word]; left != 0; left &= left - 1) {
        const unsigned lane = 64 * word + static_cast<unsigned>(std::countr_zero(left));
        if (first + lane >= awake_) return;
        for (size_t a = 0; a < arguments.size(); ++a) arguments[a] = call.arguments[a * call.lanes + lane];
        const sim::HostAnswer answer = machines_[first + lane]->lane.Answer(call.function, arguments);
        if (call.results != nullptr) call.results[lane] = answer.result;
        if (call.seconds != nullptr) call.seconds[lane] = answer.out.value_or(0);
        if (answer.out) call.has_second[word] |= uint64_t{1} << (lane % 64);
      }
    }
  }

  /// Of the machines with something new as many as have all of it; what one has needs no other.
  void TakeNews(const Known& known, const Beginning& start, WideResult& result) {
    const NotedProgram& noted = program_->noted;
    size_t taken = 0;
    for (size_t i = 0; i < open_.size() && taken < kMostNews && result.promises.size() < kMostPromises;) {
      const std::optional<size_t> machine = fleets_.FirstWith(noted.PlaceOf(open_[i]));
      if (!machine) {
        ++i;
        continue;
      }
      result.promises.push_back({start.from, StimuliOf(known, *machines_[*machine]), open_[i]});
      ++taken;
      std::erase_if(open_, [&](uint32_t mark) { return fleets_.IsSet(*machine, noted.PlaceOf(mark)); });
    }
  }

  std::shared_ptr<const WideProgram> program_;
  WideFleets fleets_;
  sim::Clock clock_;
  bool has_control_;
  std::vector<std::unique_ptr<Machine>> machines_;
  std::unique_ptr<const scenarios::ScenarioControl::Saved> new_;
  size_t awake_ = 0;  // machines, the first ones
  std::vector<uint32_t> open_;
  Stimuli steps_;  // of the run, without words
  std::unordered_map<const Stimulus*, std::vector<std::pair<Words::Write, const std::string*>>>
      writes_;  // looked up only
  struct OutputBit {
    uint32_t number;  // of its byte in WatchPlan::outputs
    ir::Place place;
  };
  std::vector<OutputBit> unmoved_;
  OutputLife outputs_;
  std::function<bool()> is_late_;
  uint64_t parts_ = 0, most_parts_ = 0;
};

WideMachines::WideMachines(std::shared_ptr<const WideProgram> program)
    : herd_(std::make_unique<Herd>(std::move(program))) {}
WideMachines::~WideMachines() = default;

WideResult WideMachines::Run(const Known& known, Words& words, const WideRequest& request) {
  return herd_->Run(known, words, request);
}

}  // namespace plcxx::soak
