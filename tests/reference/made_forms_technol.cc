// "MOV r16,WORD.[]": registers by their width, memory by its width and whether a register indexes it.
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "tests/reference/made_forms_tables.h"
#include "transpiler/dialects/technol/machine/machine.h"

namespace plcxx::reference::forms {
namespace {

using namespace technol;
using Texts = std::vector<std::string>;

struct Width {
  std::string reg;
  Texts memory;
};
const std::vector<Width>& Widths() {
  static const std::vector<Width> kWidths = {
      {"r8", {"BYTE.", "BYTE.[]"}}, {"r16", {"WORD.", "WORD.[]"}}, {"r32", {"DWRD.", "DWRD.[]"}}};
  return kWidths;
}
const Texts& Indexes() {
  static const Texts kIndexes = {"BX", "SI", "DI", "EBX", "ESI", "EDI"};
  return kIndexes;
}

/// A register or memory of one width, and what may be with it.
void AddTwo(const std::string& mnemonic, bool has_constant, std::set<std::string>& all) {
  for (const Width& width : Widths()) {
    all.insert(mnemonic + " " + width.reg + "," + width.reg);
    if (has_constant) all.insert(mnemonic + " " + width.reg + ",number");
    for (const std::string& memory : width.memory) {
      all.insert(mnemonic + " " + width.reg + "," + memory);
      all.insert(mnemonic + " " + memory + "," + width.reg);
      if (has_constant) all.insert(mnemonic + " " + memory + ",number");
    }
  }
}

Texts OnePlace() {
  Texts places;
  for (const Width& width : Widths()) {
    places.push_back(width.reg);
    places.insert(places.end(), width.memory.begin(), width.memory.end());
  }
  return places;
}

Texts OperandsOf(const InstructionInfo& info) {
  Texts memory;
  for (const Width& width : Widths()) memory.insert(memory.end(), width.memory.begin(), width.memory.end());
  switch (info.form) {
    case Form::kNone:
      return {""};
    case Form::kBit:
      return {" name", " -name"};
    case Form::kWriteBit:
    case Form::kJump:
    case Form::kCall:
    case Form::kMechanism:
      return {" name"};
    case Form::kFlag:
      return {" number,name"};
    case Form::kWaitLimit:
      return {" -,number,name", " WORD.,number,name", " -,WORD.,name", " WORD.,WORD.,name"};
    case Form::kDelay:
      return {" -,number", " WORD.,number", " -,WORD.", " WORD.,WORD."};
    case Form::kStore:
      for (std::string& place : memory) place.insert(0, " ");
      return memory;
    case Form::kData:
      for (std::string& place : memory) place.insert(0, " ");
      memory.emplace_back(" CNST");
      return memory;
    case Form::kNarrowData:
    case Form::kRotation:
      return {" BYTE.", " BYTE.[]", " CNST"};
    case Form::kWideData:
      return {" BYTE.", " BYTE.[]", " WORD.", " WORD.[]", " CNST"};
    case Form::kError:
      return {" number,number"};
    case Form::kOne:
    case Form::kMultiply: {
      Texts places = OnePlace();
      for (std::string& place : places) place.insert(0, " ");
      return places;
    }
    case Form::kShift: {
      Texts operands;
      for (const std::string& place : OnePlace()) {
        operands.push_back(" " + place + ",number");
        operands.push_back(" " + place + ",r8");
      }
      return operands;
    }
    case Form::kExtend:
      return {" r16,r8",  " r16,BYTE.", " r16,BYTE.[]", " r32,r8",     " r32,BYTE.",
              " r32,r16", " r32,WORD.", " r32,WORD.[]", " r32,BYTE.[]"};
    case Form::kStack:
      return {" r16", " r32"};
    case Form::kTwo:
    case Form::kExchange:
      break;
  }
  return {};
}

std::string KindOf(const std::string& operand) {
  const Register reg = RegisterByName(operand);
  if (reg != Register::kNone) return "r" + std::to_string(Info(reg).width);
  for (const char* prefix : {"BYTE.", "WORD.", "DWRD."}) {
    if (operand.starts_with(prefix)) return std::string(prefix) + (operand.find('[') == std::string::npos ? "" : "[]");
  }
  if (operand.starts_with("CNST")) return "CNST";
  if (operand == "-") return "-";
  const bool is_negative = operand.starts_with('-');
  const bool is_number = std::isdigit(static_cast<unsigned char>(operand[is_negative ? 1 : 0])) != 0;
  return is_number ? "number" : is_negative ? "-name" : "name";
}

}  // namespace

std::set<std::string> OfTechnol() {
  std::set<std::string> all;
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic.empty() || info.op == Op::kUnknown) continue;
    const std::string mnemonic(info.mnemonic);
    const bool is_mark = info.op >= Op::kMechanismBegin;
    if (is_mark) continue;
    if (info.form == Form::kTwo || info.form == Form::kExchange) AddTwo(mnemonic, info.form == Form::kTwo, all);
    for (const std::string& operands : OperandsOf(info)) all.insert(mnemonic + operands);
  }
  for (const std::string& index : Indexes()) all.insert("index " + index);
  for (const ModuleInfo& module : Modules()) {
    if (module.kind != ModuleKind::kOther) all.insert(std::string(module.keyword));
  }
  return all;
}

/// "18: MOV AL,BYTE.B0"
void CountTechnol(const std::string& line, FormCounts& counts) {
  const size_t colon = line.find(": ");
  if (colon == std::string::npos || std::isdigit(static_cast<unsigned char>(line[0])) == 0) {
    ++counts[line];  // a module's head
    return;
  }
  const std::string text = line.substr(colon + 2);
  const size_t blank = text.find(' ');
  std::string form = text.substr(0, blank);
  if (blank != std::string::npos) {
    const char* separator = " ";
    for (const std::string& operand : Parts(text.substr(blank + 1), ',')) {
      form += separator + KindOf(operand);
      separator = ",";
      const size_t bracket = operand.find('[');
      if (bracket != std::string::npos) {
        ++counts["index " + operand.substr(bracket + 1, operand.find_first_of("]+-", bracket) - bracket - 1)];
      }
    }
  }
  ++counts[form];
}

}  // namespace plcxx::reference::forms
