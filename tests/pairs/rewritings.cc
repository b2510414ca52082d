// Ways to write the same in another way, in four languages whose lines are statements; of hnc see hnc_pairs.cc.
//
// Each is right for every program that compiles, by the rules of the language alone: what is swapped commutes, what is
// renamed is renamed everywhere, what is added is read by nobody.
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "tests/pairs/pair.h"
#include "transpiler/dialects/technol/machine/signals.h"

namespace plcxx::pairs {
namespace {

/// "  ANI  KEY   ; comment": blanks, word, blanks, what it works on, the rest.
struct Instruction {
  std::string before, word, gap, operand, rest;
  std::string text() const { return before + word + gap + operand + rest; }
};

std::string Take(std::string_view& line, bool (*accepts)(char)) {
  size_t length = 0;
  while (length < line.size() && accepts(line[length])) ++length;
  std::string taken(line.substr(0, length));
  line.remove_prefix(length);
  return taken;
}

bool IsBlank(char c) { return c == ' ' || c == '\t'; }
bool IsNotBlank(char c) { return !IsBlank(c) && c != '\r' && c != ';'; }

Instruction Cut(std::string_view line) {
  Instruction cut;
  cut.before = Take(line, IsBlank);
  cut.word = Take(line, IsNotBlank);
  cut.gap = Take(line, IsBlank);
  cut.operand = Take(line, IsNotBlank);
  // "I 1.0"
  if (cut.word.starts_with(":") && cut.operand.size() == 1 && !line.empty() && IsBlank(line.front())) {
    cut.operand += Take(line, IsBlank);
    cut.operand += Take(line, IsNotBlank);
  }
  cut.rest = std::string(line);
  return cut;
}

/// Words that one after the other may be executed in any order: the same operation on bits.
bool Commute(const std::string& dialect, const std::string& one, const std::string& other) {
  const auto group = [&](const std::string& word) {
    static const std::map<std::string, std::map<std::string, int>> groups = {
        {"host50", {{"AND", 1}, {"ANI", 1}, {"OR", 2}, {"ORI", 2}}},
        {"technol", {{"LA", 1}, {"LO", 2}}},
        {"prostep", {{":A", 1}, {":AN", 1}, {":O", 2}, {":ON", 2}}}};
    const auto of_dialect = groups.find(dialect);
    if (of_dialect == groups.end()) return 0;
    const auto at = of_dialect->second.find(word);
    return at == of_dialect->second.end() ? 0 : at->second;
  };
  return group(one) != 0 && group(one) == group(other);
}

/// What stands behind `O` may be a comment in prostep, with a mark or without one: an operand is one or two letters and
/// a number.
bool HasOperand(const std::string& dialect, const Instruction& instruction) {
  const std::string& operand = instruction.operand;
  if (dialect != "prostep") return !operand.empty();
  size_t letters = 0;
  while (letters < operand.size() && std::isalpha(static_cast<unsigned char>(operand[letters])) != 0) ++letters;
  size_t digit = letters;
  while (digit < operand.size() && IsBlank(operand[digit])) ++digit;
  return letters >= 1 && letters <= 2 && digit < operand.size() &&
         std::isdigit(static_cast<unsigned char>(operand[digit])) != 0;
}

/// "P 2.0" of prostep asks the port itself: the control sees the order.
bool AsksPort(const std::string& dialect, const Instruction& instruction) {
  return dialect == "prostep" && instruction.operand.starts_with('P');
}

/// Two neighbours that work on the same accumulator and commute.
bool SwapOperations(ProgramText& program, Random& random, std::string& what) {
  std::string& text = program.files[program.sources[Below(random, program.sources.size())]];
  std::vector<std::string> lines = LinesOf(text);
  std::vector<size_t> places;
  for (size_t i = 0; i + 1 < lines.size(); ++i) {
    const Instruction one = Cut(lines[i]), other = Cut(lines[i + 1]);
    if (!HasOperand(program.dialect, one) || !HasOperand(program.dialect, other)) continue;
    if (!Commute(program.dialect, one.word, other.word)) continue;
    if (AsksPort(program.dialect, one) && AsksPort(program.dialect, other)) continue;
    // A label belongs to its place.
    if (one.text() != other.text()) places.push_back(i);
  }
  if (places.empty()) return false;
  const size_t at = places[Below(random, places.size())];
  what = "lines " + std::to_string(at + 1) + " and the next one are swapped";
  std::swap(lines[at], lines[at + 1]);
  text = TextOf(lines);
  return true;
}

/// `LD a`, `AND b` is `LD b`, `AND a`.
bool SwapLoaded(ProgramText& program, Random& random, std::string& what) {
  static const std::map<std::string, std::map<std::string, std::string>> kLoads = {
      {"host50", {{"AND", "LD"}, {"OR", "LD"}, {"ANI", "LDI"}, {"ORI", "LDI"}}},
      {"technol", {{"LA", "LDR"}, {"LO", "LDR"}}}};
  const auto loads = kLoads.find(program.dialect);
  if (loads == kLoads.end()) return false;
  std::string& text = program.files[program.sources[Below(random, program.sources.size())]];
  std::vector<std::string> lines = LinesOf(text);
  std::vector<size_t> places;
  for (size_t i = 0; i + 1 < lines.size(); ++i) {
    const Instruction one = Cut(lines[i]), other = Cut(lines[i + 1]);
    const auto load = loads->second.find(other.word);
    const bool fits = load != loads->second.end() && load->second == one.word;
    if (fits && !one.operand.empty() && !other.operand.empty() && one.operand != other.operand) places.push_back(i);
  }
  if (places.empty()) return false;
  const size_t at = places[Below(random, places.size())];
  Instruction one = Cut(lines[at]), other = Cut(lines[at + 1]);
  std::swap(one.operand, other.operand);
  lines[at] = one.text();
  lines[at + 1] = other.text();
  what = "operands of line " + std::to_string(at + 1) + " and the next one are swapped";
  text = TextOf(lines);
  return true;
}

/// The operands of a sum or product of nc110 between the signs of one kind, from `begin` to `end`.
struct Chain {
  size_t begin = 0, end = 0;
  std::vector<std::string> operands;
  char sign = '*';
};

/// `X = a*b*c`: what stands behind `=`, when it is one chain of names alone.
std::optional<Chain> ChainOf(const std::string& line) {
  const size_t equals = line.find('=');
  if (equals == std::string::npos || line.find_first_of("\"(:[") < line.size()) return std::nullopt;
  Chain chain{.begin = equals + 1, .operands = {}};
  chain.end = std::min(line.find(';'), line.size());
  if (chain.begin >= chain.end) return std::nullopt;
  std::string text = line.substr(chain.begin, chain.end - chain.begin);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  const size_t sign = text.find_first_of("*+");
  if (sign == std::string::npos) return std::nullopt;
  chain.sign = text[sign];
  std::string operand;
  for (const char c : text) {
    if (c == chain.sign) {
      chain.operands.push_back(std::exchange(operand, {}));
    } else if ((std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '/' || c == '!' || c == '_') {
      operand += c;
    } else {
      return std::nullopt;
    }
  }
  chain.operands.push_back(operand);
  // Names of bits alone: "I0A3", not numbers and words.
  const bool are_bits = std::ranges::all_of(chain.operands, [](const std::string& name) {
    const size_t first = name.find_first_not_of("/!");
    return first != std::string::npos && std::string_view("IU").find(name[first]) != std::string_view::npos &&
           name.size() < 8;
  });
  return are_bits ? std::optional(chain) : std::nullopt;
}

bool RewriteChain(ProgramText& program, Random& random, std::string& what) {
  if (program.dialect != "nc110") return false;
  std::string& text = program.files[program.sources[Below(random, program.sources.size())]];
  std::vector<std::string> lines = LinesOf(text);
  std::vector<size_t> places;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (ChainOf(lines[i])) places.push_back(i);
  }
  if (places.empty()) return false;
  const size_t at = places[Below(random, places.size())];
  Chain chain = *ChainOf(lines[at]);
  const auto joined = [](const std::vector<std::string>& operands, char sign) {
    std::string all;
    for (const std::string& operand : operands) all += (all.empty() ? "" : std::string(1, sign)) + operand;
    return all;
  };
  const auto inverted = [](const std::string& operand) {
    return operand.starts_with("/") ? operand.substr(1) : "/" + operand;
  };
  std::string written;
  switch (Below(random, 4)) {
    case 0:
      std::swap(chain.operands.front(), chain.operands.back());
      written = joined(chain.operands, chain.sign);
      break;
    case 1:
      written = "/(/(" + joined(chain.operands, chain.sign) + "))";
      break;
    case 2:
      for (std::string& operand : chain.operands) operand = inverted(operand);
      written = "/(" + joined(chain.operands, chain.sign == '*' ? '+' : '*') + ")";
      break;
    default:
      // a = a*a
      chain.operands.push_back(chain.operands[Below(random, chain.operands.size())]);
      written = joined(chain.operands, chain.sign);
      break;
  }
  what = "line " + std::to_string(at + 1) + " is written as " + written;
  lines[at] = lines[at].substr(0, chain.begin) + written + lines[at].substr(chain.end);
  text = TextOf(lines);
  return true;
}

bool AddComment(ProgramText& program, Random& random, std::string& what) {
  std::string& text = program.files[program.sources[Below(random, program.sources.size())]];
  std::vector<std::string> lines = LinesOf(text);
  // Not in front of the first line, which may have a meaning.
  const size_t at = 1 + Below(random, lines.size());
  // A string or a list may go on in the next line.
  if (at > 1 && lines[at - 1].find_first_of("\"'") != std::string::npos) return false;
  what = "a comment behind line " + std::to_string(at);
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(std::min(at, lines.size())), "; another comment");
  text = TextOf(lines);
  return true;
}

bool IsOfName(char c) { return (std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '_'; }

/// technol's specification, 5.1: a DFM of such a name names bits of the control's byte; of another name it is memory.
bool NamesTheControl(std::string_view name) {
  const bool is_number = name.find_first_not_of("0123456789", name.starts_with("IN") ? 2 : 3) == std::string_view::npos;
  if (is_number && (name.starts_with("IN") || name.starts_with("OUT"))) return true;
  return std::ranges::any_of(technol::Signals(), [name](const technol::Signal& signal) { return signal.name == name; });
}

/// A label or symbol that begins a line, or stands behind a sign of declaration, is renamed everywhere.
bool Rename(Pair& pair, Random& random, std::string& what) {
  ProgramText& program = pair.new_program;
  std::vector<std::string> names;
  for (const std::string& source : program.sources) {
    for (const std::string& line : LinesOf(program.files[source])) {
      // nc110: !NAME = I0A3; technol, host50: LABEL:
      const size_t colon = line.find(':');
      const bool is_label = colon != std::string::npos && colon > 1 &&
                            std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(colon), IsOfName);
      if (is_label && program.dialect == "technol" && !NamesTheControl(line.substr(0, colon)))
        names.push_back(line.substr(0, colon));
      if (line.starts_with("!") && program.dialect == "nc110") {
        size_t end = 1;
        while (end < line.size() && IsOfName(line[end])) ++end;
        if (end > 1) names.push_back(line.substr(1, end - 1));
      }
    }
  }
  if (names.empty()) return false;
  const std::string name = names[Below(random, names.size())], other = name.substr(0, 3) + "QX";
  for (const std::string& source : program.sources) {
    std::string& text = program.files[source];
    if (text.find(other) != std::string::npos) return false;
    std::string renamed;
    for (size_t i = 0; i < text.size();) {
      if (!IsOfName(text[i])) {
        renamed += text[i++];
        continue;
      }
      size_t end = i;
      while (end < text.size() && IsOfName(text[end])) ++end;
      const std::string word = text.substr(i, end - i);
      renamed += word == name ? other : word;
      i = end;
    }
    text = renamed;
  }
  what = name + " is renamed " + other;
  pair.renames = true;
  return true;
}

/// A variable that nobody reads, declared last of all data, so that nothing else moves: the cells of one file follow
/// those of the file before it. But an index reaches it, too.
bool AddUnused(ProgramText& program, Random&, std::string& what) {
  if (program.dialect != "technol") return false;
  for (const std::string& source : program.sources) {
    if (program.files[source].find('[') != std::string::npos) return false;
  }
  for (auto source = program.sources.rbegin(); source != program.sources.rend(); ++source) {
    std::vector<std::string> lines = LinesOf(program.files[*source]);
    for (size_t i = lines.size(); i-- > 0;) {
      if (Cut(lines[i]).word != "DATA_END") continue;
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(i), "NEWBITQ: DFM UNUSEDQ");
      program.files[*source] = TextOf(lines);
      what = "an unused bit";
      return true;
    }
  }
  return false;
}

}  // namespace

Pair Rewritten(const ProgramText& program, Random& random) {
  Pair pair{.old_program = program, .new_program = program, .what = {}, .alike = true};
  for (int tries = 0; tries < 12; ++tries) {
    const uint32_t which = Below(random, 8);
    std::string what;
    const bool done = which < 2   ? SwapOperations(pair.new_program, random, what)
                      : which < 3 ? SwapLoaded(pair.new_program, random, what)
                      : which < 5 ? RewriteChain(pair.new_program, random, what)
                      : which < 6 ? AddComment(pair.new_program, random, what)
                      : which < 7 ? Rename(pair, random, what)
                                  : AddUnused(pair.new_program, random, what);
    if (!done) continue;
    pair.what += (pair.what.empty() ? "" : "; ") + what;
    if (!random.OneIn(2)) return pair;
  }
  return pair;
}

}  // namespace plcxx::pairs
