#include "tests/reference/made_forms.h"

#include <sstream>
#include <utility>

#include "tests/reference/made_forms_tables.h"

namespace plcxx::reference {

namespace forms {

std::vector<std::string> Parts(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::string part;
  int depth = 0;
  const auto close = [&] {
    const size_t first = part.find_first_not_of(' ');
    if (first != std::string::npos) parts.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
    part.clear();
  };
  for (const char c : text) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c == separator && depth == 0) {
      close();
    } else {
      part += c;
    }
  }
  close();
  return parts;
}

std::string CountPairs(const std::string& expression, const LeafKind& kind_of, FormCounts& counts) {
  if (!expression.starts_with('(')) return kind_of(expression);
  const std::vector<std::string> parts = Parts(expression.substr(1, expression.rfind(')') - 1), ' ');
  if (parts.empty()) return "";
  for (size_t i = 1; i < parts.size(); ++i) ++counts[parts[0] + " " + CountPairs(parts[i], kind_of, counts)];
  return parts[0];
}

}  // namespace forms

namespace {

struct Row {
  std::string_view dialect;
  std::set<std::string> (*all)();
  void (*count)(const std::string& line, FormCounts& counts);
};
constexpr Row kRows[] = {{"host50", forms::OfHost50, forms::CountHost50},
                         {"nc110", forms::OfNc110, forms::CountNc110},
                         {"prostep", forms::OfProstep, forms::CountProstep},
                         {"technol", forms::OfTechnol, forms::CountTechnol}};

}  // namespace

std::set<std::string> FormsOf(std::string_view dialect) {
  for (const Row& row : kRows) {
    if (row.dialect == dialect) return row.all();
  }
  return {};
}

void CountForms(std::string_view dialect, const std::string& syntax, FormCounts& counts) {
  for (const Row& row : kRows) {
    if (row.dialect != dialect) continue;
    std::istringstream lines(syntax);
    for (std::string line; std::getline(lines, line);) row.count(line, counts);
  }
}

}  // namespace plcxx::reference
