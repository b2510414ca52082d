// Hashes of what is said of many small programs: a row for each family of them, in a file.
//
// A hash says that something is another text, not what: the test names the program, which can be printed by both
// builds.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::printed {

struct HashRow {
  std::string name;  // without blanks
  std::vector<std::string> hashes;
};

/// Lines that are empty or begin with '#' are left out.
std::vector<HashRow> ReadHashes(const std::filesystem::path& file);

std::string HashOf(std::string_view text);

/// Expects the hashes of a row to be as kept; `describe` says which program the n-th one is. With PLCXX_UPDATE_GOLDEN=1
/// the file gets them instead.
void ExpectKept(const std::filesystem::path& file, const HashRow& now,
                const std::function<std::string(size_t)>& describe);

}  // namespace plcxx::printed
