// One place is another one: what tests/diff/source_edits.h does to a line, and what concerns several lines or none.
#include <algorithm>

#include "tests/diff/source_edits.h"
#include "tests/pairs/pair.h"

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

/// Another number in an option: a period, slices, a preset.
bool ChangeOption(Pair& pair, Random& random) {
  ProgramOptions& options = pair.new_program.options;
  if (options.empty()) return false;
  auto option = options.begin();
  std::advance(option, Below(random, options.size()));
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

Pair Mutated(const ProgramText& program, Random& random) {
  Pair pair{.old_program = program, .new_program = program, .what = {}};
  for (int tries = 0; tries < 10; ++tries) {
    const uint32_t which = Below(random, 16);
    const bool done = which < 9    ? EditToken(pair, random)
                      : which < 11 ? SwapNeighbours(pair, random)
                      : which < 13 ? MoveFar(pair, random)
                      : which < 15 ? Remove(pair, random)
                                   : ChangeOption(pair, random);
    if (done) return pair;
    pair.new_program = program;
  }
  return pair;
}

}  // namespace plcxx::pairs
