#include "transpiler/support/read_file.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace plcxx::support {

std::optional<std::string> ReadFile(const std::filesystem::path& path) {
  std::error_code error;
  // A directory can be opened, but not read; to open a pipe may last for ever, and a device may have no end.
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return std::nullopt;
  return bytes;
}

}  // namespace plcxx::support
