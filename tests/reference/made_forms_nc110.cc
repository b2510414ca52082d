// "and T.U": an operator or a target above an operand. The rules of section 3 say what may be where.
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "tests/reference/made_forms_tables.h"

namespace plcxx::reference::forms {
namespace {

using Texts = std::vector<std::string>;

Texts operator+(Texts a, const Texts& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// "I0A1" -> "I", "T5U" -> "T.U", "C5W" -> "C.W", "\"OK\"" -> "text", "12" -> "number"
std::string KindOf(const std::string& leaf) {
  if (leaf.starts_with('"')) return "text";
  if (std::isdigit(static_cast<unsigned char>(leaf[0])) != 0) return "number";
  const char last = leaf.back();
  const bool has_field = std::isalpha(static_cast<unsigned char>(last)) != 0;
  if (has_field && (leaf[0] == 'T' || leaf[0] == 'C')) return std::string(1, leaf[0]) + "." + last;
  return leaf.substr(0, 1);
}

}  // namespace

std::set<std::string> OfNc110() {
  const Texts signals = {"I", "U", "T.I", "T.A", "T.U", "T.D", "C.I", "C.R", "C.Z", "C.A", "P"};
  const Texts comparisons = {"less", "equal", "greater"};
  const Texts of_signals = signals + comparisons + Texts{"number", "text", "SGN", "and", "or", "xor", "not"};
  const Texts functions = {"ENC", "DEC", "BCD", "BIN", "HIG", "LOW", "XCH", "ABS"};
  const Texts words = Texts{"W", "C.W", "number"} + functions;
  const Texts arithmetic = words + Texts{"add", "subtract"};
  const Texts of_words = arithmetic + Texts{"and", "or", "xor", "not"};
  std::set<std::string> all;
  const auto add = [&](const std::string& above, const Texts& below) {
    for (const std::string& kind : below) all.insert(above + " " + kind);
  };
  // Of both types; what is below tells which.
  for (const char* operation : {"and", "or", "xor", "not"}) add(operation, of_signals + of_words);
  for (const std::string& comparison : comparisons) add(comparison, words);
  for (const std::string& function : functions) add(function, function == "ABS" ? arithmetic : of_words);
  for (const char* operation : {"SGN", "add", "subtract"}) add(operation, arithmetic);
  for (const char* target : {"U=", "/U=", "T.I=", "/T.I=", "C.I=", "/C.I=", "T.A=", "C.Z=", "C.A=", "P=", "/P="}) {
    add(target, of_signals);
  }
  for (const char* target : {"W=", "C.W="}) add(target, of_words + Texts{"MUX"});
  for (const char* block : {"DOF:", "DOE:", "DOW:"}) add(block, of_signals);
  all.insert("DOE: always");
  for (const char* parameter : {"T.I [number]", "T.I [W]", "C.I [number]", "C.I [W]"}) all.insert(parameter);
  add("MUX word", of_words);
  add("MUX signal", of_signals);
  for (const char* count : {"1", "2", "3", "4", "5", "6", "7", "8"}) all.insert(std::string("MUX of ") + count);
  for (const char* level : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) all.insert(std::string("level ") + level);
  return all;
}

/// "  4:1 assign T5I [30] (or I0A1 U1A1)", "  7:1 DOF level 1: I0A1", "  10:1 DOE level 1 after #0: always"
void CountNc110(const std::string& line, FormCounts& counts) {
  std::vector<std::string> words = Parts(line, ' ');
  if (words.size() < 3) return;
  const std::string expression = words.back();
  if (words[1].starts_with("DO")) {
    const size_t level = line.find("level ");
    ++counts["level " + line.substr(level + 6, 1)];
    const bool is_always = expression == "always";
    ++counts[words[1] + ": " + (is_always ? expression : CountPairs(expression, KindOf, counts))];
    return;
  }
  if (!words[1].starts_with("assign")) return;
  const bool is_inverted = words[1] == "assign-inverted";
  const std::string target = KindOf(words[2]);
  for (const std::string& word : words) {
    if (word.starts_with('[')) ++counts[target + " [" + KindOf(word.substr(1)) + "]"];
  }
  if (!expression.starts_with("(MUX ")) {
    ++counts[(is_inverted ? "/" : "") + target + "= " + CountPairs(expression, KindOf, counts)];
    return;
  }
  ++counts[target + "= MUX"];
  const std::vector<std::string> rows = Parts(expression.substr(5, expression.rfind(')') - 5), ' ');
  ++counts["MUX of " + std::to_string(rows.size())];
  for (const std::string& row : rows) {
    const std::vector<std::string> parts = Parts(row.substr(1, row.rfind(')') - 1), ' ');  // signal -> word
    if (parts.size() != 3) continue;
    ++counts["MUX signal " + CountPairs(parts[0], KindOf, counts)];
    ++counts["MUX word " + CountPairs(parts[2], KindOf, counts)];
  }
}

}  // namespace plcxx::reference::forms
