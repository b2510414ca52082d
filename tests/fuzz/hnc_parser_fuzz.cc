// Any bytes through the hnc text, the C parser, the conversion of its tree and both printers. Seeds: hnc_parser/.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "transpiler/dialects/hnc/parser/files.h"
#include "transpiler/dialects/hnc/parser/parser.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace hnc = plcxx::hnc;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  plcxx::source::SourceManager sources;
  const auto loaded = sources.AddBytes("file.cld", bytes, hnc::LoadOptionsOf(std::nullopt));
  const auto* file = std::get_if<plcxx::source::FileId>(&loaded);
  if (file == nullptr) return 0;
  plcxx::diag::Engine diagnostics;
  plcxx::dialects::Request request;
  request.sources = &sources;
  request.files = {*file};
  request.diagnostics = &diagnostics;
  hnc::PrintSyntax(sources, hnc::Parse(request));
  hnc::PrintTokens(request);
  return 0;
}
