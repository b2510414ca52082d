// Any bytes as a technology table, and what was read written back: it reads as the same items. Seeds: technol_table/.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "transpiler/dialects/technol/machine/technology_table.h"
#include "transpiler/dialects/technol/source/sources.h"

namespace {

namespace technol = plcxx::technol;

std::optional<technol::TechnologyTable> Read(std::string_view bytes) {
  plcxx::source::SourceManager sources;
  plcxx::diag::Engine diagnostics;
  const auto loaded = sources.AddBytes("/nowhere/TAB1.TCH", bytes, technol::SourceOptions());
  const auto* file = std::get_if<plcxx::source::FileId>(&loaded);
  if (file == nullptr) return std::nullopt;
  return technol::ReadTable(sources, *file, technol::Settings(), diagnostics);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto table = Read({reinterpret_cast<const char*>(data), size});
  if (!table) return 0;
  const technol::TableImage image = technol::ImageOf(*table);
  technol::Listing(*table);
  const auto again = Read(technol::WriteTable(image, "written\n"));
  if (!again || technol::ImageOf(*again) != image) std::abort();
  return 0;
}
