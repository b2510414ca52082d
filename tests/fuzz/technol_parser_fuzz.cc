// Any bytes, cut at NUL into files, through the technol parser and both printers. A file with "$TCH" in its first bytes
// is a technology table. Seeds: technol_parser/.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/source/sources.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace technol = plcxx::technol;
  plcxx::source::SourceManager sources;
  plcxx::diag::Engine diagnostics;
  plcxx::dialects::Request request;
  request.sources = &sources;
  request.diagnostics = &diagnostics;
  // Includes of a fuzzed text name no file: the directory of this one does not exist.
  request.load = [](const std::string&) { return plcxx::source::LoadError{}; };
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view bytes = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(bytes.size() < rest.size() ? bytes.size() + 1 : bytes.size());
    const bool table = bytes.substr(0, 5).find("$TCH") != std::string_view::npos;
    const auto loaded =
        sources.AddBytes(table ? "/nowhere/TAB1.TCH" : "/nowhere/a.plc", bytes, technol::SourceOptions());
    if (const auto* file = std::get_if<plcxx::source::FileId>(&loaded)) request.files.push_back(*file);
  }
  if (request.files.empty()) return 0;  // the command line asks for one
  technol::Settings settings;
  settings.evidence = technol::EvidenceRule::kStrict;
  const technol::Program program = technol::Parse(request, settings);
  technol::PrintSyntax(sources, program);
  for (const plcxx::source::FileId file : request.files) technol::PrintTokens(sources, file);
  return 0;
}
