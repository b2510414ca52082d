#include "tests/diff/source_edits.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::review::diff {
namespace {

using terms::Random;

/// One line, cut into words, numbers, blanks and single signs.
std::vector<std::string> Tokens(const std::string& line) {
  const auto kind = [](char c) {
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || (c >= '0' && c <= '9');
    return letter ? 1 : c == ' ' || c == '\t' ? 2 : 3;
  };
  std::vector<std::string> tokens;
  for (const char c : line) {
    if (!tokens.empty() && kind(c) != 3 && kind(tokens.back().back()) == kind(c)) {
      tokens.back() += c;
    } else {
      tokens.emplace_back(1, c);
    }
  }
  return tokens;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsWord(const std::string& token) {
  const char c = token.front();
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

std::string Joined(const std::vector<std::string>& tokens) {
  std::string line;
  for (const std::string& token : tokens) line += token;
  return line;
}

/// "I10A3" and "I0A12" have one shape.
std::string ShapeOf(const std::string& token) {
  std::string shape;
  for (const char c : token) {
    const char sign = IsDigit(c) ? '0' : c == '_' ? '_' : 'a';
    if (shape.empty() || shape.back() != sign || sign == 'a') shape += sign;
  }
  return shape.size() > 6 ? shape.substr(0, 2) : shape;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

std::string TextOf(const std::vector<std::string>& lines) {
  std::string text;
  for (size_t i = 0; i < lines.size(); ++i) text += (i == 0 ? "" : "\n") + lines[i];
  return text;
}

/// What is easily written for another one. Signs of several characters are edited sign by sign.
constexpr std::array<std::pair<std::string_view, std::string_view>, 35> kSlips = {{
    {"*", "+"},    {"+", "*"},     {"+", "-"},     {"-", "+"},     {"<", ">"},      {">", "<"},      {"&", "|"},
    {"|", "&"},    {"=", ">"},     {"AND", "OR"},  {"OR", "AND"},  {"A", "O"},      {"O", "A"},      {"AN", "ON"},
    {"LD", "LDI"}, {"S", "R"},     {"R", "S"},     {"SET", "RST"}, {"LDR", "LA"},   {"LO", "LA"},    {"TONS", "TOFS"},
    {"EQ", "GT"},  {"LDP", "LD"},  {"LD", "LDP"},  {"LDF", "LD"},  {"AND", "ANDP"}, {"ANDP", "AND"}, {"FL", "FL1"},
    {"FL1", "FL"}, {"JL0", "JL1"}, {"JL1", "JL0"}, {"EX0", "EX1"}, {"EX1", "EX0"},  {"TIM", "TEX1"}, {"LE", "LT"},
}};

/// One token of the line instead of another; empty: this line has none.
std::string EditLine(const std::string& line, const std::vector<std::string>& words, Random& random) {
  std::vector<std::string> tokens = Tokens(line);
  std::vector<size_t> candidates;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].front() != ' ' && tokens[i].front() != '\t' && tokens[i].front() != '\r') candidates.push_back(i);
  }
  if (candidates.empty()) return {};
  const size_t at = candidates[random.Next() % candidates.size()];
  std::string& token = tokens[at];
  const std::string before = token;
  std::vector<std::string> others;
  if (IsDigit(token.front()) && token.size() < 6) {
    const int value = std::atoi(token.c_str());
    others = {std::to_string(value + 1), std::to_string(value > 0 ? value - 1 : 3), std::to_string(value / 2),
              std::to_string(value + 8)};
  } else if (IsWord(token)) {
    for (const std::string& word : words) {
      if (word != token && ShapeOf(word) == ShapeOf(token)) others.push_back(word);
    }
    if (token.size() < 4) others.push_back(token + "N");
    if (token.size() > 1 && (token.back() == 'N' || token.back() == 'I'))
      others.push_back(token.substr(0, token.size() - 1));
  } else if (token == "/" || token == "!") {
    others = {""};
  }
  for (const auto& [one, other] : kSlips) {
    if (one == token) others.emplace_back(other);
  }
  // A negation comes in front of an operand.
  if (IsWord(token) || token == "(") {
    others.push_back("/" + token);
    others.push_back("!" + token);
  }
  if (others.empty()) return {};
  token = others[random.Next() % others.size()];
  return token == before ? std::string() : Joined(tokens);
}

}  // namespace

SourceEdit EditedSource(const std::map<std::string, std::string>& files, Random& random) {
  std::vector<std::string> names;
  for (const auto& [name, text] : files) names.push_back(name);
  const std::string& name = names[random.Next() % names.size()];
  std::vector<std::string> lines = LinesOf(files.at(name)), words;
  for (const std::string& line : lines) {
    for (const std::string& token : Tokens(line)) {
      if (IsWord(token)) words.push_back(token);
    }
  }
  for (int tries = 0; tries < 20; ++tries) {
    const size_t at = random.Next() % lines.size();
    if (lines[at].find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string place = "line " + std::to_string(at + 1) + ": ";
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.Next() % 8) {
      case 0:
        if (!random.OneIn(2)) break;
        {
          std::string gone = lines[at];
          lines.erase(begin);
          return {.file = name, .text = TextOf(lines), .what = place + "'" + gone + "' is gone"};
        }
      case 1: {
        const size_t to = at + 1 + random.Next() % 3;
        if (to >= lines.size()) break;
        std::string moved = lines[at];
        lines.erase(begin);
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to), moved);
        return {.file = name,
                .text = TextOf(lines),
                .what = place + "'" + moved + "' moved to line " + std::to_string(to + 1)};
      }
      default: {
        std::string edited = EditLine(lines[at], words, random);
        if (edited.empty() || edited == lines[at]) break;
        std::string what = place + "'" + edited + "' instead of '" + lines[at] + "'";
        lines[at] = std::move(edited);
        return {.file = name, .text = TextOf(lines), .what = std::move(what)};
      }
    }
  }
  return {};
}

}  // namespace plcxx::review::diff
