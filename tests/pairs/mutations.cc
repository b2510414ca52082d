// One place is another one: what tests/diff/source_edits.h does to a line, and what concerns several lines or none.
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "tests/diff/source_edits.h"
#include "tests/pairs/pair.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::pairs {
namespace {

bool IsEmpty(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

/// The next line that is not empty; the number of lines when there is none.
size_t NextLine(const std::vector<std::string>& lines, size_t from) {
  while (from < lines.size() && IsEmpty(lines[from])) ++from;
  return from;
}

const std::string& AnySource(const ProgramText& program, Random& random) {
  return program.sources[Below(random, program.sources.size())];
}

bool SwapNeighbours(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const size_t at = NextLine(lines, Below(random, lines.size())), next = NextLine(lines, at + 1);
  if (next >= lines.size() || lines[at] == lines[next]) return false;
  pair.what = "line " + std::to_string(at + 1) + " and the next one are swapped: '" + lines[at] + "'";
  std::swap(lines[at], lines[next]);
  text = TextOf(lines);
  return true;
}

/// Anywhere: over the border of the fast part, into another module.
bool MoveFar(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const size_t at = NextLine(lines, Below(random, lines.size())), to = Below(random, lines.size());
  if (at >= lines.size() || at == to) return false;
  std::string moved = lines[at];
  pair.what = "line " + std::to_string(at + 1) + " moved to " + std::to_string(to + 1) + ": '" + moved + "'";
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(std::min(to, lines.size())), std::move(moved));
  text = TextOf(lines);
  return true;
}

bool Remove(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const size_t at = NextLine(lines, Below(random, lines.size()));
  if (at >= lines.size()) return false;
  pair.what = "line " + std::to_string(at + 1) + " is gone: '" + lines[at] + "'";
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
  text = TextOf(lines);
  return true;
}

bool IsWordSign(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/// Where words and numbers of a line begin and end.
std::vector<std::pair<size_t, size_t>> WordsOf(const std::string& line) {
  std::vector<std::pair<size_t, size_t>> words;
  for (size_t i = 0; i < line.size(); ++i) {
    if (!IsWordSign(line[i])) continue;
    const size_t begin = i;
    while (i < line.size() && IsWordSign(line[i])) ++i;
    words.emplace_back(begin, i);
  }
  return words;
}

/// A line that has something; none: there is none.
std::optional<size_t> AnyLine(const std::vector<std::string>& lines, Random& random) {
  const size_t at = NextLine(lines, Below(random, lines.size()));
  return at < lines.size() ? std::optional<size_t>(at) : std::nullopt;
}

/// Two operands of one statement change places.
bool SwapOperands(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const std::optional<size_t> at = AnyLine(lines, random);
  if (!at) return false;
  std::string& line = lines[*at];
  const auto words = WordsOf(line);
  if (words.size() < 2) return false;
  size_t one = Below(random, words.size()), other = Below(random, words.size());
  if (one > other) std::swap(one, other);
  const std::string first = line.substr(words[one].first, words[one].second - words[one].first);
  const std::string second = line.substr(words[other].first, words[other].second - words[other].first);
  if (first == second) return false;
  pair.what = "line " + std::to_string(*at + 1) + ": " + first + " and " + second + " change places in '" + line + "'";
  line.replace(words[other].first, second.size(), first);
  line.replace(words[one].first, first.size(), second);
  text = TextOf(lines);
  return true;
}

/// Pasted twice, or a second time somewhere else.
bool CopyLine(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const std::optional<size_t> at = AnyLine(lines, random);
  if (!at) return false;
  const size_t to = random.OneIn(2) ? *at : Below(random, lines.size());
  pair.what =
      "line " + std::to_string(*at + 1) + " once more in front of " + std::to_string(to + 1) + ": '" + lines[*at] + "'";
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to), std::string(lines[*at]));
  text = TextOf(lines);
  return true;
}

/// A network, a rung, a part of a module.
bool MoveBlock(Pair& pair, Random& random) {
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> lines = LinesOf(text);
  const size_t count = 2 + Below(random, 4), at = Below(random, lines.size());
  if (at + count > lines.size()) return false;
  const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(at);
  const std::vector<std::string> moved(begin, begin + static_cast<std::ptrdiff_t>(count));
  lines.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  const size_t to = Below(random, lines.size() + 1);
  if (to == at) return false;
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to), moved.begin(), moved.end());
  pair.what =
      "lines " + std::to_string(at + 1) + " to " + std::to_string(at + count) + " moved to " + std::to_string(to + 1);
  text = TextOf(lines);
  return true;
}

/// A preset, an initial value, an index, an address: the number of an operand becomes one that the program has
/// elsewhere, the limit of a type, or goes over the border between memory that is kept and memory that is not.
bool AnotherNumber(Pair& pair, Random& random) {
  static const std::vector<std::string> kLimits{"0", "1", "2", "15", "16", "99", "100", "255", "256", "500", "501"};
  std::string& text = pair.new_program.files[AnySource(pair.new_program, random)];
  std::vector<std::string> numbers = kLimits;
  const auto digits_of = [](const std::string& from, size_t begin) {
    size_t end = begin;
    while (end < from.size() && from[end] >= '0' && from[end] <= '9') ++end;
    return end - begin;
  };
  std::vector<size_t> places;
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t digits = digits_of(text, i);
    if (digits == 0) continue;
    places.push_back(i);
    numbers.push_back(text.substr(i, digits));
    i += digits;
  }
  if (places.empty()) return false;
  const size_t at = places[Below(random, places.size())];
  const std::string before = text.substr(at, digits_of(text, at));
  const std::string& after = numbers[Below(random, numbers.size())];
  if (before == after) return false;
  const size_t line = LinesOf(text.substr(0, at)).size();
  pair.what = "line " + std::to_string(line) + ": " + before + " becomes " + after;
  text.replace(at, before.size(), after);
  return true;
}

/// Of the simulated control: no part of the program, and of what answers its requests diff assumes nothing. The attack
/// is with both versions' own, though, and sees two controls.
bool IsOfSimulation(const std::string& dialect, const std::string& option) {
  const std::span<const dialects::OptionInfo> options = dialects::DialectByName(dialect)->options;
  const auto info = std::ranges::find(options, option, &dialects::OptionInfo::key);
  return info != options.end() && info->is_of_simulation;
}

/// Another number in an option: a period, slices, a preset.
bool ChangeOption(Pair& pair, Random& random) {
  ProgramOptions& options = pair.new_program.options;
  if (options.empty()) return false;
  auto option = options.begin();
  std::advance(option, Below(random, options.size()));
  if (IsOfSimulation(pair.new_program.dialect, option->first)) return false;
  const size_t digit = option->second.find_first_of("0123456789");
  if (digit == std::string::npos || pair.new_program.files.contains(option->second)) {
    pair.what = "without the option " + option->first;
    if (pair.new_program.files.contains(option->second)) return false;
    options.erase(option);
    return true;
  }
  option->second[digit] = static_cast<char>('1' + Below(random, 9));
  pair.what = "option " + option->first + ": " + option->second;
  return true;
}

bool EditToken(Pair& pair, Random& random) {
  const review::diff::SourceEdit edit = review::diff::EditedSource(pair.new_program.files, random);
  if (edit.file.empty()) return false;
  pair.new_program.files[edit.file] = edit.text;
  pair.what = edit.file + " " + edit.what;
  return true;
}

}  // namespace

namespace {

bool MutateOnce(Pair& pair, Random& random) {
  const uint32_t which = Below(random, 24);
  if (which < 9) return EditToken(pair, random);
  if (which < 11) return SwapNeighbours(pair, random);
  if (which < 13) return MoveFar(pair, random);
  if (which < 15) return Remove(pair, random);
  if (which < 17) return SwapOperands(pair, random);
  if (which < 18) return CopyLine(pair, random);
  if (which < 20) return MoveBlock(pair, random);
  if (which < 23) return AnotherNumber(pair, random);
  return ChangeOption(pair, random);
}

}  // namespace

Pair Mutated(const ProgramText& program, Random& random) {
  Pair pair{.old_program = program, .new_program = program, .what = {}};
  // Now and then a change of several places, as a commit has.
  const uint32_t wanted = random.OneIn(5) ? 2 + Below(random, 2) : 1;
  std::string what;
  for (uint32_t tries = 0, done = 0; tries < 10 && done < wanted; ++tries) {
    const ProgramText before = pair.new_program;
    pair.what.clear();
    if (!MutateOnce(pair, random)) {
      pair.new_program = before;
      continue;
    }
    what += (what.empty() ? "" : "; ") + pair.what;
    ++done;
  }
  pair.what = what;
  return pair;
}

}  // namespace plcxx::pairs
