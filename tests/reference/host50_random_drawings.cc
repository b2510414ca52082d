// Random drawings of host50 (3.6): networks of elements in series and in parallel, nested, with trees of outputs.
//
// A part of a drawing is a rectangle of text that is entered at the left end of its first row. Two parts one above the
// other have a row between them, so that junctions in one column never touch.

#include <algorithm>
#include <string>
#include <utility>

#include "tests/reference/host50_random_networks.h"

namespace plcxx::reference::host50_random {
namespace {

constexpr size_t kMaxRows = 50, kMaxElements = 9;

void Widen(std::vector<std::string>& rows, size_t width) {
  for (size_t i = 0; i < rows.size(); ++i) rows[i].resize(std::max(width, rows[i].size()), i == 0 ? '-' : ' ');
}

}  // namespace

std::string Networks::DrawnContact() {
  ++made_;
  return random_.Pick(Texts{"[ ", "[ ", "[/", "[P ", "[N "}) + Bit() + " ]";
}

/// A row of a drawing has no tabs and no second line.
std::string Networks::OneLine(std::string text) {
  for (size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n")) text.erase(at, 2);
  std::ranges::replace(text, '\t', ' ');
  return text;
}

/// What conducts: contacts, blocks with Q, and a block without Q, whose output is its input.
std::string Networks::DrawnElement() {
  switch (random_.Below(14)) {
    case 0:
      return "{" + OneLine(Timer()) + "}";
    case 1:
      return "{" + OneLine(Compare()) + "}";
    case 2: {
      const std::string preset = Whole(), p = Pin("P"), m = Pin("M");
      return "{CNUD " + random_.Pick(counters_) + ", " + preset + ", " + p + ", " + m + ", " + Pin("N") + "}";
    }
    case 3: {
      const std::string positions = std::to_string(random_.Between(3, 12)), current = Whole(), target = Whole();
      const std::string result = WholeResult();
      return "{ROT " + positions + ", " + current + ", " + target + ", " + result + ", " + Pin("M") + "}";
    }
    case 4:
      return "{" + OneLine(BlockWithoutQ()) + "}";
    default:
      return DrawnContact();
  }
}

std::string Networks::DrawnOutput() {
  ++made_;
  if (section_ == Section::kOther && position_ + 1 < count_ && random_.OneIn(8)) {
    return "{LBL J" + Padded(random_.Between(position_ + 1, count_ - 1) + 10) + "}";
  }
  if (random_.OneIn(3)) return "{" + OneLine(BlockWithoutQ()) + "}";
  if (random_.OneIn(8)) return "{" + OneLine(Timer()) + "}";
  return random_.Pick(Texts{"( ", "( ", "(/", "(S ", "(R "}) + Coil() + " )";
}

Networks::Rows Networks::InSeries(const Rows& left, const Rows& right) {
  Rows rows = left;
  const size_t width = left[0].size();
  for (size_t i = rows.size(); i < right.size(); ++i) rows.emplace_back(width, ' ');
  for (size_t i = 0; i < rows.size(); ++i) {
    rows[i] += i == 0 ? "--" : "  ";
    rows[i] += i < right.size() ? right[i] : std::string(right[0].size(), ' ');
  }
  return rows;
}

Networks::Rows Networks::InParallel(const Rows& upper, const Rows& lower) {
  Rows above = upper, below = lower;
  const size_t width = std::max(upper[0].size(), lower[0].size());
  Widen(above, width);
  Widen(below, width);
  Rows rows;
  for (size_t i = 0; i < above.size(); ++i) {
    rows.push_back((i == 0 ? "+-" : "| ") + above[i] + (i == 0 ? "-+" : " |"));
  }
  rows.push_back("| " + std::string(width, ' ') + " |");
  for (size_t i = 0; i < below.size(); ++i) {
    rows.push_back((i == 0 ? "+-" : "  ") + below[i] + (i == 0 ? "-+" : "  "));
  }
  return rows;
}

/// Left at the right end of its first row; at most so many elements in a row.
Networks::Rows Networks::Conducting(uint32_t depth, uint32_t elements) {
  if (depth == 0 || elements < 2 || random_.OneIn(3)) return {DrawnElement()};
  if (random_.OneIn(2)) {
    const uint32_t first = random_.Between(1, elements - 1);
    const Rows left = Conducting(depth - 1, first);
    return InSeries(left, Conducting(depth - 1, elements - first));
  }
  Rows rows = Conducting(depth - 1, elements);
  for (uint32_t i = random_.Between(1, 2); i > 0; --i) rows = InParallel(rows, Conducting(depth - 1, elements));
  return rows;
}

/// Nothing is to its right.
Networks::Rows Networks::Ending(uint32_t depth, uint32_t elements) {
  if (depth == 0 || elements < 3 || random_.OneIn(3)) return {DrawnOutput()};
  if (random_.OneIn(2)) {
    const uint32_t first = random_.Between(1, elements - 2);
    const Rows left = Conducting(depth - 1, first);
    return InSeries(left, Ending(depth - 1, elements - first));
  }
  Rows rows;
  const uint32_t branches = random_.Between(2, 3);
  for (uint32_t branch = 0; branch < branches; ++branch) {
    const Rows more = Ending(depth - 1, elements);
    if (branch != 0) rows.emplace_back("|");
    for (size_t i = 0; i < more.size(); ++i) {
      const bool goes_on = branch + 1 < branches;
      rows.push_back((i == 0 ? "+--" : goes_on ? "|  " : "   ") + more[i]);
    }
  }
  size_t width = 0;
  for (const std::string& row : rows) width = std::max(width, row.size());
  for (std::string& row : rows) row.resize(width, ' ');
  return rows;
}

Piece Networks::Drawing() {
  std::string text;
  size_t rows = 0;
  for (uint32_t rungs = random_.OneIn(3) ? random_.Between(2, 4) : 1; rungs > 0; --rungs) {
    const uint32_t depth = std::min(deepest_, 3u);
    Rows rung = Conducting(depth, 5);
    rung = InSeries(rung, Ending(depth, kMaxElements - 5));
    if (rows + rung.size() >= kMaxRows) break;
    rows += rung.size();
    for (size_t i = 0; i < rung.size(); ++i) {
      std::string row = (i == 0 ? "  |--" : "  |  ") + rung[i];
      row.erase(row.find_last_not_of(' ') + 1);
      text += "\n" + row;
    }
    // A row without cells between rungs breaks what would touch.
    text += Spelled({"\n", "\n", "\n  ; the next rung"});
  }
  std::string remark;
  if (random_.OneIn(8)) remark = "REMARK \"a drawing\"\n";
  return {remark + "LADDER" + text + "\nEND_LADDER", {}, ""};
}

}  // namespace plcxx::reference::host50_random
