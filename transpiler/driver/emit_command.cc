// plcxx emit: sources to C++ files, maps and report.
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/preemption.h"
#include "transpiler/compile/amalgamate.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/compile_report.h"
#include "transpiler/driver/dependency_file.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/identity_of.h"
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
#include "transpiler/project/keys.h"

namespace plcxx::driver {
namespace {

constexpr const char* kEmitFooter = R"(Examples:
  plcxx emit
      the program of plcxx.yaml, in this folder or above, to its folder 'generated'
  plcxx emit turret.sym turret.plc -o generated
      writes generated/turret.hpp, turret.cpp, turret.map.json and turret.report.json
  plcxx emit main.plc --single-file -o mill.hpp
      everything in one file; -o - writes it to standard output
  plcxx emit main.plc --name mill -o out --depfile out/mill.d
      as a step of Ninja or CMake
  plcxx emit main.plc --set clo=20,2 --set iocfil=IOCFIL -Werror=W356

Files are written whole or not at all; a file that would not change keeps its time.
Exit codes: 0 written, 1 the program has errors (nothing written), 2 wrong use, 3 a fault of plcxx.)";

struct EmitSettings {
  CommonOptions common;
  OutputOptions output;
  bool line_directives = false;
  bool debug = false;
  bool quiet = false;
  bool single_file = false;
  bool preemptive = false;
  bool identity = false;
  bool link = false;
  std::string host;  // empty: as the project says
  uint32_t parts = 0;
};

/// What '-o turret.hpp' and '-o -' ask for: the one file, and its dependencies.
OutputRequest OnlyFile(const EmitSettings& settings, OutputRequest output,
                       const compilation::Compilation& compilation) {
  output.directory = std::filesystem::path(settings.output.directory).parent_path().string();
  output.files.front().name = settings.output.directory;
  output.named = {settings.output.directory, settings.output.dependency_file};
  output.protected_paths = PathsRead(compilation, settings.common);
  if (!settings.output.dependency_file.empty()) {
    output.files.push_back(
        {settings.output.dependency_file, DependencyRule({settings.output.directory}, output.protected_paths)});
  }
  return output;
}

host::Kind HostOfEmission(const EmitSettings& settings) {
  const std::string& of_project = settings.common.program ? settings.common.program->host : settings.host;
  return host::FindHost(settings.host.empty() ? of_project : settings.host).value_or(host::Kind::kOwn);
}

OutputRequest MakeOutput(const EmitSettings& settings, compilation::Compilation& compilation,
                         std::vector<bool> shared) {
  OutputRequest output;
  output.directory = settings.output.directory;
  if (compilation.has_program) {
    emit::EmitOptions options;
    options.name = compilation.name;
    options.flavour = settings.debug ? emit::Flavour::kDebug : emit::Flavour::kRelease;
    options.line_directives = settings.line_directives;
    options.parts = settings.single_file ? 1 : settings.parts;
    options.shared = std::move(shared);
    const host::Kind host = HostOfEmission(settings);
    options.simulated = host != host::Kind::kOwn;  // a host calls the same routines as the simulation
    const emit::Emittable emittable = emit::legalize::Legalize(compilation.program, options);
    output.files = emit::print::PrintCpp(emittable, *compilation.sources);
    for (emit::OutputFile& file : host::PrintHost(emittable, host, compilation.diagnostics))
      output.files.push_back(std::move(file));
    if (settings.identity || settings.link) {
      const identity::Identity identity = IdentityOf(compilation, output.files);
      if (settings.identity) AddIdentity(identity, compilation.name, output.files);
      if (settings.link) {
        const std::string name = compilation.name + "_link.hpp";
        output.files.push_back({name, identity::LinkHeaderText(identity, name, emittable.namespace_name)});
      }
    }
    if (settings.single_file) output.files = {compile::Amalgamate(output.files, compilation.name)};
    if (KindOfOutput(settings.output.directory) != OutputKind::kFolder) return OnlyFile(settings, output, compilation);
    output.files.push_back({compilation.name + ".map.json", emit::print::PrintMap(emittable, *compilation.sources)});
  }
  for (const dialects::DataFile& file : compilation.data_files) output.files.push_back({file.name, file.bytes});
  if (compilation.has_program) {
    std::vector<std::string> names;
    for (const emit::OutputFile& file : output.files) names.push_back(file.name);
    output.files.push_back({compilation.name + ".report.json", ReportJson(compilation, names, {})});
  }
  for (emit::OutputFile& file : output.files) file.name = PathIn(settings.output.directory, file.name);

  output.protected_paths = PathsRead(compilation, settings.common);
  output.named = {settings.output.dependency_file};
  if (!settings.output.dependency_file.empty()) {
    std::vector<std::string> targets;
    for (const emit::OutputFile& file : output.files) targets.push_back(file.name);
    output.files.push_back({settings.output.dependency_file, DependencyRule(targets, output.protected_paths)});
  }
  return output;
}

int RunEmit(const EmitSettings& asked) {
  EmitSettings settings = asked;
  if (settings.common.program && settings.output.directory.empty())
    settings.output.directory = settings.common.program->generated + "/";
  if (settings.single_file) settings.output.one_file = OneFile::kYes;
  std::optional<compilation::CompilationRequest> request = MakeNamedRequest(settings.common, settings.output);
  if (!request) return kWrongUse;
  request->lists = dialects::Lists::kNone;

  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  std::string text;  // for standard output
  std::vector<bool> shared;
  if (settings.preemptive) shared = compilation::CheckPreemptive(compilation);
  if (compilation.ok()) {
    progress.Show("printing C++");
    OutputRequest output = MakeOutput(settings, compilation, std::move(shared));
    progress.Show("writing");
    if (KindOfOutput(settings.output.directory) == OutputKind::kStandardOutput && !output.files.empty()) {
      text = std::move(output.files.front().text);
      output.files.erase(output.files.begin());
    }
    if (compilation.ok()) {
      if (const auto failure = WriteAll(output)) ReportCannotWrite(*failure, compilation);
    }
  }
  progress.Clear();
  if (KindOfOutput(settings.output.directory) == OutputKind::kStandardOutput) {
    PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
    if (compilation.ok()) std::cout << text;
  } else {
    PrintDiagnostics(compilation, MessagesOf(settings.common));
  }
  if (!settings.quiet && !compilation.name.empty()) std::cerr << ReportText(compilation);
  return ExitCodeOf(compilation);
}

}  // namespace

void AddEmit(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("emit", "Write C++, symbol map, line map and report");
  const auto settings = std::make_shared<EmitSettings>();
  AddCommonOptions(*command, settings->common);
  AddOutputOptions(*command, settings->output);
  CLI::Option* lines =
      command
          ->add_flag("--line-directives", settings->line_directives,
                     "Put #line directives into the C++: compilers and debuggers name the statement of the source")
          ->group("Output");
  CLI::Option* parts =
      command
          ->add_option(
              "--parts", settings->parts,
              "Exactly so many .cpp files, NAME.cpp, NAME_2.cpp ...; else as many as the program's size asks for")
          ->type_name("N")
          ->check(CLI::Range(1u, emit::kMostParts))
          ->group("Output");
  CLI::Option* single =
      command
          ->add_flag("--single-file", settings->single_file,
                     "One NAME.hpp with runtime, program and, behind a macro that its first lines name, the code")
          ->excludes(parts)
          ->excludes(lines)
          ->group("Output");
  command
      ->add_option("--host", settings->host,
                   "Who reaches the terminals: own (functions that you write), or a host whose files are written, too: "
                   "posix, linuxcnc, modbus")
      ->type_name("HOST")
      ->check(OneOf(project::WordsOf(project::Shape::kHost)))
      ->excludes(single)
      ->group("Output");
  CLI::Option* debug =
      command->add_flag("--debug", settings->debug, "The flavour with force masks and line enables")->group("Output");
  command
      ->add_flag("--preemptive", settings->preemptive,
                 "For a fast part that runs from an interrupt above the slow part; refused where that is not safe")
      ->excludes(debug)
      ->group("Output");
  command
      ->add_flag("--identity", settings->identity,
                 "A constant of 64 bytes at the end of NAME.cpp, by which plcxx identify finds out what is in an image")
      ->group("Output");
  command
      ->add_flag("--link", settings->link,
                 "Also NAME_link.hpp, by which plcxx live --link knows the program of a machine (plcxx/debug_link.h)")
      ->excludes(single)
      ->group("Output");
  command->add_flag("-q,--quiet", settings->quiet, "No compile report on the terminal")->group("Output");
  command->footer("");  // not the one of the program
  command->footer(
      [settings] { return DialectOptionsText(settings->common) + "\n" + kEmitFooter; });  // made only where it is shown
  command->callback([settings, &run] { run = [settings] { return RunForPrograms(*settings, RunEmit); }; });
}

}  // namespace plcxx::driver
