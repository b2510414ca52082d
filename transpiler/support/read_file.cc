#include "transpiler/support/read_file.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace plcxx::support {

bool IsOpened(const std::filesystem::path& path) {
  const std::string folder = path.parent_path().string();
  return folder == "/dev/fd" || folder == "/proc/self/fd";
}

std::optional<std::string> ReadFile(const std::filesystem::path& path) {
  std::error_code error;
  // A directory can be opened, but not read; a device may have no end.
  const bool is_pipe = IsOpened(path) && std::filesystem::is_fifo(path, error);
  if (!is_pipe && !std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return std::nullopt;
  return bytes;
}

}  // namespace plcxx::support
