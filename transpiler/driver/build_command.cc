// plcxx build: sources to C++, objects and a library for a target; what was built is audited and measured.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/compile_library.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/build_host.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/compile_report.h"
#include "transpiler/driver/dependency_file.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/identity_of.h"
#include "transpiler/driver/jobs.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/host/host.h"
#include "transpiler/measure/figures.h"
#include "transpiler/measure/limits.h"
#include "transpiler/project/keys.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

constexpr const char* kBuildFooter = R"(Examples:
  plcxx build
      each target of plcxx.yaml, with its clock and limits
  plcxx build turret.sym turret.plc --target cortex-m4f -o out
      writes out/libturret.a, out/turret.hpp, out/plcxx/*.h, the C++, maps and the report
  plcxx build mill.cld --target rv32imac --compiler clang++-19 -O s
  plcxx build turret.plc --target host --name mill -j 4

  plcxx build turret.plc --target cortex-m4f --clock 168MHz --max-fast-us 500 --max-stack 512
      an error that names the costliest statements when the fast part takes longer, or any part more stack

  plcxx build turret.plc --target host --host linuxcnc -o out
      writes out/turret.so, a module for LinuxCNC's loadrt, its .hal file and its manual page

Compile your own code with -I out and link it with out/libturret.a.
The audit refuses: heap, exceptions and unwinding, static constructors, recursion, indirect calls and jumps, floating-point
routines where the program has no floats, and symbols that are neither host functions nor support routines of the compiler.
With --host all that one period of the host reaches is audited as well: reading the pins, the program, writing the pins.
The figures are bounds on the compiled code: each branch the dearer way, each loop as often as it may go round, all calls
added. Host functions and support routines (memcpy, division) are not in them; what else is missing is told.
The report, NAME.report.json, gets an object "build":
  target, optimization   as asked for
  compiler               "gcc" or "clang"
  clock_hz               where --clock tells it
  timing                 where the cycles come from
  partitions             of each function that the header declares:
    name, instructions, cycles, time_ns (with a clock)   on its longest path
    stack_bytes          over its deepest path of calls, return addresses included
    code_bytes           of all functions that it reaches
    constant_bytes       that these refer to
    retentive_bytes, volatile_bytes   of State that its statements use; init clears all of it
    not_counted          host functions and support routines that it calls
    shared_rounds        of loops that the control's limit on rounds bounds together: all of them are in the figures
    not_whole            what is missing from the figures, in words; an error where a limit of time is given
    slices               of a sliced part, the same for each slice; the figures of the part bound all of them
  code_bytes, constant_bytes            of the library
  retentive_bytes, volatile_bytes       of one State
Files are written whole or not at all; a file that would not change keeps its time. A source is compiled again when it,
a header, the options or the compiler changed, and NAME.cpp, which names the program for plcxx identify, after each change:
libNAME.objects says what the objects in libNAME.a were made of.
Exit codes: 0 built, 1 the program has errors or the audit found some (nothing written), 2 wrong use, 3 a fault of plcxx.)";

struct BuildSettings {
  CommonOptions common;
  OutputOptions output;
  std::string target;
  std::string compiler;
  std::string host;   // empty: as the project says
  std::string level;  // empty: 2
  unsigned jobs = 0;
  std::string clock;
  measure::BuildLimits limits;
  bool no_audit = false;
  bool no_identity = false;
  bool debug = false;
  bool quiet = false;
};

std::string TargetsText() {
  std::string text = "Targets:\n";
  for (const compile::Target& target : compile::Targets()) {
    text += "  " + std::string(target.name) + std::string(16 - target.name.size(), ' ') + std::string(target.meaning) +
            "\n";
  }
  return text;
}

/// What the project says counts for a target that its host runs on.
host::Kind HostOf(const BuildSettings& settings) {
  if (settings.target != "host") return host::Kind::kOwn;
  const std::string& of_project = settings.common.program ? settings.common.program->host : settings.host;
  return host::FindHost(settings.host.empty() ? of_project : settings.host).value_or(host::Kind::kOwn);
}

/// One build: from a compiled program to the files that are written.
class Build {
 public:
  Build(const BuildSettings& settings, const compile::Target& target, uint64_t clock_hz,
        compilation::Compilation& compilation, ProgressLine& progress)
      : settings_(settings),
        target_(target),
        host_(HostOf(settings)),
        clock_hz_(clock_hz),
        compilation_(compilation),
        progress_(progress) {}

  void Run() {
    if (compilation_.has_program && !CompileProgram()) return;
    for (const dialects::DataFile& file : compilation_.data_files) files_.push_back({file.name, file.bytes});
    Write();
  }

  /// Empty where nothing was measured.
  std::string Table() const { return figures_ ? measure::BuildTable(*figures_, Way(), compilation_.name) : ""; }

 private:
  void ReportNoRoom(const compile::TemporaryDirectory& directory) {
    ReportCannotWrite({compile::TemporaryPlace(), directory.Cause(), std::string(compile::kTemporaryRemedy)},
                      compilation_);
  }

  measure::BuildWay Way() const {
    return {.target = &target_, .toolchain = &toolchain_, .level = settings_.level, .clock_hz = clock_hz_};
  }

  bool CompileProgram() {
    auto found = compile::FindToolchain(target_, settings_.compiler);
    if (const auto* missing = std::get_if<compile::MissingTool>(&found)) {
      compilation_.diagnostics.Report({}, diag::NoCompiler, missing->command, missing->package);
      return false;
    }
    toolchain_ = std::get<compile::Toolchain>(found);
    if (const std::string machine = compile::OtherMachineOf(toolchain_, target_); !machine.empty()) {
      compilation_.diagnostics.Report({}, diag::OtherCompiler, settings_.compiler, machine, target_.name,
                                      target_.prefix);
      return false;
    }
    progress_.Show("printing C++");
    const emit::Emittable emittable = emit::legalize::Legalize(
        compilation_.program,
        {.name = compilation_.name,
         .flavour = settings_.debug ? emit::Flavour::kDebug : emit::Flavour::kRelease,
         .simulated = host_ != host::Kind::kOwn});  // a host calls the same routines as the simulation
    files_ = emit::print::PrintCpp(emittable, *compilation_.sources);
    if (host_ != host::Kind::kOwn) {
      AddHostFiles(host_, emittable, toolchain_, files_, compilation_);
      if (!compilation_.ok()) return false;
    }
    files_.push_back({compilation_.name + ".map.json", emit::print::PrintMap(emittable, *compilation_.sources)});
    // Only what is compiled has it: files that are written say nothing of plcxx's version.
    std::vector<emit::OutputFile> sources = files_;
    if (!settings_.no_identity) AddIdentity(IdentityOf(compilation_, files_), compilation_.name, sources);
    const compile::TemporaryDirectory directory;
    if (!directory.valid()) return ReportNoRoom(directory), false;
    auto compiled = compile::CompileLibrary({.target = &target_,
                                             .toolchain = &toolchain_,
                                             .name = compilation_.name,
                                             .level = settings_.level,
                                             .jobs = JobsOf(settings_.jobs),
                                             .files = &sources,
                                             .directory = directory.path(),
                                             .previous = settings_.output.directory,
                                             .progress = [this](std::string_view text) { progress_.Show(text); }});
    if (std::holds_alternative<compile::NoRoom>(compiled)) return ReportNoRoom(directory), false;
    if (const auto* refused = std::get_if<compile::RefusedSource>(&compiled)) {
      progress_.Clear();
      std::cerr << refused->output;
      compilation_.diagnostics.Report({}, diag::CompilerRefuses,
                                      refused->source.empty() ? "lib" + compilation_.name + ".a" : refused->source,
                                      refused->message);
      return false;
    }
    const auto& library = std::get<compile::Library>(compiled);
    if (!settings_.no_audit) Examine(directory.path(), library, emittable);
    if (host_ == host::Kind::kLinuxcnc && compilation_.ok())
      LinkModule(toolchain_, library, directory.path(), files_, compilation_);
    files_.push_back(
        {library.archive, support::ReadFile(std::filesystem::path(directory.path()) / library.archive).value_or("")});
    files_.push_back({"lib" + compilation_.name + ".objects", library.record});
    return compilation_.ok();
  }

  void Examine(const std::filesystem::path& directory, const compile::Library& library,
               const emit::Emittable& emittable) {
    progress_.Show("auditing");
    std::vector<std::string> objects;
    std::string host_object;
    for (const std::string& name : library.objects) {
      std::string bytes = support::ReadFile(directory / name).value_or("");
      if (host_ != host::Kind::kOwn && name == HostObject(host_, compilation_.name)) {
        host_object = std::move(bytes);
      } else {
        objects.push_back(std::move(bytes));
      }
    }
    const std::optional<compile::ProgramCode> code = measure::ReadObjects(objects, target_, compilation_);
    if (!code) return;
    measure::AuditObjects(*code, emittable, compilation_);
    if (host_ != host::Kind::kOwn) {
      objects.push_back(std::move(host_object));
      AuditHost(host_, objects, target_, emittable, compilation_);
    }
    if (!compilation_.ok()) return;  // of code that must not be, figures mean nothing
    progress_.Show("measuring");
    figures_ = measure::Measure(*code, emittable, files_);
    measure::CheckLimits(*figures_, settings_.limits, clock_hz_, emittable, compilation_);
  }

  void Write() {
    WriteHostHeaders(settings_.output.directory, files_, compilation_);
    if (!compilation_.ok()) return;
    if (compilation_.has_program) {
      std::vector<std::string> names;
      for (const emit::OutputFile& file : files_) names.push_back(file.name);
      const nlohmann::ordered_json build = figures_ ? measure::BuildJson(*figures_, Way()) : nlohmann::ordered_json();
      files_.push_back({compilation_.name + ".report.json", ReportJson(compilation_, names, build)});
      for (const compile::RuntimeFile& header : compile::RuntimeFiles()) {
        files_.push_back({header.name, std::string(header.text)});
      }
    }
    OutputRequest output;
    // The deeper directory, so that both are made.
    output.directory =
        compilation_.has_program ? PathIn(settings_.output.directory, "plcxx") : settings_.output.directory;
    output.files = std::move(files_);
    for (emit::OutputFile& file : output.files) file.name = PathIn(settings_.output.directory, file.name);
    output.protected_paths = PathsRead(compilation_, settings_.common);
    output.named = {settings_.output.dependency_file};
    if (!settings_.output.dependency_file.empty()) AddDependencyFile(output);
    progress_.Show("writing");
    if (const auto failure = WriteAll(output)) ReportCannotWrite(*failure, compilation_);
  }

  /// Its targets are what a build system waits for: header and library.
  void AddDependencyFile(OutputRequest& output) const {
    const std::string& name = compilation_.name;
    const std::vector<std::string> targets = {PathIn(settings_.output.directory, name + ".hpp"),
                                              PathIn(settings_.output.directory, "lib" + name + ".a")};
    output.files.push_back({settings_.output.dependency_file, DependencyRule(targets, output.protected_paths)});
  }

  const BuildSettings& settings_;
  const compile::Target& target_;
  const host::Kind host_;
  uint64_t clock_hz_;
  compilation::Compilation& compilation_;
  ProgressLine& progress_;
  compile::Toolchain toolchain_;
  std::optional<measure::BuildFigures> figures_;
  std::vector<emit::OutputFile> files_;  // without directory
};

int RunBuild(const BuildSettings& asked) {
  BuildSettings settings = asked;
  std::optional<compilation::CompilationRequest> request = MakeNamedRequest(settings.common, settings.output);
  if (!request) return kWrongUse;
  if (settings.level.empty()) settings.level = "2";
  const compile::Target* target = compile::FindTarget(settings.target);
  if (target == nullptr) {
    const std::vector<std::string_view> names = compile::TargetNames();
    return UsageError(settings.target.empty()
                          ? "build needs a target: --target " + support::CommaSeparated(names) +
                                "; or 'targets' in plcxx.yaml"
                          : "'" + settings.target + "' is no target" + support::ThereAre(settings.target, names));
  }
  if (!settings.host.empty() && settings.host != "own" && settings.target != "host") {
    return UsageError("--host " + settings.host + " runs on Linux: --target host");
  }
  if (const std::string missing = MissingForHost(HostOf(settings)); !missing.empty()) {
    return UsageError(missing);
  }
  uint64_t clock_hz = 0;
  if (!settings.clock.empty()) {
    const std::optional<uint64_t> clock = measure::ParseClock(settings.clock);
    if (!clock) {
      return UsageError("'--clock " + settings.clock + "' is no frequency: write 168MHz, 32kHz or 16000000");
    }
    clock_hz = *clock;
  }
  if (clock_hz == 0 && (settings.limits.fast_us || settings.limits.slow_us)) {
    return UsageError("a limit of time needs the processor's clock: --clock 168MHz");
  }
  const bool limited =
      settings.limits.fast_us || settings.limits.slow_us || settings.limits.stack_bytes || settings.limits.code_bytes;
  if (settings.no_audit && limited) {
    return UsageError("limits are compared with measured figures, which --no-audit leaves out");
  }

  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  Build build(settings, *target, clock_hz, compilation, progress);
  if (compilation.ok()) build.Run();
  progress.Clear();
  PrintDiagnostics(compilation, MessagesOf(settings.common));
  if (!settings.quiet && !compilation.name.empty()) std::cerr << ReportText(compilation) << build.Table();
  return ExitCodeOf(compilation);
}

/// What the project says of a target, where the command line says nothing.
BuildSettings With(const BuildSettings& settings, const project::Target& target) {
  BuildSettings own = settings;
  own.target = target.name;
  if (own.clock.empty()) own.clock = target.clock;
  if (own.level.empty()) own.level = target.optimize;
  if (own.compiler.empty()) own.compiler = target.compiler;
  if (own.output.directory.empty()) own.output.directory = target.output + "/";
  if (own.no_audit) return own;  // limits are compared with what it measures
  if (!own.limits.fast_us) own.limits.fast_us = target.max_fast_us;
  if (!own.limits.slow_us) own.limits.slow_us = target.max_slow_us;
  if (!own.limits.stack_bytes) own.limits.stack_bytes = target.max_stack;
  if (!own.limits.code_bytes) own.limits.code_bytes = target.max_code;
  return own;
}

/// For each target that the project names, or for the one of the command line.
int RunBuildOf(const BuildSettings& settings) {
  if (!settings.common.program) return RunBuild(settings);
  const std::vector<project::Target>& targets = settings.common.program->targets;
  int code = kDone;
  bool found = false;
  for (const project::Target& target : targets) {
    if (!settings.target.empty() && settings.target != target.name) continue;
    found = true;
    code = std::max(code, RunBuild(With(settings, target)));
  }
  if (found || settings.target.empty()) return found ? code : RunBuild(settings);
  const std::string output =
      (std::filesystem::path(settings.common.program->folder) / "out" / settings.target).string();
  return RunBuild(With(settings, {.name = settings.target, .output = output}));
}

}  // namespace

void AddBuild(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("build", "Emit, compile for a target, audit and measure the objects");
  const auto settings = std::make_shared<BuildSettings>();
  AddCommonOptions(*command, settings->common);
  command->add_option("--target", settings->target, "What to compile for, see below")->type_name("T")->group("Output");
  AddOutputOptions(*command, settings->output);
  command
      ->add_option("--host", settings->host,
                   "Who reaches the terminals, of --target host: its files are built and audited as well; else as the "
                   "project says")
      ->type_name("H")
      ->check(OneOf(project::WordsOf(project::Shape::kHost)))
      ->group("Output");
  command
      ->add_option("--compiler", settings->compiler,
                   "GCC or Clang, also behind a launcher ('ccache g++'); else the target's own GCC")
      ->type_name("CMD")
      ->group("Output");
  command->add_option("-O", settings->level, "Level of optimization; else 2")
      ->type_name("LEVEL")
      ->check(OneOf(project::WordsOf(project::Shape::kLevel)))
      ->group("Output");
  command->add_option("-j,--jobs", settings->jobs, "Compilers at the same time; else one for each processor")
      ->type_name("N")
      ->check(CLI::Range(1u, 256u))
      ->group("Output");
  command->add_option("--clock", settings->clock, "The processor's clock (168MHz): the table and the report get times")
      ->type_name("F")
      ->group("Limits");
  // CLI11 takes "-3" for a very large number.
  const CLI::Validator whole_number(
      [](const std::string& text) -> std::string {
        uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && end == text.data() + text.size();
        return whole ? "" : "'" + text + "' is no whole number";
      },
      "");
  const auto limit = [&](const char* name, std::optional<uint64_t>& value, const char* unit, const char* meaning) {
    command->add_option(name, value, meaning)->check(whole_number)->type_name(unit)->group("Limits");
  };
  limit("--max-fast-us", settings->limits.fast_us, "US", "The longest that one call of the fast part may take");
  limit("--max-slow-us", settings->limits.slow_us, "US", "Likewise of the slow part: its longest slice");
  limit("--max-stack", settings->limits.stack_bytes, "BYTES", "The most stack that a partition may take");
  limit("--max-code", settings->limits.code_bytes, "BYTES", "The most code that the library may have");
  command
      ->add_flag("--no-identity", settings->no_identity,
                 "Leave out the 64 bytes by which plcxx identify finds out what is in an image")
      ->group("Output");
  command->add_flag("--no-audit", settings->no_audit, "Neither audit nor measure the objects")->group("Output");
  command->add_flag("--debug", settings->debug, "The flavour with force masks and line enables")->group("Output");
  command->add_flag("-q,--quiet", settings->quiet, "No table on the terminal")->group("Output");
  command->footer("");  // not the one of the program
  command->footer([settings] {
    return TargetsText() + DialectOptionsText(settings->common) + "\n" + kBuildFooter;
  });  // only where it is shown
  command->callback([settings, &run] { run = [settings] { return RunForPrograms(*settings, RunBuildOf); }; });
}

}  // namespace plcxx::driver
