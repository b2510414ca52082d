#include "transpiler/driver/named_file.h"

#include <utility>
#include <variant>

#include "transpiler/driver/terminal.h"
#include "transpiler/source/read_bytes.h"

namespace plcxx::driver {

std::optional<std::string> ReadNamedFile(const std::string& path, std::string_view what_is_meant) {
  constexpr size_t kMaxBytes = size_t{1} << 32;
  auto bytes = source::ReadBytes(path, kMaxBytes);
  if (const auto* error = std::get_if<source::LoadError>(&bytes)) {
    PrintUsageError("cannot read '" + path + "': " + error->detail + "; " + std::string(what_is_meant));
    return std::nullopt;
  }
  return std::get<std::string>(std::move(bytes));
}

}  // namespace plcxx::driver
