// Any bytes through the classicladder parser and both printers. Seeds: the golden programs.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/classicladder/classicladder.h"
#include "transpiler/dialects/classicladder/parser/parser.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace classicladder = plcxx::classicladder;
  plcxx::source::SourceManager sources;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto loaded = sources.AddBytes("file", bytes, classicladder::kClassicladder.load);
  const auto* file = std::get_if<plcxx::source::FileId>(&loaded);
  if (file == nullptr) return 0;
  plcxx::diag::Engine diagnostics;
  const std::vector<plcxx::source::FileId> files = {*file};
  classicladder::PrintSyntax(sources, classicladder::Parse(sources, files, {}, diagnostics));
  classicladder::PrintTokens(sources, *file);
  return 0;
}
