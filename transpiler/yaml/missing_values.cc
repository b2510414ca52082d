#include "transpiler/yaml/missing_values.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

namespace plcxx::yaml {
namespace {

/// From 0, the column in bytes, as the parser counts.
struct Spot {
  size_t line = 0, column = 0;
  auto operator<=>(const Spot&) const = default;
};

/// To assign one node to another changes the tree, so that nodes stay where they are while their places are sorted.
struct MissingValue {
  Spot spot;
  size_t node = 0;  // its number
};

class MissingValues {
 public:
  explicit MissingValues(std::string_view text) {
    for (size_t begin = 0; begin <= text.size();) {
      const size_t end = std::min(text.find('\n', begin), text.size());
      lines_.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  void Find(const YAML::Node& root) {
    std::vector<YAML::Node> waiting = {root};
    while (!waiting.empty()) {
      const YAML::Node node = waiting.back();
      waiting.pop_back();
      const YAML::Mark mark = node.Mark();
      if (node.IsNull() && IsMissing(mark)) {
        const Spot spot = BehindLastText(mark);
        if (spot.line != static_cast<size_t>(mark.line)) {
          found_.push_back({spot, nodes_.size()});
          nodes_.push_back(node);
        }
      }
      // An alias is what its anchor marks, at the same place; once is enough.
      if (!(node.IsMap() || node.IsSequence()) || !seen_.insert({mark.line, mark.column, node.IsMap()}).second)
        continue;
      for (const auto& element : node) waiting.push_back(node.IsMap() ? element.second : YAML::Node(element));
    }
    std::ranges::sort(found_, {}, &MissingValue::spot);
  }

  /// Each is read once more, in a list that has it where it should be: a node's place is where it was read.
  void Place() {
    std::string list = "[";
    Spot at = {0, 1};
    std::vector<size_t> numbers;
    for (const MissingValue& value : found_) {
      if (value.spot < at) continue;
      list.append(value.spot.line - at.line, '\n');
      if (value.spot.line != at.line) at.column = 0;
      list.append(value.spot.column - at.column, ' ').append("~,");
      at = {value.spot.line, value.spot.column + 2};
      numbers.push_back(value.node);
    }
    if (numbers.empty()) return;
    const YAML::Node placed = YAML::Load(list + "]");
    for (size_t i = 0; i < numbers.size(); ++i) nodes_[numbers[i]] = placed[i];
  }

 private:
  /// Not written as '~' or null, nor with an anchor or a tag alone.
  bool IsMissing(const YAML::Mark& mark) const {
    if (mark.is_null() || static_cast<size_t>(mark.line) >= lines_.size()) return false;
    const std::string_view line = lines_[static_cast<size_t>(mark.line)];
    const std::string_view word = line.substr(std::min(static_cast<size_t>(mark.column), line.size()));
    return std::ranges::none_of(std::initializer_list<std::string_view>{"~", "null", "Null", "NULL", "&", "!"},
                                [word](std::string_view start) { return word.starts_with(start); });
  }

  /// Between what it is missing behind and the next word there are blanks and comments only.
  Spot BehindLastText(const YAML::Mark& mark) const {
    auto line = static_cast<size_t>(mark.line);
    std::string_view text = lines_[line].substr(0, static_cast<size_t>(mark.column));
    while (true) {
      const size_t comment = text.starts_with('#') ? 0 : std::min(text.find(" #"), text.find("\t#"));
      text = text.substr(0, comment);
      const size_t last = text.find_last_not_of(" \t\r");
      if (last != std::string_view::npos) return {line, last + 1};
      if (line == 0) return {static_cast<size_t>(mark.line), static_cast<size_t>(mark.column)};
      text = lines_[--line];
    }
  }

  std::vector<std::string_view> lines_;
  std::vector<MissingValue> found_;
  std::vector<YAML::Node> nodes_;
  std::set<std::tuple<int, int, bool>> seen_;
};

}  // namespace

void PlaceMissingValues(YAML::Node& root, const std::string& text) {
  MissingValues missing(text);
  missing.Find(root);
  missing.Place();
}

}  // namespace plcxx::yaml
