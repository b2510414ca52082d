// plcxx print: the result of one phase as text.
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/driver/vocabulary.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/printer.h"
#include "transpiler/plant/schema.h"
#include "transpiler/project/schema.h"
#include "transpiler/source/decode.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr const char* kPrintFooter = R"(Phases:
  source         the text as UTF-8         ir             typed IR as lowered       ir-emittable  ready to be printed
  tokens         what the lexer sees       ir-structured  nested regions            cpp           the generated files
  syntax         the syntax tree           ir-optimized   sliced and optimized

  schema         the JSON schema of plcxx.yaml, for editors; plant-schema, panel-schema: of plant.yaml and panel.yaml
  vocabulary     the words of all dialects as JSON, for the colours of editors

Examples:
  plcxx print syntax turret.plc
  plcxx print ir-optimized turret.sym turret.plc
  plcxx print cpp turret.plc | less

The phase goes to standard output, messages to standard error. From ir on, a program with errors prints nothing.
Exit codes: 0 printed, 1 the program has errors, 2 wrong use, 3 a fault of plcxx.)";

struct PrintSettings {
  CommonOptions common;
  std::string phase;
};

/// Files that are printed one after the other need headings; a single one is printed as it is.
std::string Heading(const std::string& name, size_t count) { return count == 1 ? std::string() : "=== " + name + "\n"; }

std::string PrintSource(compilation::Compilation& compilation) {
  std::string text;
  for (const source::FileId id : compilation.files) {
    const source::File& file = compilation.sources->Get(id);
    text += Heading(file.path, compilation.files.size()) + file.text;
  }
  return text;
}

std::string PrintTokens(compilation::Compilation& compilation) {
  dialects::Request request = compilation.MakeRequest();
  return compilation.dialect->print_tokens(request);
}

std::string PrintSyntax(compilation::Compilation& compilation) {
  dialects::Request request = compilation.MakeRequest();
  return compilation.dialect->print_syntax(request);
}

std::string PrintIr(compilation::Compilation& compilation) { return ir::Print(compilation.program); }

emit::Emittable EmittableOf(const compilation::Compilation& compilation) {
  emit::EmitOptions options;
  options.name = compilation.name;
  return emit::legalize::Legalize(compilation.program, options);
}

std::string PrintEmittable(compilation::Compilation& compilation) {
  return emit::print::PrintEmittable(EmittableOf(compilation));
}

std::string PrintFiles(compilation::Compilation& compilation) {
  const std::vector<emit::OutputFile> files = emit::print::PrintCpp(EmittableOf(compilation), *compilation.sources);
  std::string text;
  for (const emit::OutputFile& file : files) text += Heading(file.name, files.size()) + file.text;
  return text;
}

/// No phases: what an editor has to know of plcxx.yaml and its like, and of the languages.
struct TextRow {
  std::string_view name;
  std::string (*print)();
};
constexpr std::array<TextRow, 4> kTexts = {{{"schema", project::Schema},
                                            {"plant-schema", plant::PlantSchema},
                                            {"panel-schema", plant::PanelSchema},
                                            {"vocabulary", VocabularyText}}};

struct PhaseRow {
  std::string_view name;
  compilation::Stage stage;
  std::string (*print)(compilation::Compilation& compilation);
};
constexpr std::array<PhaseRow, 8> kPhases = {{
    {"source", compilation::Stage::kLoaded, PrintSource},
    {"tokens", compilation::Stage::kLoaded, PrintTokens},
    {"syntax", compilation::Stage::kLoaded, PrintSyntax},
    {"ir", compilation::Stage::kLowered, PrintIr},
    {"ir-structured", compilation::Stage::kStructured, PrintIr},
    {"ir-optimized", compilation::Stage::kOptimized, PrintIr},
    {"ir-emittable", compilation::Stage::kOptimized, PrintEmittable},
    {"cpp", compilation::Stage::kOptimized, PrintFiles},
}};

const PhaseRow* PhaseByName(std::string_view name) {
  for (const PhaseRow& row : kPhases) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

std::vector<std::string_view> PhaseNames() {
  std::vector<std::string_view> names;
  for (const PhaseRow& row : kPhases) names.push_back(row.name);
  for (const TextRow& row : kTexts) names.push_back(row.name);
  return names;
}

int RunPrint(const PrintSettings& settings) {
  const PhaseRow* phase = PhaseByName(settings.phase);  // RunPrintOf has looked
  const std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return kWrongUse;
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request, phase->stage);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  if (compilation.reached == phase->stage) {
    const std::string text = phase->print(compilation);
    // A file gets the text as it is; a terminal nothing that acts on it. Bytes that are no text nobody can read.
    const bool shown = IsTerminal(Stream::kOutput) || !source::IsValidUtf8(text);
    std::cout << (shown ? diag::EscapedLines(text) : text) << std::flush;
    compilation.diagnostics.SortBySource();
  }
  PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
  return ExitCodeOf(compilation);
}

/// What needs no program comes first.
int RunPrintOf(const PrintSettings& settings) {
  for (const TextRow& row : kTexts) {
    if (settings.phase != row.name) continue;
    std::cout << row.print();
    return kDone;
  }
  if (PhaseByName(settings.phase) == nullptr) {
    return UsageError("'" + settings.phase + "' is no phase" + support::ThereAre(settings.phase, PhaseNames()));
  }
  return RunForPrograms(settings, RunPrint, Result::kUnnamed);
}

}  // namespace

void AddPrint(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("print", "Show what a phase of the transpiler made");
  const auto settings = std::make_shared<PrintSettings>();
  command->add_option("PHASE", settings->phase, support::CommaSeparated(PhaseNames()))->required()->type_name("");
  AddCommonOptions(*command, settings->common);
  command->footer(kPrintFooter);
  command->callback([settings, &run] { run = [settings] { return RunPrintOf(*settings); }; });
}

}  // namespace plcxx::driver
