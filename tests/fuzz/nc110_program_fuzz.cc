// Any bytes, cut at NUL into files, through every phase of an nc110 program: what parses without an error must lower,
// structure, optimize, legalize and print, and the IR must keep its rules behind each phase. Seeds: nc110_program/.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/checks/checks.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace {

using plcxx::ir::Stage;

void MustKeepTheRules(const plcxx::ir::Program& program, Stage stage, const char* phase) {
  const std::vector<std::string> broken = plcxx::ir::Verify(program, stage);
  if (broken.empty()) return;
  std::fprintf(stderr, "behind %s: %s\n", phase, broken.front().c_str());
  std::abort();
}

void MustNotBeEmpty(const std::string& text, const char* what) {
  if (!text.empty()) return;
  std::fprintf(stderr, "%s is empty\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const plcxx::dialects::Dialect& dialect = *plcxx::dialects::DialectByName("nc110");
  plcxx::source::SourceManager sources;
  plcxx::diag::Engine diagnostics;
  plcxx::dialects::Request request;
  request.sources = &sources;
  request.diagnostics = &diagnostics;
  request.load = [](const std::string&) { return plcxx::source::LoadError{plcxx::source::LoadProblem::kMissing, {}}; };
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view bytes = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(bytes.size() < rest.size() ? bytes.size() + 1 : bytes.size());
    const auto loaded = sources.AddBytes("file", bytes, dialect.load);
    if (const auto* file = std::get_if<plcxx::source::FileId>(&loaded)) request.files.push_back(*file);
  }
  if (request.files.empty()) return 0;

  plcxx::ir::Program program = dialect.lower(request).program;
  if (diagnostics.HasErrors()) return 0;
  program.name = "program";
  MustKeepTheRules(program, Stage::kLowered, "lowering");
  plcxx::passes::Structure(program);
  MustKeepTheRules(program, Stage::kStructured, "structuring");
  plcxx::checks::RunAll(program, dialect.lints, diagnostics);
  plcxx::passes::Optimize(program);
  MustKeepTheRules(program, Stage::kStructured, "optimizing");
  for (const auto flavour : {plcxx::emit::Flavour::kRelease, plcxx::emit::Flavour::kDebug}) {
    const plcxx::emit::Emittable emittable = plcxx::emit::legalize::Legalize(program, {.flavour = flavour});
    for (const plcxx::emit::OutputFile& file : plcxx::emit::print::PrintCpp(emittable, sources)) {
      MustNotBeEmpty(file.text, file.name.c_str());
    }
    MustNotBeEmpty(plcxx::emit::print::PrintMap(emittable, sources), "the map");
  }
  return 0;
}
