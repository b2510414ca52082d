// A folder for what is shown and not kept; it goes with the object, and when a signal ends the server.
#pragma once

#include <cstdlib>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "transpiler/compile/end_signals.h"

namespace plcxx::mcp {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_((std::filesystem::temp_directory_path() / "plcxx-mcp-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("there is no room for a temporary folder");
    noted_.Note(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  compile::NotedDirectory noted_;
};

}  // namespace plcxx::mcp
