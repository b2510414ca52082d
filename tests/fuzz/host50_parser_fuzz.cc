// Any bytes, cut at NUL into files, through the host50 parser, its warnings and both printers. Seeds: host50_parser/.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/host50/analysis/warnings.h"
#include "transpiler/dialects/host50/host50.h"
#include "transpiler/dialects/host50/parser/parser.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace host50 = plcxx::host50;
  plcxx::source::SourceManager sources;
  std::vector<plcxx::source::FileId> files;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view bytes = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(bytes.size() < rest.size() ? bytes.size() + 1 : bytes.size());
    const auto loaded = sources.AddBytes("file", bytes, host50::kHost50.load);
    if (const auto* file = std::get_if<plcxx::source::FileId>(&loaded)) files.push_back(*file);
  }
  plcxx::diag::Engine diagnostics({.enabled = {"N05"}});
  const host50::Program program = host50::Parse(sources, files, {}, diagnostics);
  host50::CheckProgram(program, sources, diagnostics);
  host50::PlaceInFirstLines(program, diagnostics);
  diagnostics.LimitErrors(100);
  host50::PrintSyntax(sources, program);
  for (const plcxx::source::FileId file : files) host50::PrintTokens(sources, file);
  return 0;
}
