#include "tests/printed/edits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <span>
#include <vector>

namespace plcxx::printed {
namespace {

struct Word {
  size_t begin, end;
};

bool IsPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// What begins at a place and is no word: a comment, a text, the line of a directive. Empty: nothing of the kind.
size_t SkippedAt(std::string_view text, size_t at, Writing writing) {
  const auto up_to = [&](std::string_view end, size_t from) {
    const size_t found = text.find(end, from);
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  const std::string_view rest = text.substr(at);
  if (writing == Writing::kLines) return rest.starts_with(';') ? up_to("\n", at) : at;
  if (rest.starts_with("//") || rest.starts_with('#')) return up_to("\n", at);
  if (rest.starts_with("/*")) return up_to("*/", at + 2);
  if (rest.starts_with('"')) return up_to("\"", at + 1);
  return at;
}

std::vector<Word> WordsOf(std::string_view text, Writing writing) {
  constexpr std::array<std::string_view, 20> kLong = {"<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||",
                                                      "+=",  "-=",  "*=", "/=", "|=", "&=", "^=", "++", "--", "->"};
  std::vector<Word> words;
  for (size_t at = 0; at < text.size();) {
    if (const size_t behind = SkippedAt(text, at, writing); behind != at) {
      at = behind;
      continue;
    }
    size_t end = at + 1;
    if (IsPart(text[at])) {
      while (end < text.size() && IsPart(text[end])) ++end;
    } else if (writing == Writing::kC) {
      for (const std::string_view word : kLong) {
        if (!text.substr(at).starts_with(word)) continue;
        end = at + word.size();
        break;
      }
    }
    if (std::isspace(static_cast<unsigned char>(text[at])) == 0) words.push_back({at, end});
    at = end;
  }
  return words;
}

/// Words that stand for one another.
using Alike = std::initializer_list<std::string_view>;
constexpr std::initializer_list<Alike> kAlike = {
    {"<", "<=", ">", ">=", "==", "!="},
    {"+", "-", "*", "/", "%", "&", "|", "^", "<<", ">>"},
    {"=", "+=", "-=", "*=", "|=", "&=", "^=", "<<=", ">>="},
    {"&&", "||"},
    {"++", "--"},
    {"if", "while"},
    {"int", "unsigned", "long", "char", "float", "double", "short"},
    {"break", "continue", "return"},
    {"->", "."},
};

std::string NeighbourOf(std::string_view number, uint64_t choice) {
  const bool decimal =
      number.size() < 9 && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!decimal) return choice % 2 == 0 ? "0" : "1";
  const auto value = static_cast<uint32_t>(std::stoul(std::string(number)));
  const std::array<uint32_t, 6> others = {value + 1, value == 0 ? 2 : value - 1, 0, value * 2, 255, 32768};
  return std::to_string(others[choice % others.size()]);
}

/// Another word of the text that begins with a letter.
std::string OtherName(std::string_view text, const std::vector<Word>& words, std::string_view name, uint64_t choice) {
  std::vector<std::string_view> names;
  for (const Word& word : words) {
    const std::string_view other = text.substr(word.begin, word.end - word.begin);
    if (std::isalpha(static_cast<unsigned char>(other.front())) != 0 && other != name) names.push_back(other);
  }
  return names.empty() ? std::string() : std::string(names[choice % names.size()]);
}

/// From the word to the end of its statement.
size_t EndOfStatement(std::string_view text, size_t at, Writing writing) {
  const size_t end = text.find(writing == Writing::kC ? ';' : '\n', at);
  return end == std::string_view::npos ? text.size() : end;
}

}  // namespace

Edit EditOf(std::string_view text, Writing writing, uint64_t number) {
  // splitmix64: each call gives another number.
  const auto next = [&number] {
    number += 0x9E3779B97F4A7C15;
    uint64_t mixed = (number ^ number >> 30) * 0xBF58476D1CE4E5B9;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB;
    return mixed ^ mixed >> 31;
  };
  const std::vector<Word> words = WordsOf(text, writing);
  if (words.empty()) return {};
  const Word chosen = words[next() % words.size()];
  const std::string_view word = text.substr(chosen.begin, chosen.end - chosen.begin);
  Edit edit{chosen.begin, chosen.end, {}};
  const uint64_t kind = next() % 8, choice = next();
  if (kind == 0) {
    edit.end = std::max(chosen.end, EndOfStatement(text, chosen.begin, writing));
    return edit;
  }
  if (std::isdigit(static_cast<unsigned char>(word.front())) != 0) {
    edit.with = NeighbourOf(word, choice);
    return edit;
  }
  for (const Alike& row : kAlike) {
    const auto* const found = std::ranges::find(row, word);
    if (found == row.end()) continue;
    const size_t other = static_cast<size_t>(found - row.begin()) + 1 + choice % (row.size() - 1);
    edit.with = row.begin()[other % row.size()];
    return edit;
  }
  if (IsPart(word.front())) edit.with = OtherName(text, words, word, choice);
  return edit;
}

std::string Edited(std::string_view text, const Edit& edit) {
  return std::string(text.substr(0, edit.begin)) + edit.with + std::string(text.substr(edit.end));
}

std::string Described(std::string_view text, const Edit& edit) {
  const auto line = 1 + std::ranges::count(text.substr(0, edit.begin), '\n');
  return std::to_string(line) + ": '" + std::string(text.substr(edit.begin, edit.end - edit.begin)) + "' -> '" +
         edit.with + '\'';
}

}  // namespace plcxx::printed
