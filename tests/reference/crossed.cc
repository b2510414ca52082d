#include "tests/reference/crossed.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::reference {
namespace {

constexpr std::string_view kEdges[] = {"0",  "1",  "2",   "7",   "8",   "9",   "15",    "16",    "31",   "32",
                                       "63", "64", "127", "128", "255", "256", "32767", "32768", "65535"};

bool IsLetterOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '%' || c == '!' || c == '$';
}

struct Word {
  size_t begin, size;
};

/// Words and signs, without the blanks between.
std::vector<Word> WordsOf(std::string_view line) {
  std::vector<Word> words;
  for (size_t at = 0; at < line.size();) {
    const size_t begin = at;
    while (at < line.size() && IsLetterOfWord(line[at])) ++at;
    if (at == begin) ++at;
    if (std::isspace(static_cast<unsigned char>(line[begin])) == 0) words.push_back({begin, at - begin});
  }
  return words;
}

/// What a word looks like: `U9A9` of U4A12, `9` of a number, `w` of a word of letters, a sign itself.
std::string ShapeOf(std::string_view word) {
  if (!IsLetterOfWord(word.front())) return std::string(word);
  if (std::ranges::none_of(word, [](unsigned char c) { return std::isdigit(c) != 0; })) return "w";
  std::string shape;
  for (const char c : word) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) {
      shape += c;
    } else if (!shape.ends_with('9')) {
      shape += '9';
    }
  }
  return shape;
}

std::string NeighboursOf(std::string_view line, const std::vector<Word>& words, size_t at) {
  const auto shape = [&](size_t of) { return ShapeOf(line.substr(words[of].begin, words[of].size)); };
  const bool is_word = IsLetterOfWord(line[words[at].begin]);
  return (at > 0 ? shape(at - 1) : "begin") + (is_word ? " w " : " s ") +
         (at + 1 < words.size() ? shape(at + 1) : "end");
}

std::vector<Piece> LinesOf(const std::string& text) {
  std::vector<Piece> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back({line, {}, ""});
  return lines;
}

std::optional<std::string> TextAt(const std::string& path) {
  std::error_code too_long;  // is no file's name
  if (!std::filesystem::is_regular_file(path, too_long)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

bool IsPlainName(std::string_view name) {
  return !name.empty() &&
         std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_'; });
}

std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string Mapping(const std::vector<scenarios::Assignment>& assignments) {
  std::string text;
  for (const scenarios::Assignment& one : assignments) {
    text += (text.empty() ? "{" : ", ") + Quoted(one.location.text) + ": " + Quoted(one.value.text);
  }
  return text + "}";
}

std::string_view NameOf(scenarios::RunUnit unit) {
  switch (unit) {
    case scenarios::RunUnit::kSlowCycles:
      return "slow";
    case scenarios::RunUnit::kFastTicks:
      return "fast";
    case scenarios::RunUnit::kMilliseconds:
      return "ms";
  }
  return {};
}

/// What was expected of the golden program is not expected of a changed one.
std::string StepOf(const scenarios::StepAction& action) {
  const auto text = [](const auto& step) -> std::string {
    using Step = std::decay_t<decltype(step)>;
    if constexpr (std::is_same_v<Step, scenarios::SetStep>) return "set: " + Mapping(step.assignments);
    if constexpr (std::is_same_v<Step, scenarios::ForceStep>) return "force: " + Mapping(step.assignments);
    if constexpr (std::is_same_v<Step, scenarios::PowerCycleStep>) return "power_cycle: {}";
    if constexpr (std::is_same_v<Step, scenarios::RunStep>) {
      std::string parts;
      for (const scenarios::RunPart& part : step.parts) {
        parts += (parts.empty() ? "run: {" : ", ") + std::string(NameOf(part.unit)) + ": " + std::to_string(part.count);
      }
      return parts + "}";
    }
    if constexpr (std::is_same_v<Step, scenarios::ReleaseStep>) {
      std::string names;
      for (const auto& location : step.locations)
        names += (names.empty() ? "release: [" : ", ") + Quoted(location.text);
      return names + "]";
    }
    return {};
  };
  return std::visit(text, action);
}

/// None: it has errors, no steps, or files that are not beside it.
std::optional<RandomProgram> ProgramOf(const std::string& path) {
  const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path);
  const auto* const scenario = std::get_if<scenarios::Scenario>(&read);
  if (scenario == nullptr || !scenario->steps || scenario->expect_error || scenario->program) return std::nullopt;
  RandomProgram program;
  program.options = scenario->options;
  std::string words;  // where names of other files may be
  const auto add = [&](const std::string& name, const std::string& text, bool is_source) {
    const bool known = std::ranges::any_of(program.files, [&](const RandomFile& file) { return file.name == name; });
    if (!known) program.files.push_back({.name = name, .pieces = LinesOf(text), .is_source = is_source});
    words += text + "\n";
  };
  for (const std::string& source : scenario->sources) {
    const auto inside = scenario->texts.find(source);
    const std::string name = source.substr(source.rfind('/') + 1);
    const auto text =
        inside != scenario->texts.end() ? std::optional(inside->second) : TextAt(scenario->directory + "/" + source);
    if (!text || !IsPlainName(name) || (inside == scenario->texts.end() && name != source)) return std::nullopt;
    add(name, *text, true);
  }
  for (const auto& [key, value] : program.options) words += value + "\n";
  for (size_t at = 0; at < words.size();) {
    size_t end = at;
    while (end < words.size() && IsPlainName(words.substr(end, 1))) ++end;
    const std::string name = words.substr(at, end - at);
    at = std::max(end, at + 1);
    if (name.find('.') == std::string::npos && name.size() < 3) continue;
    if (const auto text = name.empty() ? std::nullopt : TextAt(scenario->directory + "/" + name))
      add(name, *text, false);
  }
  for (const scenarios::ScenarioStep& step : *scenario->steps) {
    if (std::string text = StepOf(step.action); !text.empty()) program.steps.push_back(std::move(text));
  }
  if (program.steps.empty()) return std::nullopt;
  return program;
}

}  // namespace

Goldens::Goldens(std::string_view dialect) {
  const std::string root = std::string(PLCXX_ROOT) + "/tests/golden/" + std::string(dialect);
  const auto found = scenarios::FindScenarios({root});
  for (const std::string& path : std::get<std::vector<std::string>>(found)) {
    std::optional<RandomProgram> program = ProgramOf(path);
    if (!program) continue;
    Learn(*program);
    programs_.push_back(std::move(*program));
  }
}

void Goldens::Learn(const RandomProgram& program) {
  for (const RandomFile& file : program.files) {
    if (!file.is_source) continue;
    for (const Piece& piece : file.pieces) {
      const std::vector<Word> words = WordsOf(piece.text);
      for (size_t at = 0; at < words.size(); ++at) {
        const std::string word = piece.text.substr(words[at].begin, words[at].size);
        by_neighbours_[NeighboursOf(piece.text, words, at)].push_back(word);
        by_shape_[ShapeOf(word)].push_back(word);
      }
    }
  }
}

/// A word of the line is another one: of the same shape, or one that appears between such neighbours.
void Goldens::ChangeLine(std::string& line, Random& random) const {
  const std::vector<Word> words = WordsOf(line);
  if (words.empty()) return;
  const size_t at = random.Below(static_cast<uint32_t>(words.size()));
  const std::string word = line.substr(words[at].begin, words[at].size);
  const std::string shape = ShapeOf(word);
  std::string other;
  if (shape == "9" && random.OneIn(2)) {
    other = kEdges[random.Below(std::size(kEdges))];
  } else if (shape.size() > 1 && random.OneIn(4)) {  // the last number of an operand
    const size_t digits = word.find_last_not_of("0123456789") + 1;
    other = word.substr(0, digits) + std::string(kEdges[random.Below(std::size(kEdges))]);
  } else {
    const Words& pool = random.OneIn(3) ? by_shape_ : by_neighbours_;
    const auto known = pool.find(&pool == &by_shape_ ? shape : NeighboursOf(line, words, at));
    if (known == pool.end()) return;
    other = random.Pick(known->second);
  }
  line.replace(words[at].begin, words[at].size, other);
}

void Goldens::Change(std::vector<Piece>& lines, Random& random) const {
  const auto count = static_cast<uint32_t>(lines.size());
  if (count == 0) return;
  const auto any = [&] { return lines.begin() + random.Below(count); };
  switch (random.Below(10)) {
    case 0:
      return std::iter_swap(any(), any());
    case 1: {
      const Piece line = *any();
      lines.insert(any(), line);
      return;
    }
    case 2:
      lines.erase(any());
      return;
    case 3: {  // a segment is moved
      const auto first = any();
      const auto last = first + random.Below(static_cast<uint32_t>(std::min<ptrdiff_t>(5, lines.end() - first))) + 1;
      const std::vector<Piece> moved(first, last);
      const auto behind = lines.erase(first, last);
      const auto rest = static_cast<uint32_t>(lines.size());
      lines.insert(rest == 0 ? behind : lines.begin() + random.Below(rest), moved.begin(), moved.end());
      return;
    }
    default:
      return ChangeLine(any()->text, random);
  }
}

RandomProgram Goldens::Crossed(Random& random) const {
  RandomProgram program = random.Pick(programs_);
  const auto source = [&](auto& files) -> auto& {
    const auto sources = std::ranges::count_if(files, &RandomFile::is_source);
    auto at = random.Below(static_cast<uint32_t>(sources));
    return *std::ranges::find_if(files, [&](const RandomFile& file) { return file.is_source && at-- == 0; });
  };
  if (random.OneIn(2)) {
    const RandomProgram& other = random.Pick(programs_);
    const std::vector<Piece>& from = source(other.files).pieces;
    std::vector<Piece>& to = source(program.files).pieces;
    if (!from.empty() && !to.empty()) {
      const auto first = from.begin() + random.Below(static_cast<uint32_t>(from.size()));
      const auto most = static_cast<uint32_t>(std::min<ptrdiff_t>(12, from.end() - first));
      to.insert(to.begin() + random.Below(static_cast<uint32_t>(to.size())), first, first + random.Between(1, most));
    }
    if (random.OneIn(3)) program.steps.insert(program.steps.end(), other.steps.begin(), other.steps.end());
  }
  const uint32_t changes = random.Between(1, 4);
  for (uint32_t i = 0; i < changes; ++i) Change(source(program.files).pieces, random);
  if (random.OneIn(2)) program.steps.insert(program.steps.end(), program.steps.begin(), program.steps.end());
  if (random.OneIn(4))
    program.steps.insert(program.steps.begin() + random.Below(static_cast<uint32_t>(program.steps.size())),
                         "power_cycle: {}");
  return program;
}

}  // namespace plcxx::reference
