// Random projects of dialect classicladder: a tree of rungs, expressions, presets and sections, changed in one place or
// written in another way.
#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

#include "tests/pairs/pair.h"

namespace plcxx::pairs {
namespace {

constexpr size_t kWidth = 10, kHeight = 6;
constexpr const char* kNoCell = "0-0-0/0";

struct Element {
  int kind = 0;  // 0 none, 1 and 2 contacts, 3 and 4 edges, 9 a wire, 50 to 53 coils, 99 a part of a block ...
  bool is_joined = false;  // with the row above, on the left side
  int variable = 0, number = 0;
};
using Rung = std::array<std::array<Element, kWidth>, kHeight>;

/// Variables as the project numbers their kinds: bits, inputs, outputs, timers' and monostables' and counters' ends.
struct VariableKind {
  int kind, count;
};
constexpr VariableKind kRead[] = {{0, 8},  {50, 8}, {60, 8}, {10, 1}, {11, 1},
                                  {15, 1}, {20, 1}, {25, 1}, {70, 2}, {30, 3}};
constexpr VariableKind kCoils[] = {{0, 8}, {60, 8}, {60, 8}};
constexpr VariableKind kWords[] = {{200, 5}, {270, 2}, {280, 3}, {231, 2}, {251, 2}, {230, 2}};
constexpr VariableKind kTargets[] = {{200, 5}, {200, 5}, {280, 3}};

struct Ladder {
  std::vector<std::string> timers, monostables, counters, iec_timers;
  std::vector<std::string> expressions;
  std::vector<Rung> rungs;        // in the order of their execution
  std::vector<int> numbers;       // of each, in the file
  size_t first_of_second = 0;     // rungs from here on are in a section of their own
  std::vector<std::string> page;  // sequential; may be empty
};

class LadderGenerator {
 public:
  explicit LadderGenerator(Random& random) : random_(random) {}

  Ladder Make() {
    Ladder ladder;
    const auto presets = [&](std::vector<std::string>& list, bool has_mode) {
      for (int i = 0; i < 3; ++i)
        list.push_back("2," + std::to_string(Below(random_, 5)) +
                       (has_mode ? "," + std::to_string(Below(random_, 3)) : ""));
    };
    presets(ladder.timers, false);
    presets(ladder.monostables, false);
    presets(ladder.iec_timers, true);
    for (int i = 0; i < 3; ++i) ladder.counters.push_back(std::to_string(Below(random_, 5)));
    const uint32_t count = 2 + Below(random_, 4);
    for (uint32_t i = 0; i < count; ++i) {
      ladder.rungs.push_back(MakeRung(ladder, i));
      ladder.numbers.push_back(static_cast<int>(i));
    }
    ladder.first_of_second = Below(random_, count) + 1;
    if (random_.OneIn(3)) MakePage(ladder);
    return ladder;
  }

  std::string Expression(bool is_comparison) {
    static const std::vector<std::string> kRelations{"<", "<=", "=", "<>", ">", ">="};
    if (is_comparison) return Sum(2) + Pick(kRelations) + (random_.OneIn(2) ? Number() : Sum(1));
    return Variable(kTargets) + ":=" + Sum(2);
  }
  std::string Number() { return std::to_string(Below(random_, 12)); }

 private:
  template <class List>
  const typename List::value_type& Pick(const List& list) {
    return list[Below(random_, list.size())];
  }
  template <size_t count>
  std::pair<int, int> AnyOf(const VariableKind (&kinds)[count]) {
    const VariableKind& kind = kinds[Below(random_, count)];
    return {kind.kind, static_cast<int>(Below(random_, static_cast<size_t>(kind.count)))};
  }
  template <size_t count>
  std::string Variable(const VariableKind (&kinds)[count]) {
    const auto [kind, number] = AnyOf(kinds);
    return "@" + std::to_string(kind) + "/" + std::to_string(number) + "@";
  }

  std::string Sum(int terms) {
    static const std::vector<std::string> kSigns{"+", "-", "*", "&", "|", "^"};
    std::string text = random_.OneIn(4) ? Number() : Variable(kWords);
    for (int i = 1; i < terms && !random_.OneIn(3); ++i)
      text += Pick(kSigns) + (random_.OneIn(3) ? Number() : Variable(kWords));
    return text;
  }

  Rung MakeRung(Ladder& ladder, uint32_t which) {
    Rung rung;
    const auto block = [&](int kind, int number, size_t x, size_t y, size_t left, size_t below) {
      for (size_t i = x - left; i <= x; ++i) {
        for (size_t k = y; k <= y + below; ++k) rung[k][i] = {.kind = 99};
      }
      rung[y][x] = {.kind = kind, .number = number};
    };
    const auto expression = [&](bool is_comparison) {
      ladder.expressions.push_back(Expression(is_comparison));
      return static_cast<int>(ladder.expressions.size() - 1);
    };
    const size_t rows = 1 + Below(random_, 3);
    // Each block stands once.
    if (which == 0) block(10, 0, 3, rows, 1, 1);
    if (which == 1) block(13, 0, 3, rows, 1, 1);
    if (which == 2) block(12, 0, 3, 0, 1, 3);
    if (which == 3) block(11, 0, 3, rows, 1, 1);
    if (which > 0 && random_.OneIn(2)) block(20, expression(true), 6, 0, 2, 0);
    if (which > 0 && random_.OneIn(2)) block(60, expression(false), 9, rows == 3 ? 2 : rows, 2, 0);
    for (size_t y = 0; y < rows; ++y) {
      for (size_t x = 0; x < kWidth; ++x) {
        Element& element = rung[y][x];
        if (element.kind != 0) continue;
        element.is_joined = y > 0 && random_.OneIn(4);
        const uint32_t choice = Below(random_, 20);
        if (x == kWidth - 1 || (x > 5 && choice < 3)) {
          static const std::vector<int> kKinds{50, 50, 50, 51, 52, 53};
          element.kind = Pick(kKinds);
          std::tie(element.variable, element.number) = AnyOf(kCoils);
        } else if (choice < 8) {
          element.kind = 9;
        } else if (choice < 19) {
          static const std::vector<int> kKinds{1, 1, 1, 2, 2, 3, 4};
          element.kind = Pick(kKinds);
          std::tie(element.variable, element.number) = AnyOf(kRead);
        }
      }
    }
    return rung;
  }

  void MakePage(Ladder& ladder) {
    const int steps = 2 + static_cast<int>(Below(random_, 3));
    ladder.page.emplace_back("#VER=1.0");
    for (int i = 0; i < steps; ++i) {
      const std::string number = std::to_string(i);
      ladder.page.push_back("S" + number + "," + (i == 0 ? "1" : "0") + "," + number + ",0,1,1");
    }
    const std::string none = ",-1,-1,-1,-1,-1,-1,-1,-1,-1";
    for (int i = 0; i < steps; ++i) {
      const std::string number = std::to_string(i);
      std::string links;
      for (int k = 0; k < 20; ++k) links += ",-1";
      ladder.page.push_back("T" + number + "," + std::to_string((i + 1) % steps) + none + "," + number + none + links +
                            ",0,1,1");
      const auto [kind, of] = AnyOf(kRead);
      ladder.page.push_back("C" + number + ",0," + std::to_string(kind) + "/" + std::to_string(of));
    }
  }

  Random& random_;
};

std::string Print(const Ladder& ladder) {
  std::string text = "_FILES_CLASSICLADDER\n";
  const auto part = [&text](const std::string& name, const std::vector<std::string>& lines) {
    text += "_FILE-" + name + "\n";
    for (const std::string& line : lines) text += line + "\n";
    text += "_/FILE-" + name + "\n";
  };
  part("timers.csv", ladder.timers);
  part("monostables.csv", ladder.monostables);
  part("counters.csv", ladder.counters);
  part("timers_iec.csv", ladder.iec_timers);
  std::vector<std::string> expressions{"#VER=2.0"};
  for (size_t i = 0; i < ladder.expressions.size(); ++i) {
    const std::string number = std::to_string(i);
    expressions.push_back(std::string(4 - number.size(), '0') + number + "," + ladder.expressions[i]);
  }
  part("arithmetic_expressions.csv", expressions);
  if (!ladder.page.empty()) part("sequential.csv", ladder.page);
  const size_t count = ladder.rungs.size(), second = std::min(ladder.first_of_second, count);
  std::vector<std::string> sections{"#VER=1.0"};
  const auto section = [&](size_t begin, size_t end) {
    if (begin == end) return;
    sections.push_back("00" + std::to_string(sections.size() - 1) + ",0,-1," + std::to_string(ladder.numbers[begin]) +
                       "," + std::to_string(ladder.numbers[end - 1]) + ",0");
  };
  section(0, second);
  if (!ladder.page.empty()) sections.push_back("00" + std::to_string(sections.size() - 1) + ",1,-1,0,0,0");
  section(second, count);
  part("sections.csv", sections);
  for (size_t i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count || i + 1 == second;
    std::vector<std::string> lines{"#VER=2.0", "#NEXTRUNG=" + std::to_string(is_last ? -1 : ladder.numbers[i + 1])};
    for (const auto& row : ladder.rungs[i]) {
      std::string line;
      for (const Element& element : row) {
        line += (line.empty() ? "" : " , ");
        line += element.kind == 0 && !element.is_joined
                    ? std::string(kNoCell)
                    : std::to_string(element.kind) + (element.is_joined ? "-1-" : "-0-") +
                          std::to_string(element.variable) + "/" + std::to_string(element.number);
      }
      lines.push_back(line);
    }
    part("rung_" + std::to_string(ladder.numbers[i]) + ".csv", lines);
  }
  return text + "_/FILES_CLASSICLADDER\n";
}

/// Whether nothing of the column writes a variable: the engine goes from column to column, and a contact reads what a
/// coil on its left has written.
bool WritesNothing(const Rung& rung, size_t x) {
  return std::ranges::all_of(rung, [x](const auto& row) { return row[x].kind <= 4 || row[x].kind == 9; });
}

bool IsContact(const Element& element) { return element.kind == 1 || element.kind == 2; }
bool IsCoil(const Element& element) { return element.kind >= 50 && element.kind <= 53; }

/// An element of the kind that is asked for; none: there is none.
template <class Condition>
Element* AnyElement(Ladder& ladder, Random& random, const Condition& is_wanted) {
  std::vector<Element*> found;
  for (Rung& rung : ladder.rungs) {
    for (auto& row : rung) {
      for (Element& element : row) {
        if (is_wanted(element)) found.push_back(&element);
      }
    }
  }
  return found.empty() ? nullptr : found[Below(random, found.size())];
}

bool ChangeNumberIn(std::string& text, Random& random, std::string& what) {
  std::vector<size_t> digits;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    const bool begins = i == 0 || text[i - 1] < '0' || text[i - 1] > '9';
    const bool ends = i + 1 == text.size() || text[i + 1] < '0' || text[i + 1] > '9';
    // Kinds of variables and the base of a time have no digit that could be any.
    if (is_digit && begins && ends) digits.push_back(i);
  }
  if (digits.empty()) return false;
  const std::string before = text;
  text[digits[Below(random, digits.size())]] = static_cast<char>('0' + Below(random, 5));
  what = before + " becomes " + text;
  return before != text;
}

/// What a colleague changes in a drawing.
bool ChangeLadder(Ladder& ladder, Random& random, std::string& what) {
  const auto is_contact_or_edge = [](const Element& e) { return e.kind >= 1 && e.kind <= 4; };
  switch (Below(random, 11)) {
    case 0:
    case 1: {
      Element* const element = AnyElement(ladder, random, is_contact_or_edge);
      if (element == nullptr) return false;
      const int kind = 1 + static_cast<int>(Below(random, 4));
      what = "a contact of kind " + std::to_string(element->kind) + " becomes " + std::to_string(kind);
      return std::exchange(element->kind, kind) != kind;
    }
    case 2: {
      Element* const element = AnyElement(ladder, random, IsCoil);
      if (element == nullptr) return false;
      const int kind = 50 + static_cast<int>(Below(random, 4));
      what = "a coil of kind " + std::to_string(element->kind) + " becomes " + std::to_string(kind);
      return std::exchange(element->kind, kind) != kind;
    }
    case 3: {
      Element* const element = AnyElement(ladder, random, [&](const Element& e) {
        return (is_contact_or_edge(e) || IsCoil(e)) && (e.variable == 0 || e.variable == 50 || e.variable == 60);
      });
      if (element == nullptr) return false;
      const int number = static_cast<int>(Below(random, 8));
      what = "number " + std::to_string(element->number) + " becomes " + std::to_string(number);
      return std::exchange(element->number, number) != number;
    }
    case 4: {
      Element* const element = AnyElement(ladder, random, is_contact_or_edge);
      if (element == nullptr) return false;
      what = random.OneIn(2) ? "a contact becomes a wire" : "a contact is gone";
      *element = {.kind = what == "a contact is gone" ? 0 : 9, .is_joined = element->is_joined};
      return true;
    }
    case 5: {
      Element* const element = AnyElement(ladder, random, [](const Element& e) { return e.kind != 0; });
      if (element == nullptr || element->kind == 99) return false;
      what = "a join with the row above comes or goes";
      element->is_joined = !element->is_joined;
      return true;
    }
    case 6: {
      if (ladder.rungs.size() < 2) return false;
      const size_t one = Below(random, ladder.rungs.size() - 1);
      what = "rungs " + std::to_string(one) + " and the next one change places";
      std::swap(ladder.rungs[one], ladder.rungs[one + 1]);
      return true;
    }
    case 7: {
      std::vector<std::string>* const lists[] = {&ladder.timers, &ladder.monostables, &ladder.counters};
      std::string& preset = (*lists[Below(random, std::size(lists))])[0];
      const size_t comma = preset.find(',');
      const std::string before = preset;
      preset = (comma == std::string::npos ? "" : preset.substr(0, comma + 1)) + std::to_string(Below(random, 7));
      what = "preset " + before + " becomes " + preset;
      return before != preset;
    }
    case 8:
    case 9: {
      if (ladder.expressions.empty()) return false;
      std::string& expression = ladder.expressions[Below(random, ladder.expressions.size())];
      if (random.OneIn(2)) return ChangeNumberIn(expression, random, what);
      static constexpr std::string_view kSigns = "+-*&|^<>";
      const size_t at = expression.find_first_of(kSigns, expression.find('@', 1) + 1);
      if (at == std::string::npos || expression.find_first_of("=<>", at) == at + 1) return false;
      const std::string before = expression;
      const bool is_relation = expression[at] == '<' || expression[at] == '>';
      if (is_relation) {
        if (at > 0 && (expression[at - 1] == '<' || expression[at - 1] == ':')) return false;
        expression[at] = expression[at] == '<' ? '>' : '<';
      } else {
        expression[at] = kSigns[Below(random, 6)];
      }
      what = before + " becomes " + expression;
      return before != expression;
    }
    default: {
      if (ladder.first_of_second >= ladder.rungs.size()) return false;
      what = "a rung moves to the other section, over the page";
      ++ladder.first_of_second;
      return !ladder.page.empty();
    }
  }
}

/// The same drawing, otherwise.
bool RewriteLadder(Ladder& ladder, Random& random, std::string& what) {
  switch (Below(random, 4)) {
    case 0: {
      // Contacts in series without a join between them, above or below.
      struct Place {
        size_t rung, y, x;
      };
      std::vector<Place> places;
      for (size_t r = 0; r < ladder.rungs.size(); ++r) {
        for (size_t y = 0; y < kHeight; ++y) {
          for (size_t x = 0; x + 1 < kWidth; ++x) {
            const Rung& rung = ladder.rungs[r];
            const bool is_free = !rung[y][x + 1].is_joined && (y + 1 == kHeight || !rung[y + 1][x + 1].is_joined) &&
                                 WritesNothing(rung, x) && WritesNothing(rung, x + 1);
            if (is_free && IsContact(rung[y][x]) && IsContact(rung[y][x + 1])) places.push_back({r, y, x});
          }
        }
      }
      if (places.empty()) return false;
      const Place& at = places[Below(random, places.size())];
      auto& row = ladder.rungs[at.rung][at.y];
      std::swap(row[at.x], row[at.x + 1]);
      std::swap(row[at.x].is_joined, row[at.x + 1].is_joined);
      what = "two contacts in series change places";
      return true;
    }
    case 1: {
      // The numbers of the rungs say nothing; that of the first one of a section does not either.
      std::vector<int> numbers = ladder.numbers;
      for (size_t i = numbers.size(); i > 1; --i) std::swap(numbers[i - 1], numbers[Below(random, i)]);
      what = "rungs have other numbers";
      return std::exchange(ladder.numbers, numbers) != ladder.numbers;
    }
    case 2: {
      if (ladder.expressions.size() < 2) return false;
      const size_t one = Below(random, ladder.expressions.size()), other = Below(random, ladder.expressions.size());
      if (one == other) return false;
      std::swap(ladder.expressions[one], ladder.expressions[other]);
      for (Rung& rung : ladder.rungs) {
        for (auto& row : rung) {
          for (Element& element : row) {
            if (element.kind != 20 && element.kind != 60) continue;
            const auto number = static_cast<size_t>(element.number);
            if (number == one || number == other) element.number = static_cast<int>(number == one ? other : one);
          }
        }
      }
      what = "expressions have other numbers";
      return true;
    }
    default: {
      // A wire into which nothing joins: a contact twice is a contact.
      struct Place {
        size_t rung, y, x;
      };
      std::vector<Place> places;
      for (size_t r = 0; r < ladder.rungs.size(); ++r) {
        for (size_t y = 0; y < kHeight; ++y) {
          for (size_t x = 0; x + 1 < kWidth; ++x) {
            const Rung& rung = ladder.rungs[r];
            const bool is_free = !rung[y][x + 1].is_joined && (y + 1 == kHeight || !rung[y + 1][x + 1].is_joined) &&
                                 WritesNothing(rung, x) && WritesNothing(rung, x + 1);
            if (is_free && IsContact(rung[y][x]) && rung[y][x + 1].kind == 9) places.push_back({r, y, x});
          }
        }
      }
      if (places.empty()) return false;
      const Place& at = places[Below(random, places.size())];
      auto& row = ladder.rungs[at.rung][at.y];
      row[at.x + 1] = row[at.x];
      row[at.x + 1].is_joined = false;
      what = "a contact stands twice";
      return true;
    }
  }
}

ProgramText TextOfLadder(const Ladder& ladder) {
  return {.dialect = "classicladder",
          .sources = {"p.clp"},
          .files = {{"p.clp", Print(ladder)}},
          .options = {},
          .scenario = {}};
}

}  // namespace

Pair RandomLadderPair(Random& random, bool alike) {
  Ladder ladder = LadderGenerator(random).Make();
  Pair pair{.old_program = TextOfLadder(ladder), .new_program = {}, .what = {}, .alike = alike};
  const uint32_t wanted = 1 + (random.OneIn(4) ? 1 + Below(random, 2) : 0);
  for (uint32_t tries = 0, done = 0; tries < 20 && done < wanted; ++tries) {
    std::string what;
    if (!(alike ? RewriteLadder(ladder, random, what) : ChangeLadder(ladder, random, what))) continue;
    pair.what += (pair.what.empty() ? "" : "; ") + what;
    ++done;
  }
  pair.new_program = TextOfLadder(ladder);
  return pair;
}

}  // namespace plcxx::pairs
