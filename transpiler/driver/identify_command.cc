// plcxx identify: which program is in an object, a library, an executable or a firmware image.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/identity_of.h"
#include "transpiler/driver/named_file.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/identity/identity.h"

namespace plcxx::driver {
namespace {

constexpr const char* kIdentifyFooter = R"(Examples:
  plcxx identify firmware.bin
  plcxx identify out/libturret.a turret.sym turret.plc
      is it made from these sources, with these options?
  plcxx identify image.hex --all --format json
      is it one of the programs of plcxx.yaml?

FILE is what `plcxx build` or `plcxx emit --identity` made the program a part of: an object, a library, an ELF file, an
Intel HEX file, or any image that has the bytes as they are. 64 bytes of it say the program's name, plcxx's version, and
digests (the beginning of a SHA-256) of the sources, the options and the generated C++. It is compared with a program
only where sources, --project, --program or --all name one.

Exit codes: 0 found, and of the sources given; 1 nothing found, or made from other ones, or they have errors; 2 wrong use.)";

struct IdentifySettings {
  CommonOptions common;
  std::string file, form = "text";
};

/// How what was found relates to the sources given.
struct Relation {
  bool sources = false, options = false, generated = false;
  bool all() const { return sources && options; }
};

/// Adds the identities that a program would have now: as plcxx build makes it, in both flavours. Gives the exit code.
int AddIdentitiesOf(const CommonOptions& options, std::vector<identity::Identity>& identities) {
  const std::optional<compilation::CompilationRequest> request = MakeRequest(options);
  if (!request) return kWrongUse;
  const std::optional<compilation::Compilation> compiled = CompileProgram(options, *request);
  if (!compiled) return kWrongUse;
  const compilation::Compilation& compilation = *compiled;
  PrintDiagnostics(compilation, MessagesOf(options));
  if (!compilation.ok() || !compilation.has_program) return ExitCodeOf(compilation);
  for (const emit::Flavour flavour : {emit::Flavour::kRelease, emit::Flavour::kDebug}) {
    const emit::Emittable emittable =
        emit::legalize::Legalize(compilation.program, {.name = compilation.name, .flavour = flavour});
    identities.push_back(IdentityOf(compilation, emit::print::PrintCpp(emittable, *compilation.sources)));
  }
  return kDone;
}

Relation RelationOf(const identity::Identity& found, const std::vector<identity::Identity>& here) {
  Relation relation;
  for (const identity::Identity& identity : here) {
    relation.sources = relation.sources || identity.sources == found.sources;
    relation.options = relation.options || identity.options == found.options;
    relation.generated = relation.generated || identity.generated == found.generated;
  }
  return relation;
}

std::string Text(const identity::Identity& found, const std::optional<Relation>& relation) {
  const auto remark = [&relation](bool same, const char* otherwise) {
    return std::string(!relation ? "" : same ? "  as here" : otherwise);
  };
  std::string text = found.program + "\n";
  text += "  made by    plcxx " + identity::VersionText(found) + "\n";
  text += "  sources    " + found.sources + remark(relation && relation->sources, "  other sources than here") + "\n";
  text += "  options    " + found.options + remark(relation && relation->options, "  other options than here") + "\n";
  text += "  C++        " + found.generated +
          remark(relation && relation->generated, "  other C++ than `plcxx build` would write here") + "\n";
  return text;
}

int RunIdentify(const IdentifySettings& settings) {
  const std::optional<std::string> bytes =
      ReadNamedFile(settings.file, "FILE is an object, a library, an executable or a firmware image");
  if (!bytes) return kWrongUse;
  const std::vector<identity::Identity> found = identity::FindIdentities(*bytes);
  const CommonOptions& common = settings.common;
  const bool compares =
      !common.sources.empty() || !common.project.empty() || !common.program_names.empty() || common.all;
  std::vector<identity::Identity> here;
  if (compares) {
    const int code = ForEachProgram(common, [&here](const CommonOptions& one) { return AddIdentitiesOf(one, here); });
    if (code != kDone) return code;
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string text;
  bool is_here = false;
  for (const identity::Identity& identity : found) {
    std::optional<Relation> relation;
    if (compares) relation = RelationOf(identity, here);
    is_here = is_here || (relation && relation->all());
    text += Text(identity, relation);
    json.push_back({{"program", identity.program},
                    {"plcxx", identity::VersionText(identity)},
                    {"sources", identity.sources},
                    {"options", identity.options},
                    {"generated", identity.generated}});
    if (relation) {
      json.back()["sameSources"] = relation->sources;
      json.back()["sameOptions"] = relation->options;
      json.back()["sameGenerated"] = relation->generated;
    }
  }
  if (settings.form == "json") {
    std::cout << nlohmann::ordered_json({{"file", settings.file}, {"programs", json}}).dump(2) << "\n";
  } else {
    std::cout << text;
  }
  if (found.empty())
    std::cerr << "plcxx: no program of plcxx is named in '" << settings.file
              << "'; plcxx build names it, unless --no-identity was given, and so does plcxx emit --identity\n";
  return found.empty() || (compares && !is_here) ? kProgramHasErrors : kDone;
}

}  // namespace

void AddIdentify(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("identify", "Tell which program is in an object or a firmware image");
  const auto settings = std::make_shared<IdentifySettings>();
  command->add_option("FILE", settings->file, "Object, library, ELF file, Intel HEX file or image")->required();
  command->add_option("SOURCE", settings->common.sources, "What it should be made from, in the build's order");
  AddProjectOptions(*command, settings->common);
  AddProgramOptions(*command, settings->common);
  command->add_option("--format", settings->form, "text or json")
      ->type_name("FORM")
      ->check(OneOf({"text", "json"}))
      ->group("Output");
  command->footer(kIdentifyFooter);
  command->callback([settings, &run] { run = [settings] { return RunIdentify(*settings); }; });
}

}  // namespace plcxx::driver
