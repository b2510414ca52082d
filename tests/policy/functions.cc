#include "tests/policy/functions.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "tests/policy/tokens.h"

namespace plcxx::policy {
namespace {

enum class Brace : uint8_t { kNamespace, kType, kFunction, kOther };

struct Function {
  std::string name;
  std::span<const Token> tokens;  // from its head to its last brace
};

bool Has(std::span<const Token> tokens, const std::string& text) {
  return std::ranges::find(tokens, text, &Token::text) != tokens.end();
}

/// What the brace after a head opens, outside of functions.
Brace BraceAfter(std::span<const Token> head) {
  if (head.empty() || head.back().text == "=") return Brace::kOther;
  if (head.front().text == "namespace" || (head.size() > 1 && head[1].text == "namespace")) return Brace::kNamespace;
  if (head.size() == 1 && head.front().text == "extern") return Brace::kNamespace;  // the "C" is a literal
  const bool is_call = Has(head, "(");
  for (const char* word : {"class", "struct", "union", "enum"}) {
    if (Has(head, word) && (!is_call || head.back().text != ")")) return Brace::kType;
  }
  return is_call ? Brace::kFunction : Brace::kOther;
}

/// "DirectedSearch::Run" of the head of a function.
std::string NameOf(std::span<const Token> head) {
  const auto open = std::ranges::find(head, "(", &Token::text);
  auto begin = open;
  while (begin != head.begin()) {
    const std::string& text = (begin - 1)->text;
    const bool joins = begin == open || begin->text == "::" || text == "::" || text == "~";
    if (!joins || (!IsWord(text.back()) && text != "::" && text != "~")) break;
    --begin;
  }
  std::string name;
  for (auto at = begin; at != open; ++at) name += at->text;
  return name;
}

std::vector<Function> FunctionsOf(std::span<const Token> tokens) {
  std::vector<Function> functions;
  std::vector<Brace> braces;
  size_t head = 0, open_parentheses = 0;
  for (size_t at = 0; at < tokens.size(); ++at) {
    const std::string& text = tokens[at].text;
    const bool is_inside = !braces.empty() && (braces.back() == Brace::kFunction || braces.back() == Brace::kOther);
    if (text == "(") ++open_parentheses;
    if (text == ")" && open_parentheses > 0) --open_parentheses;
    if (text == "{") {
      const bool is_outside = !is_inside && open_parentheses == 0;
      braces.push_back(is_outside ? BraceAfter(tokens.subspan(head, at - head)) : Brace::kOther);
      if (braces.back() == Brace::kFunction) {
        functions.push_back({.name = NameOf(tokens.subspan(head, at - head)), .tokens = tokens.subspan(head)});
      } else if (braces.back() != Brace::kOther) {
        head = at + 1;
      }
    } else if (text == "}" && !braces.empty()) {
      if (braces.back() == Brace::kFunction) functions.back().tokens = functions.back().tokens.first(at + 1 - head);
      if (braces.back() != Brace::kOther) head = at + 1;
      braces.pop_back();
    } else if (!is_inside && open_parentheses == 0) {
      const bool is_label = text == ":" && at == head + 1 && !braces.empty() && braces.back() == Brace::kType;
      if (text == ";" || is_label) head = at + 1;
    }
  }
  return functions;
}

size_t LinesOf(const Function& function) {
  std::map<size_t, std::string> first_words;  // by line
  for (const Token& token : function.tokens) first_words.try_emplace(token.line, token.text);
  return static_cast<size_t>(std::ranges::count_if(
      first_words, [](const auto& line) { return line.second != "case" && line.second != "break"; }));
}

}  // namespace

Findings CheckFunctions(const std::string& root) {
  Findings findings;
  size_t found = 0;
  for (const char* folder : {"transpiler", "runtime_support"}) {
    for (const std::string& file : FilesBelow(root, folder, {".cc", ".h"})) {
      const std::vector<Token> tokens = TokensOf(ReadFile(root + "/" + file));
      for (const Function& function : FunctionsOf(tokens)) {
        ++found;
        const size_t lines = LinesOf(function);
        if (lines <= kMaxFunctionLines) continue;
        findings.push_back(Place(file, function.tokens.front().line) + "'" + function.name + "' has " +
                           std::to_string(lines) + " lines, of at most " + std::to_string(kMaxFunctionLines));
      }
    }
  }
  if (found == 0) findings.push_back("there are no functions");
  return findings;
}

}  // namespace plcxx::policy
