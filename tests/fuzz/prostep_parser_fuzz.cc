// Any bytes, cut at NUL into files, through the prostep parser, its checks and both printers. Seeds: prostep_parser/.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/prostep/analysis/program_checks.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/prostep.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace prostep = plcxx::prostep;
  plcxx::source::SourceManager sources;
  std::vector<plcxx::source::FileId> files;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view bytes = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(bytes.size() < rest.size() ? bytes.size() + 1 : bytes.size());
    const auto loaded = sources.AddBytes("file", bytes, prostep::kProstep.load);
    if (const auto* file = std::get_if<plcxx::source::FileId>(&loaded)) files.push_back(*file);
  }
  plcxx::diag::Engine diagnostics;
  prostep::Program program = prostep::Parse(sources, files, diagnostics);
  prostep::ResolveCalls(program, diagnostics);
  if (!diagnostics.HasErrors()) {
    prostep::CheckUncalled(program, diagnostics);
    prostep::CheckActivity(program, sources, diagnostics);
    prostep::CheckLabels(program, diagnostics);
    prostep::CheckMessages(program, diagnostics);
    prostep::CheckTimersAndCounters(program, diagnostics);
    prostep::CheckInputWrites(program, diagnostics);
  }
  prostep::PrintSyntax(sources, program);
  for (const plcxx::source::FileId file : files) prostep::PrintTokens(sources, file);
  return 0;
}
