#include "tests/printed/groups.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace plcxx::printed {
namespace {

/// How often each line is below a heading.
using Counts = std::map<std::string, std::map<std::string, int>>;

Counts CountsOf(std::string_view text) {
  Counts counts;
  for (const Group& group : GroupsOf(text)) {
    std::map<std::string, int>& lines = counts[group.heading];
    for (const std::string& line : group.lines) ++lines[line];
  }
  return counts;
}

}  // namespace

std::vector<Group> GroupsOf(std::string_view text) {
  std::vector<Group> groups;
  bool after_empty = false;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line(text.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty()) {
      after_empty = true;
      continue;
    }
    if (line.front() == ' ' && !groups.empty()) {
      groups.back().lines.push_back((after_empty ? "\n" : "") + line);
    } else {
      groups.push_back({line, {}});
    }
    after_empty = false;
  }
  return groups;
}

std::string OwnLines(std::string_view text, const std::vector<std::string_view>& known) {
  Counts counts;
  for (const std::string_view one : known) {
    for (const auto& [heading, lines] : CountsOf(one)) {
      std::map<std::string, int>& most = counts[heading];
      for (const auto& [line, count] : lines) most[line] = std::max(most[line], count);
    }
  }
  std::string own;
  for (const Group& group : GroupsOf(text)) {
    const auto same = counts.find(group.heading);
    std::string lines;
    for (const std::string& line : group.lines) {
      if (same != counts.end() && same->second[line]-- > 0) continue;
      lines += line + '\n';
    }
    if (!lines.empty() || same == counts.end()) own += group.heading + '\n' + lines;
  }
  return own;
}

std::string WithoutNumbers(std::string_view text) {
  std::string out;
  bool in_value = false;
  for (const char c : text) {
    in_value = c == '%' || (in_value && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'));
    if (!in_value || c == '%') out += c;
  }
  return out;
}

std::string Headings(std::string_view text) {
  std::string headings;
  for (const Group& group : GroupsOf(text)) {
    if (group.heading.ends_with('{')) headings += group.heading + '\n';
  }
  return headings;
}

}  // namespace plcxx::printed
