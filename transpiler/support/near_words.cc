#include "transpiler/support/near_words.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "transpiler/support/listed.h"

namespace plcxx::support {

size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string_view NearestWord(std::string_view word, std::span<const std::string_view> words) {
  // One letter, or two neighbours exchanged, in a short word; a word of one letter is like any other.
  const size_t most = word.size() < 2 ? 0 : word.size() < 4 ? 1 : 2;
  std::string_view nearest;
  size_t least = most + 1;
  for (const std::string_view candidate : words) {
    const size_t lengths = std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
    if (lengths > most || candidate.size() < 2) continue;
    const size_t distance = EditDistance(word, candidate);
    if (distance == 0 || distance > least) continue;
    nearest = distance == least ? std::string_view() : candidate;
    least = distance;
  }
  return least <= most ? nearest : std::string_view();
}

std::string_view NearestName(std::string_view name, std::span<const std::string_view> names) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const auto is_same = [&](std::string_view candidate) {
    return candidate != name && std::ranges::equal(candidate, name, {}, lower, lower);
  };
  const auto same = std::ranges::find_if(names, is_same);
  return same != names.end() ? *same : NearestWord(name, names);
}

std::string DidYouMean(std::string_view word, std::span<const std::string_view> words) {
  const std::string_view near = NearestWord(word, words);
  return near.empty() ? std::string() : ", did you mean '" + std::string(near) + "'";
}

std::string DidYouMean(std::string_view word, std::span<const std::string> words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return DidYouMean(word, views);
}

std::string ThereAre(std::string_view word, std::span<const std::string_view> words) {
  return DidYouMean(word, words) + "; there are: " + CommaSeparated(words);
}

std::string ThereAre(std::string_view word, std::span<const std::string> words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return ThereAre(word, views);
}

}  // namespace plcxx::support
