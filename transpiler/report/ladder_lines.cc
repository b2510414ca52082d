#include "transpiler/report/ladder_lines.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/report/cross_reference.h"
#include "transpiler/report/ladder.h"
#include "transpiler/source/columns.h"

namespace plcxx::report {
namespace {

using source::ColumnsOf;

/// Rows of one width; the wire comes in at the left and goes out at the right of row `wire`.
struct Grid {
  std::vector<std::string> rows;
  size_t columns = 0;
  size_t wire = 0;
};

Grid OneRow(std::string text) {
  const size_t columns = ColumnsOf(text);
  return {{std::move(text)}, columns, 0};
}

/// `above` and `below` more rows around it.
void Extend(Grid& grid, size_t above, size_t below) {
  grid.rows.insert(grid.rows.begin(), above, std::string(grid.columns, ' '));
  grid.rows.insert(grid.rows.end(), below, std::string(grid.columns, ' '));
  grid.wire += above;
}

Grid Beside(Grid left, Grid right) {
  if (left.rows.empty()) return right;
  const size_t above = std::max(left.wire, right.wire);
  const size_t below = std::max(left.rows.size() - left.wire, right.rows.size() - right.wire);
  Extend(left, above - left.wire, below - (left.rows.size() - left.wire));
  Extend(right, above - right.wire, below - (right.rows.size() - right.wire));
  for (size_t i = 0; i < left.rows.size(); ++i) left.rows[i] += (i == left.wire ? "--" : "  ") + right.rows[i];
  left.columns += 2 + right.columns;
  return left;
}

enum class RightEnd : uint8_t { kJoined, kOpen };

/// One below the other, with an upright at the left, and one at the right where they join again.
Grid Below(std::vector<Grid> branches, RightEnd end) {
  size_t columns = 0;
  for (const Grid& branch : branches) columns = std::max(columns, branch.columns);
  Grid all;
  std::vector<size_t> wires;
  for (Grid& branch : branches) {
    for (size_t i = 0; i < branch.rows.size(); ++i) {
      const bool is_wire = i == branch.wire;
      if (is_wire) wires.push_back(all.rows.size());
      const char fill = is_wire && end == RightEnd::kJoined ? '-' : ' ';
      all.rows.push_back((is_wire ? "--" : "  ") + branch.rows[i] + std::string(columns - branch.columns, fill) +
                         (end == RightEnd::kOpen ? ""
                          : is_wire              ? "--"
                                                 : "  "));
    }
  }
  all.wire = wires.front();
  for (size_t i = 0; i < all.rows.size(); ++i) {
    const bool is_wire = std::ranges::find(wires, i) != wires.end();
    const char upright = is_wire ? '+' : i > wires.front() && i < wires.back() ? '|' : ' ';
    all.rows[i].insert(0, 1, upright);
    if (end == RightEnd::kJoined) all.rows[i] += upright;
  }
  all.columns = columns + (end == RightEnd::kJoined ? 6 : 3);
  return all;
}

std::string BoxText(const Element& element) {
  std::string text = "{" + element.title;
  if (!element.name.empty()) text += " " + element.name;
  for (const std::string& line : element.lines) text += (&line == &element.lines.front() ? ": " : ", ") + line;
  return text + "}";
}

Grid GridOf(const Element& element) {
  switch (element.shape) {
    case Shape::kWire:
      return OneRow("----");
    case Shape::kNever:
      return OneRow("[ 0 ]");
    case Shape::kContact:
      return OneRow("[ " + element.name + " ]");
    case Shape::kNotContact:
      return OneRow("[/" + element.name + " ]");
    case Shape::kCompare:
      return OneRow("[ " + element.name + " " + element.title + " " +
                    (element.lines.empty() ? std::string() : element.lines.front()) + " ]");
    case Shape::kInvert:
      return OneRow("[NOT]");
    case Shape::kBox:
      return OneRow(BoxText(element));
    case Shape::kSeries: {
      Grid grid;
      for (const Element& part : element.parts) grid = Beside(std::move(grid), GridOf(part));
      return grid.rows.empty() ? OneRow("----") : grid;
    }
    case Shape::kParallel: {
      std::vector<Grid> branches;
      for (const Element& part : element.parts) branches.push_back(GridOf(part));
      return branches.empty() ? OneRow("----") : Below(std::move(branches), RightEnd::kJoined);
    }
    case Shape::kCoil:
      return OneRow("( " + element.name + " )");
    case Shape::kSet:
      return OneRow("(S " + element.name + " )");
    case Shape::kReset:
      return OneRow("(R " + element.name + " )");
    case Shape::kTarget:
      return OneRow(">> " + element.title);
  }
  return {};
}

Grid GridOf(const Rung& rung) {
  Grid grid = GridOf(rung.network);
  if (rung.outputs.empty()) return grid;
  if (rung.outputs.size() == 1) return Beside(std::move(grid), GridOf(rung.outputs.front()));
  std::vector<Grid> outputs;
  for (const Element& output : rung.outputs) outputs.push_back(GridOf(output));
  return Beside(std::move(grid), Below(std::move(outputs), RightEnd::kOpen));
}

bool Names(const Element& element, std::string_view signal) {
  if (element.name == signal || element.address == signal) return true;
  return std::ranges::any_of(element.parts, [&](const Element& part) { return Names(part, signal); });
}

bool Names(const LadderItem& item, std::string_view signal) {
  return Names(item.rung.network, signal) ||
         std::ranges::any_of(item.rung.outputs, [&](const Element& output) { return Names(output, signal); });
}

class LineWriter {
 public:
  explicit LineWriter(const ProgramInput& input) : input_(input) {}

  void Add(const LadderItem& item) {
    const std::string indent(size_t{2} * item.depth, ' ');
    switch (item.kind) {
      case ItemKind::kStatement:
        return AddStatement(item.statement, indent);
      case ItemKind::kRung:
        return AddRung(item.rung, indent, "");
      case ItemKind::kHead:
        return AddRung(item.rung, indent, " " + item.label + " {");
      case ItemKind::kSection:
        return AddRung(item.rung, indent, " } " + item.label + " {");
      case ItemKind::kEnd:
        text_ += indent + "}" + (item.label.empty() ? "" : " " + item.label) + "\n";
        return;
    }
  }
  void AddTitle(const std::string& title) { text_ += (text_.empty() ? "" : "\n") + title + "\n"; }
  std::string Take() { return std::move(text_); }

 private:
  void AddStatement(ir::StatementId statement, const std::string& indent) {
    const source::Range range = input_.program->statements[statement].range;
    const source::Position at = input_.sources->Locate(range.begin);
    if (!at.file.valid()) return;
    const std::string& path = input_.sources->Get(at.file).path;
    const std::string_view source = input_.sources->Text(range);
    text_ += indent + "; " + path.substr(path.rfind('/') + 1) + ":" + std::to_string(at.line) + "  " +
             std::string(source.substr(0, source.find_first_of("\r\n"))) + "\n";
  }

  void AddRung(const Rung& rung, const std::string& indent, const std::string& behind) {
    const Grid grid = GridOf(rung);
    for (size_t i = 0; i < grid.rows.size(); ++i) {
      std::string row = indent + (i == grid.wire ? "|--" : "|  ") + grid.rows[i] + (i == grid.wire ? behind : "");
      row.erase(row.find_last_not_of(' ') + 1);
      text_ += row + "\n";
    }
  }

  const ProgramInput& input_;
  std::string text_;
};

bool IsSamePlace(const ir::Place& one, const ir::Place& other) {
  if (one.is_field() != other.is_field() || one.indexed != other.indexed) return false;
  if (one.is_field()) return one.state == other.state && one.field == other.field;
  return one.space == other.space && one.offset == other.offset && one.bit == other.bit && one.type == other.type;
}

/// Statements that read, write or step what stands at the place.
std::set<ir::StatementId> StatementsWith(const ProgramInput& input, const CrossReference& uses,
                                         const ir::Place& place) {
  std::set<ir::StatementId> statements;
  for (uint32_t i = 0; i < input.program->places.size(); ++i) {
    if (!IsSamePlace(input.program->places[ir::PlaceId(i)], place) || uses.of_place[i] == kNoSignal) continue;
    for (const Occurrence& occurrence : uses.signals[uses.of_place[i]].occurrences)
      statements.insert(occurrence.statement);
  }
  return statements;
}

/// The items of the wanted statements; frames are left out with what is in them.
std::vector<const LadderItem*> Chosen(const std::vector<LadderItem>& items, const std::optional<WantedRungs>& signal,
                                      const std::set<ir::StatementId>& statements) {
  std::vector<const LadderItem*> chosen, group;
  bool wanted = !signal;
  const auto close = [&] {
    if (wanted) chosen.insert(chosen.end(), group.begin(), group.end());
    group.clear();
    wanted = !signal;
  };
  for (const LadderItem& item : items) {
    if (!item.statement.valid()) continue;  // the control's own
    if (item.kind == ItemKind::kStatement) close();
    group.push_back(&item);
    wanted = wanted || Names(item, signal->word) || statements.contains(item.statement);
  }
  close();
  return chosen;
}

}  // namespace

std::string LadderLines(const ProgramInput& input, const std::optional<WantedRungs>& wanted) {
  const CrossReference uses = MakeCrossReference(input);
  const std::set<ir::StatementId> statements =
      wanted && wanted->place ? StatementsWith(input, uses, *wanted->place) : std::set<ir::StatementId>();
  LineWriter writer(input);
  for (const RoutineLadder& ladder : MakeLadders(input, uses)) {
    const std::vector<const LadderItem*> items = Chosen(ladder.items, wanted, statements);
    if (items.empty()) continue;
    writer.AddTitle("routine " + input.program->routines[ladder.routine].name);
    for (size_t i = 0; i < items.size(); ++i) {
      // A frame's statement comes again at its end, where it owns nothing more.
      const bool closes = i + 1 < items.size() && items[i + 1]->kind == ItemKind::kEnd;
      if (items[i]->kind != ItemKind::kStatement || !closes) writer.Add(*items[i]);
    }
  }
  return writer.Take();
}

}  // namespace plcxx::report
