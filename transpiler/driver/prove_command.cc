// plcxx prove: properties of the machine, for all inputs and all scans.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/own_files.h"
#include "transpiler/driver/plant_choice.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/property_choice.h"
#include "transpiler/driver/prove_output.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/review/properties/coarse_runs.h"
#include "transpiler/review/properties/runs.h"
#include "transpiler/scenarios/pass_machine.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

constexpr const char* kProveFooter =
    R"(Properties, one a line ('#' begins a comment); locations are written as in scenarios:
  never U4A8 and U4A9                      not both, after any period
  at most one of U4A8, U4A9, U4A10         (or: exactly one of)
  W10K3 in 0..12                           (also = != < <= > >=, and 'is', 'is not')
  never bit 0 of W2K0 and bit 1 of W2K0    bits of a word, the least significant one is 0
  I0K1 implies U21K8 is 0 within 1 slow    soon enough for 'set: {I0K1: 1}, run: {slow: 1}'; without 'within': at once
  I0K1 for 3000 ms implies U4A8            once I0K1 has stood so long
  (I0K1 and not I0K2) for 3000 ms implies U4A8
                                           brackets: 'for' is about what stands right before it
  U4A8 is never stuck within 20 slow       from every state some inputs make it 1, and some make it 0, in that time

What is looked at is the state after each period, for all inputs, from power-on with all memory 0. Times are counted in
slow passes, fast passes or ms, which are rounded up to periods. Where the slow part is cut into slices (nc110) the state
after the last of them is looked at, and inputs change before each of them.

What a verdict claims:
  proved         it holds in every run from there, whatever inputs and the control do (--any-retentive: with any memory kept)
  VIOLATED       in the run that is shown, which was executed
  not decided    nothing, and it is no success: more --time, a scenario near it, or a simpler property
It does not claim that the property says what the machine needs (a note says where it says little), nor anything of
moments inside of a period, of the compiled code (plcxx verify), of terminals and host functions.

--plant lets the machine move in runs that are tried: a violation that it shows is preferred to one that only inputs show
which it does not give. What is proved is proved for every input all the same, whatever the plant does.

A violated property comes with a scenario, run before it is shown: with --counterexamples it is written to a file that
'plcxx test' runs. 'properties:' in a scenario is a list of properties; 'plcxx test' watches them while the steps run.

Examples:
  plcxx prove                                              the properties that plcxx.yaml names
  plcxx prove turret.sym turret.plc --property turret.prop
  plcxx prove --plant project                              runs with the plant of plcxx.yaml come first
  plcxx prove turret.yaml                                  sources, options and properties of a scenario
  plcxx prove turret.plc --property turret.prop --counterexamples failing --junit proofs.xml

Exit codes: 0 all proved, 1 a property is violated or not decided, or the program has errors, 2 wrong use.)";

/// Of all programs.
struct ProveReport {
  uint32_t programs_without_properties = 0, programs_with = 0;
  std::vector<scenarios::TestCase> cases;  // for --junit
  std::vector<std::string> protected_paths;
};

struct ProveSettings {
  CommonOptions common;
  std::vector<std::string> files;
  std::string form = "text", junit, counterexamples, time = "60s";
  std::string plant;  // a file, or kPlantOfProject; empty: nothing moves by itself
  uint32_t most_periods = 50;
  bool any_retentive = false;
  std::shared_ptr<ProveReport> report;
};

std::optional<uint64_t> Milliseconds(const std::string& text) {
  size_t digits = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') ++digits;
  constexpr size_t kMostDigits = 7;
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  const uint64_t number = std::stoull(text.substr(0, digits));
  const std::string unit = text.substr(digits);
  if (number == 0) return std::nullopt;
  if (unit == "ms") return number;
  if (unit == "s") return number * 1000;
  if (unit == "min") return number * 60'000;
  return std::nullopt;
}

class Prove {
 public:
  explicit Prove(const ProveSettings& settings) : settings_(settings) { chosen_.files = settings.files; }

  int Run() {
    const std::optional<uint64_t> time = Milliseconds(settings_.time);
    if (!time) return UsageError("'--time " + settings_.time + "' is no time: write it as in 60s, 500ms or 5min");
    options_.time_ms = *time;
    options_.most_periods = settings_.most_periods;
    if (settings_.any_retentive) options_.retentive = prove::properties::RetentiveMemory::kAny;
    if (!ChooseProperties(settings_.common, chosen_)) return kWrongUse;
    request_ = chosen_.request;
    if (!settings_.common.program && IsScenario(settings_.common) && chosen_.scenarios.back().properties.empty() &&
        settings_.files.empty()) {
      return UsageError(chosen_.scenarios.back().path + ": no 'properties': there is nothing to prove");
    }
    if (chosen_.scenarios.empty() && chosen_.files.empty()) return SayNothingToProve();
    ++settings_.report->programs_with;
    scenarios::MakeProveMachine(request_, machine_);
    compilation::Compilation& compilation = machine_.compilation;
    if (!compilation.ok()) {
      PrintDiagnosticsBeside(compilation, MessagesOf(settings_.common));
      return ExitCodeOf(compilation);
    }
    if (!compilation.has_program)
      return UsageError("the sources are data only: there is no program to prove anything of");
    if (const int code = ReadProperties(chosen_, settings_.common, machine_, properties_); code != kDone) return code;
    for (const scenarios::PlacedProperty& placed : properties_) scenarios::NameLocationsOf(placed.property, machine_);
    const auto plant = ChooseSearchPlant(settings_.plant, settings_.common, compilation);
    if (!plant) return kWrongUse;
    plant_ = *plant;
    if (plant_) review::properties::NameReadsOf(*plant_, machine_);
    progress_.Show("executing");
    const auto known = scenarios::KnownRuns(request_);
    review::properties::PropertyRuns runs(machine_, known);
    review::properties::CoarseRuns coarse_runs(machine_);
    options_.slices = machine_.slices;
    if (machine_.slices > 1) {
      options_.check_in_slices = [this](const prove::properties::Property& property, uint64_t milliseconds) {
        return CheckInSlices(property, milliseconds);
      };
    }
    options_.try_runs = [&](const prove::properties::RunSearch& search) {
      // Where most periods do nothing, runs are computed in which something happens in each of them.
      prove::properties::RunSearch rest = search;
      if (search.thorough && coarse_runs.AreUseful()) {
        const uint64_t share = search.milliseconds / 2;
        if (auto found = coarse_runs.Find(*search.property, share)) return found;
        rest.milliseconds -= share;
      }
      return runs.Find(rest);
    };
    std::optional<review::properties::PropertyRuns> planted;
    if (plant_) {
      planted.emplace(machine_, known, plant_);
      options_.planted.reads = review::properties::ReadsOf(*plant_, machine_);
      options_.planted.try_runs = [&planted](const prove::properties::RunSearch& search) {
        return planted->Find(search);
      };
    }
    options_.why_not_shown = [this](const prove::properties::Property& property,
                                    const prove::properties::PropertyResult& result) {
      replayed_.push_back(
          review::properties::MakePropertyScenario(machine_, request_, property, result, PlaceOfNext()));
      return replayed_.back().reason;
    };
    options_.progress = [this](const std::string& what) {
      progress_.Show("property " + std::to_string(proved_.size() + 1) + " of " + std::to_string(properties_.size()) +
                     ": " + what);
    };
    prove::properties::PropertyChecker checker(machine_.version, options_);
    if (!checker.refusal().empty()) {
      return UsageError("nothing can be proved: " + checker.refusal());
    }
    for (scenarios::PlacedProperty& placed : properties_) Check(checker, std::move(placed));
    return Finish();
  }

 private:
  /// One program without properties does not keep those of the others from being proved.
  int SayNothingToProve() const {
    constexpr const char* kRemedy =
        "name a file of properties with --property, a scenario that has some, or 'properties' in plcxx.yaml";
    if (!settings_.common.is_one_of_several) return UsageError(std::string("there is nothing to prove: ") + kRemedy);
    ++settings_.report->programs_without_properties;
    std::cerr << "note: " << diag::Escaped(project::NameOf(*settings_.common.program))
              << ": there is nothing to prove: it has no 'properties' in plcxx.yaml\n";
    return kDone;
  }

  review::properties::ScenarioPlace PlaceOfNext() const {
    const std::string folder = FolderOf(settings_.common, settings_.counterexamples);
    std::set<std::string> names;  // those of this run have their numbers
    return {.directory = folder,
            .name = FreeName(folder, "property-" + std::to_string(proved_.size() + 1), kViolationHead, names),
            .plant = plant_.get()};
  }

  void Check(prove::properties::PropertyChecker& checker, scenarios::PlacedProperty placed) {
    const std::string number = std::to_string(proved_.size() + 1);
    ProvedProperty proved{.placed = std::move(placed), .result = {}, .scenario = {}, .file = {}, .plant = {}};
    if (plant_) proved.plant = PlantName(*plant_);
    replayed_.clear();
    const prove::properties::Property& property = proved.placed.property;
    progress_.Show("property " + number + " of " + std::to_string(properties_.size()) + ": " + property.text);
    proved.result = checker.Check(property);
    if (plant_ && proved.result.verdict == prove::properties::PropertyVerdict::kProved) RemarkOnPlant(proved.result);
    if (proved.result.run) proved.scenario = std::move(replayed_.at(proved.result.replay));
    if (proved.result.verdict == prove::properties::PropertyVerdict::kViolated && !settings_.counterexamples.empty()) {
      const review::properties::ScenarioPlace place = PlaceOfNext();
      proved.file = (std::filesystem::path(place.directory) / place.name).generic_string();
    }
    progress_.Clear();
    if (settings_.form == "text") {
      const Colours colours = ShowsColours(Stream::kOutput) ? Colours::kTerminal : Colours::kNone;
      std::cout << ProveText(proved, colours) << std::flush;
    }
    proved_.push_back(std::move(proved));
  }

  /// What the checks slice by slice share is executed once, when the first property asks for it.
  void MakePass() {
    pass_ = std::make_unique<scenarios::PassMachine>();
    scenarios::MakePassMachine(request_, *pass_);
    if (!pass_->refusal.empty()) return;
    prove::properties::CheckOptions options{
        .most_periods = options_.most_periods, .retentive = options_.retentive, .progress = options_.progress};
    options.why_not_shown = [this](const prove::properties::Property&,
                                   const prove::properties::PropertyResult& result) {
      prove::properties::PropertyResult of_slices = result;
      of_slices.run = scenarios::FromPass(*result.run, machine_, *pass_);
      return options_.why_not_shown(*in_slices_, of_slices);
    };
    pass_checker_ = std::make_unique<prove::properties::PropertyChecker>(pass_->version, std::move(options));
    pass_->refusal = pass_checker_->refusal();
  }

  /// The same with inputs that change between the slices.
  prove::properties::PropertyResult CheckInSlices(const prove::properties::Property& property, uint64_t milliseconds) {
    prove::properties::PropertyResult result;
    if (!pass_) MakePass();
    result.reason = pass_->refusal;
    if (!result.reason.empty()) return result;
    in_slices_ = &property;
    const auto first = static_cast<uint32_t>(replayed_.size());
    result = pass_checker_->Check(scenarios::InPass(property, machine_, *pass_), milliseconds);
    if (result.run) {
      result.run = scenarios::FromPass(*result.run, machine_, *pass_);
      result.replay += first;
    }
    return result;
  }

  /// A proof is about all inputs, and about nothing else that a plant may write.
  void RemarkOnPlant(prove::properties::PropertyResult& result) const {
    const std::vector<std::string> beside = review::properties::DrivenBesideInputs(*plant_, machine_);
    if (beside.empty()) return;
    std::string names;
    for (const std::string& name : beside) names += (names.empty() ? "'" : ", '") + name + "'";
    result.remark += (result.remark.empty() ? "the plant drives " : "; the plant drives ") + names +
                     ", which is no input: of what it does there nothing is proved";
  }

  int Finish() {
    const std::string plant = plant_ ? PlantName(*plant_) : "";
    if (settings_.form == "json") {
      std::cout << ProveJson(proved_, plant);
    } else {
      std::cout << ProveSummary(proved_, plant) << "\n";
    }
    OutputRequest output;
    output.protected_paths = PathsRead(machine_.compilation, settings_.common);
    for (const scenarios::Scenario& scenario : chosen_.scenarios) output.protected_paths.push_back(scenario.path);
    for (const std::string& path : chosen_.files) output.protected_paths.push_back(path);
    if (plant_) output.protected_paths.push_back(plant_->model().path());
    std::ranges::copy(ProveCases(proved_), std::back_inserter(settings_.report->cases));
    std::ranges::copy(output.protected_paths, std::back_inserter(settings_.report->protected_paths));
    for (const ProvedProperty& proved : proved_) {
      if (!proved.file.empty()) output.files.push_back({proved.file, proved.scenario.yaml});
    }
    if (const auto failure = WriteWithFolders(output)) return CannotWrite(*failure);
    for (const ProvedProperty& proved : proved_) {
      if (proved.result.verdict != prove::properties::PropertyVerdict::kProved) return kProgramHasErrors;
    }
    return kDone;
  }

  const ProveSettings& settings_;
  prove::properties::CheckOptions options_;
  compilation::CompilationRequest request_;
  ChosenProperties chosen_;
  scenarios::ProveMachine machine_;
  std::unique_ptr<scenarios::PassMachine> pass_;                      // of a program with slices, once it was asked for
  std::unique_ptr<prove::properties::PropertyChecker> pass_checker_;  // none where that is refused
  const prove::properties::Property* in_slices_ = nullptr;            // that is checked there
  ProgressLine progress_;
  std::vector<scenarios::PlacedProperty> properties_;
  std::vector<ProvedProperty> proved_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;  // may be none
  /// Of the property at hand: of each run that was shown, or was not.
  std::vector<review::properties::PropertyScenario> replayed_;
};

int RunProve(const ProveSettings& settings) { return Prove(settings).Run(); }

int RunProveOf(ProveSettings settings) {
  const std::string scenario = settings.counterexamples.empty() ? "" : PathIn(settings.counterexamples, "found.yaml");
  if (!CanBeWritten({settings.junit, scenario})) return kWrongUse;
  settings.report = std::make_shared<ProveReport>();
  const int code = RunForPrograms(settings, RunProve, settings.form == "json" ? Result::kJson : Result::kUnnamed);
  if (code == kDone && settings.report->programs_with == 0 && settings.report->programs_without_properties > 0) {
    return UsageError(
        "no program of the project has properties: name a file of them with --property, or 'properties' in plcxx.yaml");
  }
  if (settings.junit.empty() || settings.report->protected_paths.empty()) return code;
  const auto failure =
      WriteWithFolders({.directory = {},
                        .files = {{settings.junit, JunitXml(settings.report->cases, JunitOf::kProperties)}},
                        .protected_paths = settings.report->protected_paths,
                        .named = {settings.junit}});
  return failure ? std::max(code, CannotWrite(*failure)) : code;
}

}  // namespace

void AddProve(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("prove", "Prove properties of the machine for all inputs and all scans");
  const auto settings = std::make_shared<ProveSettings>();
  AddCommonOptions(*command, settings->common);
  command
      ->add_option("--property", settings->files,
                   "A file of properties, one a line, instead of those of plcxx.yaml; may stand several times")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--plant", settings->plant,
                   "Try runs with this plant moving first; 'project': that of plcxx.yaml. Proofs stay for all inputs")
      ->type_name("FILE");
  command
      ->add_option("--counterexamples", settings->counterexamples,
                   "Write a scenario for each violated property into this directory")
      ->type_name("DIR");
  command->add_option("--time", settings->time, "For one property, as in 500ms, 60s or 5min")
      ->type_name("TIME")
      ->default_str("60s");
  command->add_option("--depth", settings->most_periods, "Periods of the longest run, and of the longest induction")
      ->type_name("N")
      ->default_str("50")
      ->check(CLI::Range(1, 10000));
  command->add_flag("--any-retentive", settings->any_retentive,
                    "Retentive memory holds anything at power-on, instead of 0");
  command->add_option("--format", settings->form, "Form of the result: text, json")
      ->type_name("FORM")
      ->default_str("text")
      ->check(OneOf({"text", "json"}));
  command->add_option("--junit", settings->junit, "Write the results as JUnit XML, each property a test")
      ->type_name("FILE");
  command->footer(kProveFooter);
  command->callback([settings, &run] { run = [settings] { return RunProveOf(*settings); }; });
}

}  // namespace plcxx::driver
