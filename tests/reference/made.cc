#include "tests/reference/made.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "tests/reference/made_forms.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::reference {
namespace {

std::string Upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string Contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool IsWord(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

/// Everything in quotes that is not in a comment.
std::set<std::string> Terminals(const std::string& grammar) {
  std::set<std::string> terminals;
  for (size_t i = 0; i < grammar.size(); ++i) {
    if (grammar.compare(i, 2, "(*") == 0) {
      i = grammar.find("*)", i) + 1;
    } else if (grammar[i] == '?') {
      i = grammar.find('?', i + 1);
    } else if (grammar[i] == '"' || grammar[i] == '\'') {
      const size_t end = grammar.find(grammar[i], i + 1);
      terminals.insert(Upper(grammar.substr(i + 1, end - i - 1)));
      i = end;
    }
    if (i >= grammar.size()) break;
  }
  terminals.erase(" ");
  terminals.erase("  ");
  return terminals;
}

/// Words as they stand, and the letters of words with numbers: T5I is also T and I.
void CountWords(const std::string& text, std::map<std::string, uint64_t>& words) {
  const auto each = [&](auto&& is_part, auto&& is_counted) {
    for (size_t i = 0; i < text.size();) {
      size_t end = i;
      while (end < text.size() && is_part(text[end])) ++end;
      if (end == i) {
        ++i;
        continue;
      }
      const std::string word = text.substr(i, end - i);
      if (is_counted(word)) ++words[word];
      i = end;
    }
  };
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  each([&](char c) { return is_letter(c) || is_digit(c); }, [](const std::string&) { return true; });
  each(is_letter, [&](const std::string&) { return true; });
}

/// "on or off", "scan, input or next": the values; others are not counted one by one.
std::vector<std::string> ValuesOf(std::string_view text) {
  std::vector<std::string> values;
  std::string words(text);
  for (size_t at = words.find(" or "); at != std::string::npos; at = words.find(" or ")) words.replace(at, 4, ",");
  std::istringstream parts(words);
  for (std::string part; std::getline(parts, part, ',');) {
    std::erase(part, ' ');
    if (part.empty() || !std::isalpha(static_cast<unsigned char>(part[0]))) return {};
    values.push_back(part);
  }
  const bool is_choice =
      values.size() > 1 && text.find("..") == std::string_view::npos && text.find(" in ") == std::string_view::npos;
  return is_choice ? values : std::vector<std::string>();
}

/// As the dialect's own front end reads it; the plain spelling has no included files.
std::string SyntaxOf(const RandomProgram& program, const dialects::Dialect& dialect) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Request request;
  request.sources = &sources;
  request.options = program.options;
  request.diagnostics = &diagnostics;
  std::vector<RenderedFile> files = Render(program, std::string(dialect.name));
  files.pop_back();  // the scenario
  for (RenderedFile& file : files) request.files.push_back(sources.AddText(file.name, std::move(file.text)));
  return dialect.print_syntax(request);
}

constexpr const char *kSeveralFiles = "several files", *kBeyondAscii = "letters beyond ASCII";

/// Of programs: what is not a word of the grammar.
const std::vector<std::pair<std::string, std::string>>& Forms() {
  static const std::vector<std::pair<std::string, std::string>> kForms = {
      {"line ends CR LF", "\r\n"},
      {"a byte-order mark", "\xEF\xBB\xBF"},
      {"a comment", ";"},
      {"a tab", "\t"},
  };
  return kForms;
}

}  // namespace

std::vector<MadeRow> CountMade(const ReferenceDialect& dialect, uint32_t programs) {
  std::map<std::string, uint64_t> words, options, steps, forms;
  const std::set<std::string> terminals =
      Terminals(Contents(std::string(PLCXX_ROOT) + "/grammars/" + std::string(dialect.name) + ".ebnf"));
  std::map<std::string, uint64_t> signs;
  FormCounts operands;
  for (uint32_t seed = 0; seed < programs; ++seed) {
    Random random(seed);
    const ProgramSize size = seed % 20 == 19 ? ProgramSize::kLarge : ProgramSize::kSmall;
    const RandomProgram program = dialect.generate(random, size, Spelling::kAny);
    uint32_t sources = 0;
    for (const RenderedFile& file : Render(program, std::string(dialect.name))) {
      if (file.name == "scenario.yaml") continue;
      ++sources;
      for (const auto& [name, bytes] : Forms()) forms[name] += file.text.find(bytes) != std::string::npos ? 1 : 0;
      const size_t first = file.text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
      const auto is_beyond = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
      forms[kBeyondAscii] += std::ranges::any_of(file.text.substr(first), is_beyond) ? 1 : 0;
      const std::string text = Upper(file.text);
      CountWords(text, words);
      for (const std::string& terminal : terminals) {
        // One letter of the grammar may be a part of a name.
        if (!IsWord(terminal) || terminal.size() == 1)
          signs[terminal] += text.find(terminal) != std::string::npos ? 1 : 0;
      }
    }
    forms[kSeveralFiles] += sources > 1 ? 1 : 0;
    Random again(seed);
    const RandomProgram plain = dialect.generate(again, size, Spelling::kPlain);
    CountForms(dialect.name, SyntaxOf(plain, *dialects::DialectByName(dialect.name)), operands);
    for (const auto& [key, value] : program.options) {
      ++options[Upper(key)];
      ++options[Upper(key + "=" + value)];
    }
    for (const std::string& step : program.steps) {
      const size_t end = step.starts_with("run") ? step.find(':', step.find(':') + 1) : step.find(':');
      ++steps[step.substr(0, end)];
    }
  }
  std::vector<MadeRow> rows;
  for (const std::string& terminal : terminals) {
    const uint64_t as_word = words[terminal];
    rows.push_back({"word", terminal, IsWord(terminal) && as_word != 0 ? as_word : signs[terminal]});
  }
  for (const std::string& form : FormsOf(dialect.name)) rows.push_back({"operand", form, operands[form]});
  for (const dialects::OptionInfo& option : dialects::DialectByName(dialect.name)->options) {
    const std::string key(option.key);
    rows.push_back({"option", key, options[Upper(key)]});
    for (const std::string& value : ValuesOf(option.values)) {
      const std::string named = key + "=" + value;
      if (!option.default_value.starts_with(value)) rows.push_back({"option", named, options[Upper(named)]});
    }
  }
  for (const char* step : {"run: {slow", "run: {fast", "run: {ms", "set", "force", "release", "power_cycle"}) {
    rows.push_back({"step", step, steps[step]});
  }
  for (const auto& [name, bytes] : Forms()) rows.push_back({"form", name, forms[name]});
  for (const char* name : {kSeveralFiles, kBeyondAscii}) rows.push_back({"form", name, forms[name]});
  return rows;
}

std::vector<NeverMade> ReadNeverMade() {
  std::vector<NeverMade> rows;
  std::ifstream file(std::string(PLCXX_ROOT) + "/tests/reference/never_made.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    NeverMade row;
    std::istringstream words(line);
    words >> row.dialect >> row.group;
    std::string rest;
    std::getline(words, rest);
    const size_t end = rest.find(" -- ");
    row.name = rest.substr(1, end - 1);
    row.reason = end == std::string::npos ? "" : rest.substr(end + 4);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace plcxx::reference
