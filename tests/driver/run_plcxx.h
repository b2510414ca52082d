// Runs the built tool as a pipeline does: arguments, standard input, files in a directory of the test's own.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/temporary_directory.h"

namespace plcxx::driver {

struct Ran {
  int code = -1;  // 124: it did not end in time
  std::string out, errors;
};

inline std::ostream& operator<<(std::ostream& stream, const Ran& ran) {
  return stream << "exit code " << ran.code << "\n--- output\n" << ran.out << "--- errors\n" << ran.errors;
}

inline std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Workplace {
 public:
  std::string Write(std::string_view name, std::string_view text) const { return directory_.Write(name, text); }
  std::string Read(const std::string& name) const { return ReadFile(directory_.File(name)); }
  std::string Path(std::string_view name) const { return directory_.File(name); }
  bool Has(std::string_view name) const { return std::filesystem::exists(directory_.File(name)); }
  /// All files below a folder, hidden ones too.
  std::vector<std::string> Files(std::string_view folder) const {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_.File(folder), none)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  /// `arguments` as a shell takes them; `environment` as "NAME=value"; runs in `folder` of the workplace.
  Ran Run(const std::string& arguments, std::string_view input = "", const std::string& environment = "",
          const std::string& folder = ".") const {
    Write(kInput, input);
    const std::string command = "cd '" + Path(folder) + "' && " + kLimits + "env " + environment +
                                " timeout 600 " PLCXX_BINARY " " + arguments + " <'" + Path(kInput) + "' >'" +
                                Path(kOutput) + "' 2>'" + Path(kErrors) + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, Read(kOutput), Read(kErrors)};
  }

 private:
  static constexpr const char* kInput = ".stdin";
  static constexpr const char* kOutput = ".stdout";
  static constexpr const char* kErrors = ".stderr";
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  static constexpr const char* kLimits = "";  // sanitizers reserve more address space than there is memory
#else
  static constexpr const char* kLimits = "ulimit -v 900000 && ";
#endif
  testing_support::TemporaryDirectory directory_;
};

/// Two statements, one in each part, no warning.
inline constexpr std::string_view kGoodProgram = "U4A0=I0A0\n$\nU4A1=I0A1\n";
/// One error, in line 2.
inline constexpr std::string_view kBadProgram = "U4A0=I0A0\nU4A1=I0A\n$\n";

}  // namespace plcxx::driver
