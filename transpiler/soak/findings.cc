#include "transpiler/soak/findings.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "transpiler/review/diff/shorten.h"
#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/support/check.h"
#include "transpiler/yaml/words.h"

namespace plcxx::soak {
namespace {

/// Instructions of all tries to shorten a run: some seconds, and the same everywhere.
constexpr uint64_t kMostShortening = 300'000'000;
constexpr uint32_t kWatchedMs = 10'000;  // that a message is watched for once it has come
constexpr size_t kLongestName = 60;

std::string FindingWord(const std::string& text) { return yaml::YamlWord(text, "_./"); }

/// Small letters, digits and '-', as every system takes them.
std::string Slug(const std::string& text) {
  std::string slug;
  for (const char c : text) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_letter) {
      slug += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
    }
    if (slug.size() >= kLongestName) break;
  }
  while (slug.ends_with('-')) slug.pop_back();
  return slug;
}

std::string_view WordOf(CauseKind kind) {
  switch (kind) {
    case CauseKind::kProperty:
      return "property";
    case CauseKind::kFault:
      return "fault";
    case CauseKind::kLoopGuard:
      return "loop";
    case CauseKind::kStuck:
      return "stuck";
    case CauseKind::kEndless:
      return "endless";
    case CauseKind::kMessage:
      return "message";
  }
  return "";
}

}  // namespace

std::string ScenarioOf(const scenarios::ProveMachine& machine, const compilation::CompilationRequest& request,
                       const scenarios::BoundPlant* plant, const std::string& directory, const std::string& comment,
                       const Stimuli& stimuli) {
  review::diff::WrittenSteps steps;
  for (const Stimulus& stimulus : stimuli) {
    if (stimulus.power_cycle) steps.AddPowerCycle();
    steps.Add(stimulus);
  }
  std::string text = "# " + comment + "\n" + scenarios::ScenarioHeading(machine.compilation, request, directory);
  return text + scenarios::PlantHeading(plant, directory) + "steps:\n" + steps.scenario;
}

Findings::Findings(const scenarios::ProveMachine& machine, const compilation::CompilationRequest& request,
                   const WatchPlan& plan, const MakeMachines& make, std::shared_ptr<const scenarios::BoundPlant> plant,
                   FindingPlace place)
    : machine_(machine),
      request_(request),
      plan_(plan),
      machines_(make(1)),
      plant_(std::move(plant)),
      words_(machine.compilation),
      place_(std::move(place)) {}

bool Findings::Shows(const Cause& cause, const Stimuli& stimuli) {
  if (machines_->Work(0) > most_work_) return false;
  const ir::Schedule& schedule = plan_.program().schedule;
  const auto happens = [&schedule](const Stimulus& stimulus) {
    const Stimulus as_time = AsItHappens(stimulus, schedule);
    return as_time.slow == stimulus.slow && as_time.fast == stimulus.fast;
  };
  if (!std::ranges::all_of(stimuli, happens)) return false;
  std::vector<uint8_t> given(plan_.program().insts.size());
  machines_->NoteGiven(0, given);
  machines_->PowerOn(0);
  Watch watch(plan_);
  watch.BeginFrom(*machines_, 0);
  for (const Stimulus& stimulus : stimuli) {
    if (stimulus.power_cycle) {
      machines_->PowerCycle(0);
      watch.BeginFrom(*machines_, 0);
    }
    for (const auto& word : stimulus.words) words_.Set(word, *machines_, 0);
    const Piece piece{.machine = 0, .slow = stimulus.slow, .fast = stimulus.fast, .ms = stimulus.ms};
    machines_->Run({&piece, 1}, [&](size_t, sim::Clock::Part part) { watch.AfterPart(*machines_, 0, part, given); });
    watch.AfterStep(*machines_, 0);
    const std::vector<Cause> causes = watch.TakeCauses();
    if (std::ranges::find(causes, cause.key, &Cause::key) != causes.end()) return true;
    if (machines_->EndOf(0) != PieceEnd::kDone) return false;
  }
  return cause.kind == CauseKind::kMessage && std::ranges::binary_search(machines_->ActiveMessages(0), cause.number);
}

std::string Findings::MessageStands(uint32_t number) const {
  const ir::Program& program = plan_.program();
  for (const ir::MessageBits& stretch : program.message_bits) {
    if (number < stretch.first_number || number >= stretch.first_number + stretch.count) continue;
    const uint32_t bit = number - stretch.first_number;
    const execute::CellId cell =
        plan_.cells().OfBit(stretch.space, stretch.offset + bit / 8, static_cast<uint8_t>(bit % 8));
    const scenarios::InputWord word = scenarios::WordsOf(machine_, {cell}).front();
    if (!word.name.empty() && word.cells.size() == 1) return FindingWord(word.name) + ": 1";
  }
  for (const ir::MessageWord& one : program.message_words) {
    const scenarios::InputWord word =
        scenarios::WordsOf(machine_, {execute::CellsOf(program, plan_.cells(), program.places[one.place]).front()})
            .front();
    if (!word.name.empty()) return FindingWord(word.name) + ": " + std::to_string(number);
  }
  return {};
}

std::string Findings::ExpectationOf(const Cause& cause) const {
  switch (cause.kind) {
    case CauseKind::kFault:
      return "- expect_calls: [{" + FindingWord(cause.function) + ": none}]\n";
    case CauseKind::kMessage: {
      const std::string stands = MessageStands(cause.number);
      return "- run: {ms: " + std::to_string(kWatchedMs) + "}\n" +
             (stands.empty() ? "" : "- expect: {" + stands + "}\n");
    }
    case CauseKind::kProperty:
    case CauseKind::kLoopGuard:
    case CauseKind::kStuck:
    case CauseKind::kEndless:
      return {};
  }
  return {};
}

std::string Findings::NameOf(const Cause& cause) {
  const std::string stem = std::string(WordOf(cause.kind)) + "-" +
                           Slug(cause.kind == CauseKind::kProperty  ? plan_.properties()[cause.number].text
                                : cause.kind == CauseKind::kMessage ? std::to_string(cause.number)
                                                                    : cause.text.substr(cause.text.find(' ') + 1));
  std::string name = stem + ".yaml";
  const auto is_free = [this](const std::string& one) { return !(place_.is_taken && place_.is_taken(one)); };
  for (int i = 2; !is_free(name) || !names_.insert(name).second; ++i) name = stem + "-" + std::to_string(i) + ".yaml";
  return name;
}

std::optional<Finding> Findings::Describe(const Cause& cause, const Stimuli& stimuli) {
  using review::diff::Shortener;
  most_work_ = ~uint64_t{0};
  if (!Shows(cause, stimuli)) return std::nullopt;
  most_work_ = machines_->Work(0) + kMostShortening;
  Shortener shortener([&](const Stimuli& tried,
                          Shortener::Time) { return !(place_.is_late && place_.is_late()) && Shows(cause, tried); },
                      Shortener::Time::max());
  const Stimuli shortened = shortener.Shorten(stimuli);
  Finding finding{.cause = cause, .steps = {}, .file = NameOf(cause), .yaml = {}, .not_shown = {}};
  std::string comment = cause.text + ": ";
  switch (cause.kind) {
    case CauseKind::kProperty:
    case CauseKind::kFault:
    case CauseKind::kStuck:
    case CauseKind::kEndless:
      comment += "this fails until the program has been repaired.";
      break;
    case CauseKind::kLoopGuard:
      comment += "a run that comes to it; it passes, for the guard hides what is wrong.";
      break;
    case CauseKind::kMessage:
      comment += "a run in which it comes; it passes as long as the message stands.";
      break;
  }
  std::ranges::replace(comment, '\n', ' ');
  finding.yaml = ScenarioOf(machine_, request_, plant_.get(), place_.directory, comment, shortened);
  if (cause.kind == CauseKind::kProperty) {
    const size_t at = finding.yaml.find("steps:\n");
    PLCXX_CHECK(at != std::string::npos);
    finding.yaml.insert(at, "properties:\n- " + FindingWord(plan_.properties()[cause.number].text) + "\n");
  }
  finding.yaml += ExpectationOf(cause);
  review::diff::WrittenSteps line;
  for (const Stimulus& stimulus : shortened) {
    if (stimulus.power_cycle) line.AddPowerCycle();
    line.Add(stimulus);
  }
  finding.steps = line.line;
  Confirm(finding);
  return finding;
}

void Findings::Confirm(Finding& finding) {
  // It would not end.
  if (finding.cause.kind == CauseKind::kEndless) return;
  const std::string path = (std::filesystem::path(place_.directory) / finding.file).generic_string();
  scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, finding.yaml);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    finding.not_shown = ToText(errors->front());
    return;
  }
  scenarios::ScenarioProgram program(request_);
  const scenarios::ScenarioResult ran = scenarios::TestScenario(std::get<scenarios::Scenario>(read), {}, program);
  bool shown = false;
  switch (finding.cause.kind) {
    case CauseKind::kProperty:
    case CauseKind::kFault:
    case CauseKind::kStuck:
      shown = ran.test.outcome == scenarios::TestOutcome::kFailed;
      break;
    case CauseKind::kLoopGuard:
    case CauseKind::kMessage:
      shown = ran.test.outcome == scenarios::TestOutcome::kPassed;
      break;
    case CauseKind::kEndless:
      return;
  }
  if (shown) return;
  finding.not_shown = ran.test.outcome == scenarios::TestOutcome::kPassed
                          ? "plcxx test does not show it"
                          : ran.test.text.substr(0, ran.test.text.find('\n'));
}

}  // namespace plcxx::soak
