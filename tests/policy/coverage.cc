#include "tests/policy/coverage.h"

#include <algorithm>
#include <cctype>

namespace plcxx::policy {
namespace {

constexpr size_t kDigits = 3;

bool IsId(const std::string& word) {
  const size_t dash = word.find('-');
  return dash != std::string::npos && word.size() == dash + 1 + kDigits && dash > 0 &&
         std::all_of(word.begin() + static_cast<std::ptrdiff_t>(dash) + 1, word.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(dash),
                     [](unsigned char c) { return std::isupper(c) != 0 || std::isdigit(c) != 0; });
}

/// "NC110-070..076" gives all seven; a word that is no id gives none.
std::vector<std::string> IdsOf(std::string word) {
  while (!word.empty() && (word.back() == ',' || word.back() == ';')) word.pop_back();
  const size_t dots = word.find("..");
  const std::string first = word.substr(0, dots);
  if (!IsId(first)) return {};
  if (dots == std::string::npos) return {first};
  const std::string prefix = first.substr(0, first.size() - kDigits);
  const std::string last = word.substr(dots + 2);
  if (!IsId(prefix + last)) return {word};  // kept, so that it is seen as unknown
  std::vector<std::string> ids;
  for (int n = std::stoi(first.substr(prefix.size())); n <= std::stoi(last); ++n) {
    const std::string number = std::to_string(n);
    ids.push_back(prefix + std::string(kDigits - std::min(kDigits, number.size()), '0') + number);
  }
  return ids;
}

std::string_view Prefix(std::string_view id) { return id.substr(0, id.find('-')); }

}  // namespace

Coverage FindCoverage(const std::string& root, std::string_view checklist) {
  Coverage coverage;
  for (const std::string& line : Lines(checklist)) {
    const std::string id = line.substr(0, line.find(' '));
    if (!IsId(id)) continue;
    coverage.ids.push_back(id);
    coverage.titles[id] = line.substr(std::min(line.size(), id.size() + 1));
  }
  for (const std::string& file : FilesBelow(root, "tests", {".cc", ".h", ".yaml", ".plc", ".sym", ".py", ".txt"})) {
    if (file.starts_with("tests/policy/")) continue;
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      const std::string_view word = "covers:";
      const size_t at = line.find(word);
      if (at == std::string::npos) continue;
      for (const std::string& named : Words(line.substr(at + word.size()))) {
        for (const std::string& id : IdsOf(named)) {
          // Another prefix belongs to another dialect's checklist.
          if (!coverage.ids.empty() && Prefix(id) != Prefix(coverage.ids.front())) continue;
          const std::string place = file + ":" + std::to_string(number);
          if (!coverage.titles.contains(id)) coverage.unknown.push_back(place + ": " + id);
          coverage.tests[id].push_back(place);
        }
      }
    }
  }
  return coverage;
}

std::vector<std::string> Uncovered(const Coverage& coverage) {
  std::vector<std::string> uncovered;
  for (const std::string& id : coverage.ids) {
    if (!coverage.tests.contains(id)) uncovered.push_back(id + " " + coverage.titles.at(id));
  }
  return uncovered;
}

std::string Table(const Coverage& coverage) {
  constexpr size_t kShown = 3;
  constexpr size_t kTitleWidth = 38;
  std::string table;
  for (const std::string& id : coverage.ids) {
    std::string title = coverage.titles.at(id);
    title.resize(std::max(title.size(), kTitleWidth), ' ');
    table += id + "  " + title + " ";
    const auto found = coverage.tests.find(id);
    if (found == coverage.tests.end()) {
      table += " NOT COVERED\n";
      continue;
    }
    const std::vector<std::string>& places = found->second;
    for (size_t i = 0; i < std::min(kShown, places.size()); ++i) table += " " + places[i];
    if (places.size() > kShown) table += " and " + std::to_string(places.size() - kShown) + " more";
    table += "\n";
  }
  return table;
}

}  // namespace plcxx::policy
