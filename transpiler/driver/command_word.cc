#include "transpiler/driver/command_word.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

namespace plcxx::driver {
namespace {

constexpr size_t kLongestWord = 40;  // of what may be a command written wrongly

/// How many letters have to be changed, put in or left out to make `b` of `a`.
size_t Distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({changed, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row[b.size()];
}

}  // namespace

std::string TakeHelpWord(const CLI::App& app, std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return {};
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
    if (words.size() == 1) return {};
  }
  const std::string& word = words.front();
  std::string nearest;
  constexpr size_t kFar = 3;
  size_t distance = kFar;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return {};
    const size_t found = Distance(word.substr(0, kLongestWord), command->get_name());
    if (found < distance) {
      distance = found;
      nearest = command->get_name();
    }
  }
  return "unknown command '" + word + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

}  // namespace plcxx::driver
