#include "tests/printed/hashes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

#include "transpiler/support/fnv1a.h"
#include "transpiler/support/hex.h"

namespace plcxx::printed {
namespace {

std::string LineOf(const HashRow& row) {
  std::string line = row.name;
  for (const std::string& hash : row.hashes) line += ' ' + hash;
  return line;
}

/// All lines of the file, the row's exchanged, or behind them.
void Write(const std::filesystem::path& file, const HashRow& row) {
  std::vector<std::string> lines;
  {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
  }
  const auto kept =
      std::ranges::find_if(lines, [&](const std::string& line) { return line.substr(0, line.find(' ')) == row.name; });
  if (kept == lines.end()) {
    lines.push_back(LineOf(row));
  } else {
    *kept = LineOf(row);
  }
  std::ofstream out(file, std::ios::binary);
  for (const std::string& line : lines) out << line << '\n';
}

}  // namespace

std::vector<HashRow> ReadHashes(const std::filesystem::path& file) {
  std::vector<HashRow> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    HashRow row;
    words >> row.name;
    for (std::string hash; words >> hash;) row.hashes.push_back(hash);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string HashOf(std::string_view text) { return support::HexDigits(support::HashOf32(text), 8); }

void ExpectKept(const std::filesystem::path& file, const HashRow& now,
                const std::function<std::string(size_t)>& describe) {
  const std::vector<HashRow> rows = ReadHashes(file);
  const auto kept = std::ranges::find(rows, now.name, &HashRow::name);
  const std::vector<std::string> before = kept == rows.end() ? std::vector<std::string>() : kept->hashes;
  if (const char* const update = std::getenv("PLCXX_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
    if (before != now.hashes) Write(file, now);
    return;
  }
  EXPECT_EQ(before.size(), now.hashes.size());
  for (size_t i = 0; i < std::min(before.size(), now.hashes.size()); ++i) {
    EXPECT_EQ(before[i], now.hashes[i]) << "PLCXX_UPDATE_GOLDEN=1 rewrites the hash of\n" << describe(i);
  }
}

}  // namespace plcxx::printed
