// Any bytes, cut at NUL into files, through the nc110 parser and both printers. Seeds: nc110_parser/.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/nc110/analysis/ladder_lint.h"
#include "transpiler/dialects/nc110/parser/parser.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace nc110 = plcxx::nc110;
  plcxx::source::SourceManager sources;
  std::vector<plcxx::source::FileId> files;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view bytes = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(bytes.size() < rest.size() ? bytes.size() + 1 : bytes.size());
    const auto loaded = sources.AddBytes("file", bytes, {});
    if (const auto* file = std::get_if<plcxx::source::FileId>(&loaded)) {
      files.push_back(*file);
    }
  }
  plcxx::diag::Engine diagnostics;
  const nc110::Program program = nc110::Parse(sources, files, {}, diagnostics);
  nc110::LintLadder(sources, program, diagnostics);
  nc110::PrintSyntax(sources, program);
  for (const plcxx::source::FileId file : files) {
    nc110::PrintTokens(sources, file, {});
  }
  return 0;
}
