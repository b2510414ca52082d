// plcxx soak: machine-hours with inputs that nobody meant.
#include "transpiler/driver/soak_command.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/end_request.h"
#include "transpiler/driver/engine_choice.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/jobs.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/own_files.h"
#include "transpiler/driver/plant_choice.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/property_choice.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/soak_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/soak/kept_runs.h"
#include "transpiler/soak/simulated_machines.h"

namespace plcxx::driver {
namespace {

constexpr const char* kSoakFooter =
    R"(What is looked for: faults that the program reports, properties that do not hold, loops that their guard ends, parts that
do not end, messages that never go, outputs that never move. Each finding becomes a short scenario. Inputs are what the
program's side never writes; where they go is steered to statements and conditions that were not reached, beginning with
the scenarios beside the program and with the runs that -o has kept of earlier times.

The same seed, machines and hours give the same bytes, whatever --jobs is; with --time it depends on the machine. Ctrl+C and
SIGTERM end it as its time does, and all that was found is kept.

Examples:
  plcxx soak                                           an hour of 16 machines of the program of the plcxx.yaml here
  plcxx soak --engine fleet --for 1000h                1,024 machines, most of them side by side in one processor
  plcxx soak --for 100h --jobs 8 -o soak               and what is found, and worth keeping, in the folder
  plcxx soak lathe.sym lathe.plc --property safe.prop  these sources, these properties
  plcxx soak --plant project                           the machine moves as its plant does, the operator as nobody would
  plcxx soak --for 100h --shard 2/8 -o soak-2          the second of eight parts of the same work
  plcxx soak --merge soak soak-1 soak-2                taken together

docs/soak.md tells more. Exit codes: 0 nothing found, 1 something found, or the program has errors, 2 wrong use.)";

constexpr uint64_t kMostHours = 10'000'000;
constexpr uint32_t kMostMachines = 1'000'000;
constexpr const char *kSimulator = "sim", *kFleet = "fleet";

/// What an engine runs when nobody says it: about as long in both.
struct Extent {
  uint32_t machines;
  const char* length;
};
Extent ExtentOf(const std::string& engine) {
  if (engine == kFleet) return {.machines = 2 * soak::kWideMachines, .length = "300h"};
  return {.machines = 16, .length = "1h"};
}

struct SoakSettings {
  CommonOptions common;
  std::vector<std::string> files;  // of properties
  std::optional<std::string> until;
  std::optional<std::string> length;
  std::string time, shard, directory, merge, form = "text";
  std::string plant;  // a file, or kPlantOfProject; empty: nothing moves by itself
  std::string engine = kSimulator, compiler;
  std::optional<uint32_t> machines;
  uint32_t jobs = 1;
  uint64_t seed = 1;
};

/// As in 90s, 10min or 100h.
std::optional<uint64_t> LengthMs(const std::string& text) {
  if (!text.ends_with('h')) return ParseDuration(text);
  const std::string digits = text.substr(0, text.size() - 1);
  constexpr size_t kMostDigits = 8;
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  const uint64_t hours = std::stoull(digits);
  if (hours > kMostHours) return std::nullopt;
  return static_cast<uint64_t>(std::chrono::milliseconds(std::chrono::hours(hours)).count());
}

struct Shard {
  uint32_t number = 1, count = 1;
};

/// "2/8".
std::optional<Shard> ShardOf(const std::string& text) {
  if (text.empty()) return Shard{};
  const size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto number = [](const std::string& digits) -> std::optional<uint32_t> {
    constexpr size_t kMostDigits = 6;
    if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
    if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    return static_cast<uint32_t>(std::stoul(digits));
  };
  const std::optional<uint32_t> one = number(text.substr(0, slash)), count = number(text.substr(slash + 1));
  if (!one || !count || *one == 0 || *one > *count) return std::nullopt;
  return Shard{.number = *one, .count = *count};
}

/// How much is run, and in what.
struct SoakWork {
  uint32_t machines = 0;  // of all shards
  Shard shard;
  uint64_t length_ms = 0;           // of all machines together
  std::optional<uint64_t> time_ms;  // real time
  std::string compiler;             // of the fleet; empty: in the simulator

  bool is_fleet() const { return !compiler.empty(); }
  uint32_t own() const { return (machines - shard.number) / shard.count + 1; }
};

/// None: what is wrong with the settings has been printed.
std::optional<SoakWork> WorkOf(const SoakSettings& settings) {
  const auto refuse = [](const std::string& why) -> std::optional<SoakWork> {
    UsageError(why);
    return std::nullopt;
  };
  const Extent extent = ExtentOf(settings.engine);
  SoakWork work{.machines = settings.machines.value_or(extent.machines), .shard = {}, .time_ms = {}, .compiler = {}};
  const std::string for_length = settings.length.value_or(extent.length);
  work.length_ms = LengthMs(for_length).value_or(0);
  if (work.length_ms == 0) return refuse("'--for " + for_length + "' is no time: write it as in 100h, 30min or 90s");
  if (!settings.time.empty()) {
    work.time_ms = LengthMs(settings.time);
    if (work.time_ms.value_or(0) == 0)
      return refuse("'--time " + settings.time + "' is no time: write it as in 60s or 8h");
  }
  const std::optional<Shard> shard = ShardOf(settings.shard);
  if (!shard) return refuse("'--shard " + settings.shard + "' is no part: write it as in 2/8, for the second of eight");
  work.shard = *shard;
  if (shard->count > work.machines) {
    return refuse("--shard " + settings.shard + ": there are " + std::to_string(work.machines) +
                  " machines to be split; --machines gives more");
  }
  if (settings.engine != kFleet) {
    if (!settings.compiler.empty())
      return refuse("--cxx is the compiler of --engine fleet: leave it out, or name this engine");
    return work;
  }
  if (work.machines % (soak::kWideMachines * shard->count) != 0) {
    const std::string side_by_side = std::to_string(soak::kWideMachines);
    return refuse("--engine fleet runs " + side_by_side + " machines side by side: " + std::to_string(work.machines) +
                  " is no multiple of " + side_by_side +
                  (shard->count == 1 ? "" : " for each of " + std::to_string(shard->count) + " parts"));
  }
  const std::optional<std::string> compiler = CompilerOf(kFleet, settings.compiler);
  if (!compiler) return std::nullopt;
  work.compiler = *compiler;
  return work;
}

/// The program, and what is watched in it; what it refers to is in it, so that it stays where it is.
struct SoakProgram {
  ChosenProperties chosen;
  scenarios::ProveMachine machine;
  std::vector<prove::properties::Property> properties;
};

/// What is wrong is printed; then the exit code is not kDone.
int ReadProgram(const SoakSettings& settings, ProgressLine& progress, SoakProgram& program) {
  ChosenProperties& chosen = program.chosen;
  chosen.files = settings.files;
  if (!ChooseProperties(settings.common, chosen)) return kWrongUse;
  chosen.request.progress = [&progress](std::string_view phase) { progress.Show(phase); };
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, chosen.request);
  if (!compiled) return kWrongUse;
  progress.Clear();
  chosen.request.progress = nullptr;
  scenarios::ProveMachine& machine = program.machine;
  machine.compilation = std::move(*compiled);
  if (!machine.compilation.ok()) {
    PrintDiagnosticsBeside(machine.compilation, MessagesOf(settings.common));
    return ExitCodeOf(machine.compilation);
  }
  if (!machine.compilation.has_program) return UsageError("the sources are data only: there is nothing to run");
  machine.version = prove::machine::MakeVersion(machine.compilation.program);
  machine.timing = scenarios::TimingOf(machine.compilation.program);
  std::vector<scenarios::PlacedProperty> placed;
  if (const int code = ReadProperties(chosen, settings.common, machine, placed); code != kDone) return code;
  for (scenarios::PlacedProperty& one : placed) {
    // Whether something is never stuck is not seen in one run.
    if (one.property.kind == prove::properties::PropertyKind::kNeverStuck) continue;
    scenarios::NameLocationsOf(one.property, machine);
    program.properties.push_back(std::move(one.property));
  }
  return kDone;
}

using Instant = std::chrono::steady_clock::time_point;
using SoakPlant = std::shared_ptr<const scenarios::BoundPlant>;  // none: nothing moves by itself

/// `program` and `progress` outlive it.
soak::SoakRequest RequestOf(const SoakSettings& settings, const SoakWork& work, const SoakProgram& program,
                            const SoakPlant& plant, ProgressLine& progress) {
  soak::SoakRequest request{.machine = program.machine,
                            .request = program.chosen.request,
                            .scenarios = StimuliOf(scenarios::KnownRuns(program.chosen.request)),
                            .corpus = {},
                            .make = soak::SimulatedMachines(program.machine.compilation, plant),
                            .plant = plant,
                            .machines = work.own(),
                            .first_machine = work.shard.number - 1,
                            .every = work.shard.count,
                            .machine_ms = (work.length_ms * work.own() + work.machines - 1) / work.machines,
                            .end = {},
                            .is_asked_to_end = EndRequest::IsMade,
                            .jobs = JobsOf(settings.jobs),
                            .seed = settings.seed,
                            .until = settings.until,
                            .directory = settings.directory,
                            .is_taken = {},
                            .progress = [&progress](const std::string& text) { progress.Show(text); }};
  // Scenarios of other programs may lie beside this one's.
  soak::FitTo(program.machine.compilation, request.scenarios);
  if (!settings.directory.empty()) {
    request.is_taken = [directory = settings.directory](const std::string& name) {
      return IsTakenByOther(directory, name);
    };
  }
  if (plant) soak::LeaveToPlant(*plant, program.machine.compilation, request.scenarios);
  return request;
}

/// Files that were read, and are not written over.
std::vector<std::string> ReadBy(const SoakSettings& settings, const SoakProgram& program) {
  std::vector<std::string> read = PathsRead(program.machine.compilation, settings.common);
  for (const std::string& path : program.chosen.files) read.push_back(path);
  return read;
}

/// The runs worth keeping as files; those that nothing would read again are left out, and told.
std::vector<emit::OutputFile> FilesOfRuns(const SoakSettings& settings, const SoakProgram& program,
                                          const SoakPlant& plant, soak::Soaked& soaked) {
  std::vector<emit::OutputFile> files;
  std::erase_if(soaked.corpus, [&](const soak::KeptRun& run) {
    const std::string name = std::string(kSoakCorpus) + "/" + soak::CorpusName(run.stimuli);
    const std::string folder = CorpusFolder(settings.directory);
    std::string text = soak::ScenarioOf(program.machine, program.chosen.request, plant.get(), folder,
                                        std::string(kKeptRunHead).substr(std::string("# ").size()), run.stimuli);
    const std::string why = soak::WhyNotReadBack(program.machine, PathIn(settings.directory, name), text, run.stimuli);
    if (!why.empty()) {
      PrintNote("a run worth keeping is not written, what it reaches stays in the record: " + why);
      return true;
    }
    files.push_back({name, std::move(text)});
    return false;
  });
  return files;
}

/// With the fleet, if it is to be one. Not kDone: what is wrong is printed.
int AddFleet(const SoakWork& work, const SoakProgram& program, const SoakPlant& plant, const soak::Goals& goals,
             const soak::WatchPlan& plan, soak::SoakRequest& request) {
  if (!work.is_fleet()) return kDone;
  request.progress("compiling " + std::to_string(soak::kWideMachines) + " machines");
  fleet::LibraryRequest library{.compiler = work.compiler};
  if (request.end) {
    const auto left = std::chrono::ceil<std::chrono::seconds>(*request.end - std::chrono::steady_clock::now());
    library.seconds = static_cast<int>(std::clamp<int64_t>(left.count(), 1, std::numeric_limits<int>::max()));
  }
  auto wide = soak::CompileWide(program.machine.compilation, plant, goals, plan, library);
  if (const auto* const failure = std::get_if<std::string>(&wide)) {
    if (request.end && std::chrono::steady_clock::now() >= *request.end)
      return UsageError(
          "--engine fleet: --time was over before its code was compiled: give it more, or take --engine sim");
    return UsageError("--engine fleet: " + *failure);
  }
  request.wide = std::get<std::shared_ptr<const soak::WideProgram>>(std::move(wide));
  return kDone;
}

int RunSoak(const SoakSettings& asked) {
  const Instant begin = std::chrono::steady_clock::now();
  if (EndRequest::IsMade()) return UsageError("the next program is not run: a signal has ended the one before it");
  SoakSettings settings = asked;
  settings.directory = FolderOf(asked.common, asked.directory);
  const std::optional<SoakWork> work = WorkOf(settings);
  if (!work) return kWrongUse;
  ProgressLine progress;
  SoakProgram program;
  if (const int code = ReadProgram(settings, progress, program); code != kDone) return code;
  const compilation::Compilation& compilation = program.machine.compilation;
  const std::optional<SoakPlant> plant = ChooseSearchPlant(settings.plant, settings.common, compilation);
  if (!plant) return kWrongUse;

  progress.Show("inputs");
  const soak::Inputs inputs(program.machine, plant->get());
  const soak::Goals goals(compilation.program);
  const soak::WatchPlan plan(program.machine, std::move(program.properties));
  const std::vector<std::string> read = ReadBy(settings, program);
  if (!settings.directory.empty() && !CanTakeSoak(settings.directory, read)) return kWrongUse;
  soak::SoakRequest request = RequestOf(settings, *work, program, *plant, progress);
  Corpus corpus;
  if (!settings.directory.empty()) {
    progress.Clear();
    corpus = ReadCorpus(settings.directory, compilation);
    if (*plant) soak::LeaveToPlant(**plant, compilation, corpus.runs);
    request.corpus = corpus.runs;
  }
  if (work->time_ms) request.end = begin + std::chrono::milliseconds(*work->time_ms);
  if (const int code = AddFleet(*work, program, *plant, goals, plan, request); code != kDone) return code;
  EndRequest end;
  soak::Soaked soaked = soak::Soak(request, goals, inputs, plan);
  end.IgnoreFurther();
  progress.Clear();

  SoakOutput output{.files = {}, .protected_paths = read, .stays = std::move(corpus.unreadable)};
  if (!settings.directory.empty()) output.files = FilesOfRuns(settings, program, *plant, soaked);
  for (const soak::Finding& finding : soaked.findings) output.files.push_back({finding.file, finding.yaml});
  for (size_t i = 0; i < soaked.repeated.size(); ++i) {
    if (!soaked.repeated[i]) output.stays.insert(corpus.names[i]);
  }
  soak::Record record = soak::MakeRecord(program.machine, soaked, goals, inputs, plan);
  record.seed = settings.seed;
  record.machines = work->own();
  if (*plant) record.plant = PlantName(**plant);
  if (!settings.shard.empty()) record.shards.insert(settings.shard);
  record.works.insert(soak::WorkWords(record, request, plan));
  const bool is_written = settings.directory.empty() || WriteSoak(settings.directory, record, std::move(output));
  // What took hours is told even where it cannot be written.
  const int code = TellSoak(record, is_written ? settings.directory : "", settings.form);
  return is_written ? code : kWrongUse;
}

int RunSoakOrMerge(SoakSettings settings) {
  if (!settings.merge.empty()) {
    if (settings.common.sources.empty()) return UsageError("--merge: name the folders that are to be merged");
    if (!settings.directory.empty()) return UsageError("--merge names the folder that is written: leave -o out");
    return MergeSoaks(settings.merge, settings.common.sources, settings.form);
  }
  NameProject(settings.common);
  return RunForPrograms(settings, RunSoak, settings.form == "json" ? Result::kJson : Result::kNamed);
}

}  // namespace

void AddSoak(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("soak", "Run many machines with random inputs, and keep what goes wrong");
  const auto settings = std::make_shared<SoakSettings>();
  AddCommonOptions(*command, settings->common);
  command
      ->add_option("--engine", settings->engine,
                   "What runs them: sim, one by one in the simulator; fleet, 512 side by side in code compiled for "
                   "this processor")
      ->type_name("ENGINE")
      ->default_str(kSimulator)
      ->check(OneOf({kSimulator, kFleet}));
  command->add_option("--cxx", settings->compiler, "C++ compiler for --engine fleet; else $CXX, c++, g++, clang++")
      ->type_name("CMD");
  command->add_option("--machines", settings->machines, "Machines that run beside each other: 16, in a fleet 1024")
      ->type_name("N")
      ->check(CLI::Range(1U, kMostMachines));
  command
      ->add_option("--for", settings->length,
                   "Machine-hours of all together, as in 100h, 30min or 90s: 1h, in a fleet 300h")
      ->type_name("TIME");
  command->add_option("--time", settings->time, "Ends after so much real time from the start, as in 60s or 8h")
      ->type_name("TIME");
  command->add_option("--until", settings->until, "Ends with a finding whose text has these words; '' takes any")
      ->type_name("TEXT");
  command->add_option("--seed", settings->seed, "What all chance is made of")
      ->type_name("N")
      ->default_str("1")
      ->check(CLI::Range(0L, std::numeric_limits<long>::max()));  // CLI11 takes "-1" for a very large number
  command
      ->add_option("--property", settings->files,
                   "A file of properties, one a line, instead of those of plcxx.yaml; may stand several times")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--plant", settings->plant,
                   "What the machine does around the program, instead of chance; 'project': that of plcxx.yaml")
      ->type_name("FILE");
  command->add_option("-o", settings->directory, "Folder for findings, runs worth keeping, record and page")
      ->type_name("DIR");
  command->add_option("-j,--jobs", settings->jobs, "Machines that run at a time; 0: one for each processor")
      ->type_name("N")
      ->default_str("1")
      ->check(CLI::Range(0, 1024));
  command->add_option("--shard", settings->shard, "One of N parts of the work, as in 2/8")->type_name("I/N");
  command->add_option("--merge", settings->merge, "Merge the folders that are named into this one")->type_name("DIR");
  command->add_option("--format", settings->form, "Form of the result: text, json")
      ->type_name("FORM")
      ->default_str("text")
      ->check(OneOf({"text", "json"}));
  command->footer(kSoakFooter);
  command->callback([settings, &run] { run = [settings] { return RunSoakOrMerge(*settings); }; });
}

}  // namespace plcxx::driver
