// Any bytes through the @name@ parser and both printers. Seeds: the golden programs.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/@name@/parser/parser.h"
#include "transpiler/dialects/@name@/@name@.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace @name@ = plcxx::@name@;
  plcxx::source::SourceManager sources;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto loaded = sources.AddBytes("file", bytes, @name@::k@Name@.load);
  const auto* file = std::get_if<plcxx::source::FileId>(&loaded);
  if (file == nullptr) return 0;
  plcxx::diag::Engine diagnostics;
  const std::vector<plcxx::source::FileId> files = {*file};
  @name@::PrintSyntax(sources, @name@::Parse(sources, files, diagnostics));
  @name@::PrintTokens(sources, *file);
  return 0;
}
