// "ADDW 2 %TM.V": an instruction, the place of an operand and what is there. "drawn ADDW": in a drawing. "+ %W", "+ *":
// operators of expressions with their operands.
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "tests/reference/made_forms_tables.h"
#include "transpiler/dialects/host50/machine/machine.h"

namespace plcxx::reference::forms {
namespace {

using namespace host50;
using Texts = std::vector<std::string>;

constexpr Op kOps[] = {
#define HOST50_INSTRUCTION(Name, ...) Op::k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
};

Texts operator+(Texts a, const Texts& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Texts& Bits() {
  static const Texts kBits = {"%I", "%Q", "%B", "%TM.Q", "%C.Q"};
  return kBits;
}
const Texts& Integers() {
  static const Texts kIntegers = {"integer", "%W", "%IW", "%QW", "%TM.V", "%TM.P", "%C.V", "%C.P"};
  return kIntegers;
}
const Texts& Floats() {
  static const Texts kFloats = {"float", "%F", "%IF", "%QF"};
  return kFloats;
}

Texts KindsOf(OperandRole role) {
  static const Texts kIntegerResults = {"%W", "%QW", "%IW", "%C.V"}, kFloatResults = {"%F", "%QF", "%IF"};
  switch (role) {
    case OperandRole::kBit:
      return Bits();
    case OperandRole::kBitOrConstant:
      return Bits() + Texts{"integer"};
    case OperandRole::kCoil:
      return {"%Q", "%B"};
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
    case OperandRole::kAxisNumber:
    case OperandRole::kHomingMethod:
      return Integers();
    case OperandRole::kIntResult:
      return kIntegerResults;
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
      return Floats();
    case OperandRole::kFloatResult:
      return kFloatResults;
    case OperandRole::kNumberSource:
      return Integers() + Floats();
    case OperandRole::kPosition: {  // an integer constant stands for a float
      Texts kinds = Integers() + Floats();
      std::erase(kinds, "integer");
      return kinds;
    }
    case OperandRole::kNumberResult:
    case OperandRole::kNumberInPlace:
      return kIntegerResults + kFloatResults;
    case OperandRole::kFieldSource:
      return {"%B", "%I", "%Q"};
    case OperandRole::kFieldResult:
      return {"%B", "%Q"};
    case OperandRole::kTimer:
      return {"%TM"};
    case OperandRole::kCounter:
      return {"%C"};
    case OperandRole::kBitCount:
    case OperandRole::kUnit:
    case OperandRole::kSubroutine:
    case OperandRole::kJumpTarget:
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
    case OperandRole::kText:
      break;
  }
  return {};
}

/// "%W1:Count_1" -> "%W", "%TM3.V" -> "%TM.V"
std::string KindOf(const std::string& operand) {
  if (operand.starts_with('%')) {
    std::string kind = operand.substr(0, operand.find(':'));
    std::erase_if(kind, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
    return kind;
  }
  return operand.find_first_of(".ein") == std::string::npos ? "integer" : "float";
}

}  // namespace

std::set<std::string> OfHost50() {
  std::set<std::string> all;
  for (const Op op : kOps) {
    const InstructionInfo& info = Info(op);
    const std::string name(info.name);
    // A drawing has contacts, coils and blocks; its joins are lines.
    const bool is_timer = info.state == State::kTimer;
    all.insert(name);
    if (info.form == Form::kBlock) all.insert("drawn " + name);
    size_t place = 0;
    for (size_t i = 0; i < info.operand_count; ++i) {
      if (info.operands[i] == OperandRole::kUnit) continue;
      ++place;
      for (const std::string& kind : KindsOf(info.operands[i])) {
        all.insert(name + " " + std::to_string(place) + " " + kind);
      }
    }
    for (const char pin : info.pins) {
      for (const std::string& kind : Texts{"0", "1", "stack"}) all.insert(name + " " + pin + "=" + kind);
      for (const std::string& bit : Bits()) {
        all.insert(name + " " + pin + "=" + bit);
        all.insert(name + " " + pin + "=!" + bit);
      }
    }
    if (!is_timer) continue;
    for (const char* unit : {"100ms", "1000ms", "60000ms"}) all.insert(name + " in " + unit);
  }
  for (const char* name : {"AND", "ANDI", "ANDP", "ANDF", "OUT", "OUTI", "SET", "RST"}) {
    all.insert(std::string("drawn ") + name);
  }
  const Texts of_expressions = Integers() + Floats() + Bits();
  const Texts arithmetic = {"+", "-", "*", "/"}, logic = {"&", "|"};
  for (const std::string& operation : arithmetic + Texts{"negate", "<", ">", "<=", ">=", "=", "<>"}) {
    for (const std::string& kind : of_expressions + arithmetic + logic + Texts{"negate"}) {
      all.insert(operation + " " + kind);
    }
  }
  for (const std::string& operation : logic) {
    for (const std::string& kind : Integers() + Bits() + arithmetic + logic + Texts{"negate"}) {
      all.insert(operation + " " + kind);
    }
  }
  return all;
}

/// "    10:1 #4 TON 1000ms %TM1, %TM2.P <- #3"; in a drawing what precedes is a net: "<- rail".
void CountHost50(const std::string& line, FormCounts& counts) {
  static thread_local bool is_drawn = false;
  if (line.find(" network ") != std::string::npos) is_drawn = line.find(" drawn") != std::string::npos;
  const size_t number = line.find(" #");
  const size_t name_at = number == std::string::npos ? number : line.find(' ', number + 1);
  if (name_at == std::string::npos || line.find(':') > number) return;
  std::string text = line.substr(name_at + 1);
  text = text.substr(0, text.find(" <- "));
  const size_t blank = text.find(' ');
  const std::string name = text.substr(0, blank);
  ++counts[name];
  if (is_drawn) ++counts["drawn " + name];
  if (blank == std::string::npos || name == "REMARK") return;
  std::string operands = text.substr(blank + 1);
  if (operands.find("ms ") < operands.find(',')) {  // the unit
    ++counts[name + " in " + operands.substr(0, operands.find(' '))];
    operands = operands.substr(operands.find(' ') + 1);
  }
  size_t place = 0;
  for (const std::string& operand : Parts(operands, ',')) {
    if (operand.starts_with('(')) {
      std::string expression = operand;
      for (size_t at = expression.find(")f"); at != std::string::npos; at = expression.find(")f")) {
        expression.erase(at + 1, 1);
      }
      CountPairs(expression, KindOf, counts);
      continue;
    }
    const size_t equals = operand.find('=');
    if (equals == std::string::npos) {
      ++counts[name + " " + std::to_string(++place) + " " + KindOf(operand)];
      continue;
    }
    const std::string value = operand.substr(equals + 1);
    const bool is_inverted = value.starts_with('!');
    const std::string kind = value == "0" || value == "1" ? value
                             : value.starts_with('#')     ? "stack"
                                                      : (is_inverted ? "!" : "") + KindOf(value.substr(is_inverted));
    ++counts[name + " " + operand.substr(0, equals + 1) + kind];
  }
}

}  // namespace plcxx::reference::forms
