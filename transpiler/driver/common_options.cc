#include "transpiler/driver/common_options.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "transpiler/compilation/warning_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/project/keys.h"
#include "transpiler/source/columns.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr const char* kSourcesGroup = "Sources";
constexpr const char* kMessagesGroup = "Messages";

/// An option that may stand several times and takes one value each time, so that a source may follow it.
void AddRepeated(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                 const std::string& placeholder, const std::string& meaning, const char* group) {
  command.add_option(name, values, meaning)->type_name(placeholder)->allow_extra_args(false)->take_all()->group(group);
}

bool TakeSettings(const std::vector<std::string>& settings, std::vector<std::pair<std::string, std::string>>& options) {
  for (const std::string& setting : settings) {
    const size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      PrintUsageError("'--set " + setting + "' has no value: write --set key=value");
      return false;
    }
    options.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return true;
}

}  // namespace

void AddSettings(CLI::App& command, CommonOptions& options) {
  AddRepeated(command, "--set", options.settings, "KEY=VALUE", "Option of the dialect, such as --set clo=10,2",
              kSourcesGroup);
  AddRepeated(command, "-W", options.warnings, "NAME",
              "-WNAME turns a warning on, -Wno-NAME off; -Werror, -Werror=NAME make errors of warnings",
              kMessagesGroup);
}

void AddCommonOptions(CLI::App& command, CommonOptions& options) {
  command
      .add_option("SOURCE", options.sources,
                  "The files of one program, in their order; - is standard input. A scenario (.yaml): its program. "
                  "None: that of "
                  "plcxx.yaml")
      ->type_name("");
  AddProjectOptions(command, options);
  AddProgramOptions(command, options);
}

void AddProjectOptions(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--project", options.project,
                  "The project, instead of the plcxx.yaml in this folder or the nearest above it")
      ->type_name("FILE")
      ->group(kSourcesGroup);
  AddRepeated(command, "--program", options.program_names, "NAME", "A program of the project, where it has several",
              kSourcesGroup);
  command.add_flag("--all", options.all, "All programs of the project")->group(kSourcesGroup);
  command
      .add_flag("--allow-outside", options.allow_outside,
                "Scenarios and plcxx.yaml may name files outside of their project, the folder tree that is under "
                "version control")
      ->group(kSourcesGroup);
}

void AddProgramOptions(CLI::App& command, CommonOptions& options) {
  command.add_option("--dialect", options.dialect, "Language of the sources; else told by extension, then by content")
      ->type_name("NAME")
      ->group(kSourcesGroup);
  command
      .add_option(
          "--encoding", options.encoding,
          "Encoding of the sources: " + support::CommaSeparated(source::EncodingNames()) + "; else (auto) detected")
      ->type_name("NAME")
      ->group(kSourcesGroup);
  AddRepeated(command, "-I", options.include_directories, "DIR", "Where to look for files that options name",
              kSourcesGroup);
  AddRepeated(command, "--system-include", options.system_include_directories, "DIR",
              "Where quoted includes are looked for (dialect technol)", kSourcesGroup);
  AddRepeated(command, "-D", options.defines, "NAME[=V]", "Define a macro (dialect hnc)", kSourcesGroup);
  AddRepeated(command, "-U", options.undefines, "NAME", "Undefine a macro (dialect hnc)", kSourcesGroup);
  AddSettings(command, options);
  command.add_option("--diagnostics", options.format, "Form of the messages: text, json, sarif")
      ->type_name("FORM")
      ->default_str("text")
      ->check(OneOf({"text", "json", "sarif"}))
      ->group(kMessagesGroup);
  command
      .add_option("--max-messages", options.most_messages,
                  "Show so many errors and so many warnings; 0: all. As text 100 if nothing is said")
      ->check(CLI::Range(0l, 1'000'000'000l))  // CLI11 takes "-1" for a very large number
      ->type_name("N")
      ->group(kMessagesGroup);
}

namespace {

constexpr std::string_view kFactsMeaning = "what plcxx decides from becomes assertions: trusted or checked (trusted)";

std::string OptionLine(std::string_view key, const std::string& meaning) {
  constexpr size_t kKeyWidth = 20;
  std::string line = source::LeftAligned("  " + std::string(key), kKeyWidth);
  if (line.back() != ' ') line += ' ';
  return line + meaning + "\n";
}

std::string TableOf(const dialects::Dialect& dialect) {
  std::string text = "Options of dialect " + std::string(dialect.name) + " (--set KEY=VALUE):\n";
  for (const dialects::OptionInfo& option : dialect.options) {
    std::string meaning = std::string(option.meaning) + ": " + std::string(option.values);
    if (!option.default_value.empty()) meaning += " (" + std::string(option.default_value) + ")";
    text += OptionLine(option.key, meaning);
  }
  return text;
}

std::string TableOfEvery() {
  return "Option of every dialect:\n" + OptionLine(compilation::kFactsOption, std::string(kFactsMeaning));
}

/// The dialect that the sources of the command line, or the programs of the project here, are said to have.
const dialects::Dialect* DialectHere(const CommonOptions& options) {
  if (!options.dialect.empty()) return dialects::DialectByName(options.dialect);
  if (!options.sources.empty()) return nullptr;
  const std::optional<std::string> path =
      options.project.empty() ? project::FindProject(".") : std::optional(options.project);
  if (!path) return nullptr;
  const project::ProjectOrErrors read = project::ReadProject(*path, project::Reach::kAnywhere);
  const auto* const found = std::get_if<project::Project>(&read);
  if (found == nullptr) return nullptr;
  std::string_view name;
  for (const project::Program& program : found->programs) {
    if (!name.empty() && program.dialect != name) return nullptr;
    name = program.dialect;
  }
  return dialects::DialectByName(name);
}

std::string DialectKeysText() {
  constexpr size_t kMostColumns = 110;
  constexpr size_t kNameWidth = 11;
  std::string text = "Options of the dialects (--set KEY=VALUE); plcxx emit --dialect NAME --help says what they do:\n";
  for (const dialects::Dialect* dialect : dialects::AllDialects()) {
    // A name that is longer than the column has a blank after it, too.
    std::string line = source::LeftAligned("  " + std::string(dialect->name) + " ", kNameWidth);
    for (const dialects::OptionInfo& option : dialect->options) {
      const bool last = &option == &dialect->options.back();
      if (line.size() + 1 + option.key.size() >= kMostColumns) {
        text += line + "\n";
        line.assign(kNameWidth, ' ');
      }
      line += (line.back() == ',' ? " " : "") + std::string(option.key) + (last ? "" : ",");
    }
    text += line + "\n";
  }
  return text + source::LeftAligned("  all", kNameWidth) + std::string(compilation::kFactsOption) + "\n";
}

}  // namespace

std::string AllDialectOptionsText() {
  std::string text;
  for (const dialects::Dialect* dialect : dialects::AllDialects()) text += TableOf(*dialect);
  return text + TableOfEvery();
}

std::string DialectOptionsText(const CommonOptions& options) {
  const dialects::Dialect* const dialect = DialectHere(options);
  return dialect == nullptr ? DialectKeysText() : TableOf(*dialect) + TableOfEvery();
}

std::optional<compilation::CompilationRequest> MakeRequest(const CommonOptions& options) {
  compilation::CompilationRequest request;
  std::vector<std::string> warnings;
  if (options.program) {
    request = project::RequestOf(*options.program);
    warnings = options.program->warnings;
    if (!request.base_directory.empty()) request.include_directories.emplace_back(".");  // files that --set names
  } else {
    request.sources = options.sources;
  }
  warnings.insert(warnings.end(), options.warnings.begin(), options.warnings.end());
  if (!options.dialect.empty()) request.dialect = options.dialect;
  const auto add_first = [](std::vector<std::string>& all, const std::vector<std::string>& own) {
    all.insert(all.begin(), own.begin(), own.end());
  };
  add_first(request.include_directories, options.include_directories);
  add_first(request.system_include_directories, options.system_include_directories);
  if (options.encoding == "auto") request.encoding.reset();
  if (!options.encoding.empty() && options.encoding != "auto") {
    request.encoding = source::EncodingByName(options.encoding);
    if (!request.encoding) {
      PrintUsageError("'" + options.encoding + "' is no encoding" +
                      support::ThereAre(options.encoding, project::WordsOf(project::Shape::kEncoding)));
      return std::nullopt;
    }
  }
  if (!TakeSettings(options.settings, request.options)) return std::nullopt;
  for (const std::string& definition : options.defines) {
    const size_t equals = definition.find('=');
    request.macros.push_back(
        {definition.substr(0, equals), equals == std::string::npos ? "1" : definition.substr(equals + 1)});
  }
  for (const std::string& name : options.undefines) request.macros.push_back({name, std::nullopt});
  std::vector<std::string> unknown;
  request.warnings = compilation::ReadWarningOptions(warnings, unknown);
  if (!unknown.empty()) {
    PrintUsageError("'" + unknown.front() +
                    "' names no warning: " + compilation::RemedyOfUnknownWarning(unknown.front()));
    return std::nullopt;
  }
  if (IsScenario(options)) return RequestOfScenario(options, request);
  for (const std::string& source : request.sources) {
    if (options.program || !IsScenario(source)) continue;
    PrintUsageError("'" + source +
                    "' is YAML, as scenarios are, which name their programs: leave it or the sources out");
    return std::nullopt;
  }
  return request;
}

MessageStyle MessagesOf(const CommonOptions& options) {
  return {DiagnosticsFormatByName(options.format).value_or(DiagnosticsFormat::kText), options.most_messages};
}

int ExitCodeOf(const compilation::Compilation& compilation) {
  if (compilation.ok()) return kDone;
  return compilation.wrong_use ? kWrongUse : kProgramHasErrors;
}

}  // namespace plcxx::driver
