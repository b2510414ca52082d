// "A I": a mnemonic and the class of its operand. "SP [FW]": of an operand on the next line. "FM 60", "FM AddLong 1
// DW".
#include <string>
#include <vector>

#include "tests/reference/made_forms_tables.h"
#include "transpiler/dialects/prostep/machine/machine.h"

namespace plcxx::reference::forms {
namespace {

using namespace prostep;

constexpr OperandClass kClasses[] = {
#define PROSTEP_CLASS(Key, ...) OperandClass::k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
};
constexpr std::pair<uint32_t, Function> kFunctionNumbers[] = {
#define PROSTEP_FUNCTION_NUMBER(number, Key) {number, Function::k##Key},
#include "transpiler/dialects/prostep/machine/machine.def"
};

std::vector<std::string> ClassesOf(OperandSet set) {
  std::vector<std::string> names;
  for (const OperandClass operand_class : kClasses) {
    if (Accepts(set, operand_class)) names.emplace_back(Name(operand_class));
  }
  if ((set & kLabels) != 0) names.emplace_back("label");
  return names;
}

}  // namespace

std::set<std::string> OfProstep() {
  std::set<std::string> all;
  for (const InstructionInfo& info : Instructions()) {
    if (info.op == Op::kUnknown) continue;
    const std::string mnemonic(info.mnemonic);
    if (info.lines == Lines::kNone) all.insert(mnemonic);
    for (const std::string& name : ClassesOf(info.own)) all.insert(mnemonic + " " + name);
    for (const std::string& name : ClassesOf(info.next)) {
      all.insert(mnemonic + (info.lines == Lines::kOwnAndNext ? " [" + name + "]" : " " + name));
    }
  }
  for (const auto& [number, function] : kFunctionNumbers) {
    all.insert("FM " + std::to_string(number));
    const FunctionInfo& info = Info(function);
    for (size_t i = 0; i < info.count; ++i) {
      const ShapeInfo& shape = Info(info.arguments[i]);
      const bool has_constant = shape.constant != Constant::kRefused;
      const bool has_ports = shape.field_bytes == 0;
      for (const std::string& name : ClassesOf(kData | kConstants)) {
        if (name == "K" ? !has_constant : name[0] == 'P' && !has_ports) continue;
        all.insert("FM " + std::string(info.name) + " " + std::to_string(i + 1) + " " + name);
      }
    }
  }
  return all;
}

/// "  7:2 JC FM 60 AddLong [FW 3] [DB 7] [FB 8]"
void CountProstep(const std::string& line, FormCounts& counts) {
  std::vector<std::string> words = Parts(line, ' ');
  if (words.size() < 2 || words[0].find(':') == std::string::npos) return;
  const std::string& mnemonic = words[1];
  if (words.size() == 2) {
    ++counts[mnemonic];
    return;
  }
  const auto class_of = [](const std::string& bracket) { return bracket.substr(1, bracket.find(' ') - 1); };
  const bool is_jump = mnemonic == "JU" || mnemonic == "JC";
  const std::string own = is_jump && words.size() == 3 ? "label" : words[2];
  ++counts[mnemonic + " " + own];
  if (own == "FM") {
    ++counts["FM " + words[3]];
    for (size_t i = 5; i < words.size(); ++i) {
      ++counts["FM " + words[4] + " " + std::to_string(i - 4) + " " + class_of(words[i])];
    }
    return;
  }
  for (size_t i = 3; i < words.size(); ++i) {
    if (words[i].starts_with('[')) ++counts[mnemonic + " [" + class_of(words[i]) + "]"];
  }
}

}  // namespace plcxx::reference::forms
