#include "transpiler/report/ladder_text.h"

#include <array>
#include <string_view>

#include "transpiler/ir/builder.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/hex.h"

namespace plcxx::report {
namespace {

/// Operations by the word before the point of their text: "add.i16", "add.f32". A "±" reads words as two's complement.
struct Operator {
  std::string_view word;
  const char* sign;
  int binding;
};
constexpr auto kOperators = std::to_array<Operator>({
    {"mul", "*", 1},
    {"udiv", "/", 1},
    {"sdiv", "±/", 1},
    {"div", "/", 1},
    {"urem", "mod", 1},
    {"srem", "±mod", 1},
    {"add", "+", 2},
    {"sub", "-", 2},
    {"shl", "<<", 3},
    {"lshr", ">>", 3},
    {"ashr", "±>>", 3},
    {"and", "&", 5},
    {"xor", "xor", 6},
    {"or", "|", 7},
});

struct Comparison {
  std::string_view word;
  const char* sign;
  const char* opposite;
};
constexpr auto kComparisons = std::to_array<Comparison>({
    {"eq", "=", "≠"},
    {"ne", "≠", "="},
    {"ult", "<", "≥"},
    {"ule", "≤", ">"},
    {"ugt", ">", "≤"},
    {"uge", "≥", "<"},
    {"slt", "±<", "±≥"},
    {"sle", "±≤", "±>"},
    {"sgt", "±>", "±≤"},
    {"sge", "±≥", "±<"},
    // Of floats "not less" is not "greater or equal": neither holds when one of them is no number.
    {"lt", "<", nullptr},
    {"gt", ">", nullptr},
    {"le", "≤", nullptr},
    {"ge", "≥", nullptr},
});
constexpr int kComparisonBinding = 4;
constexpr int kWeakest = 9;

std::string_view WordOf(ir::OpKind op) {
  const std::string_view text = ir::Info(op).text;
  return text.substr(0, text.find('.'));
}

const Comparison* ComparisonOf(ir::OpKind op) {
  const ir::OpInfo& info = ir::Info(op);
  if (info.shape != ir::Shape::kPure || info.result != ir::Type::kBit || info.operand_count != 2) return nullptr;
  for (const Comparison& comparison : kComparisons) {
    if (comparison.word == WordOf(op)) return &comparison;
  }
  return nullptr;
}

/// Only widens or reads the same bits: people need not see it.
bool IsTransparent(ir::OpKind op) { return ir::Info(op).spelling == "{0}" || WordOf(op) == "zext"; }

std::string ConstantText(const ir::Inst& inst) {
  const uint64_t value = ir::ConstantValue(inst);
  if (inst.type == ir::Type::kBit) return value != 0 ? "1" : "0";
  if (inst.c != 16 || sim::IsFloat(inst.type)) return sim::ValueDigits(inst.type, value);
  return "0x" + support::HexDigits(value, 2, support::HexLetters::kCapital);
}

/// Is one the other made safe for C++, "F8_1" of "F 8.1"?
bool SameLetters(std::string_view a, std::string_view b) {
  const auto plain = [](std::string_view text) {
    std::string letters;
    for (const char c : text) {
      const bool letter = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c & 0x80) != 0;
      if (letter) letters += c;
    }
    return letters;
  };
  return plain(a) == plain(b);
}

}  // namespace

const char* ComparisonSign(ir::OpKind op) {
  const Comparison* comparison = ComparisonOf(op);
  return comparison == nullptr ? nullptr : comparison->sign;
}

const char* OppositeSign(ir::OpKind op) {
  const Comparison* comparison = ComparisonOf(op);
  return comparison == nullptr ? nullptr : comparison->opposite;
}

ValueText::ValueText(const ProgramInput& input) : input_(input), program_(*input.program) {
  uses_.assign(program_.insts.size(), 0);
  for (const ir::Inst& inst : program_.insts) {
    for (const ir::ValueId value : ir::UsedValues(program_, inst)) {
      if (uses_[value.index] < 255) ++uses_[value.index];
    }
  }
}

bool ValueText::IsLocal(ir::ValueId value) const {
  const ir::Inst& inst = program_[value];
  if (value.index < input_.local_names.size() && !input_.local_names[value.index].empty()) return true;
  return uses_[value.index] > 1 && inst.op != ir::OpKind::kConst && inst.op != ir::OpKind::kLoad;
}

std::string ValueText::LocalName(ir::ValueId value) const {
  if (value.index < input_.local_names.size() && !input_.local_names[value.index].empty()) {
    return input_.local_names[value.index];
  }
  return "#" + std::to_string(value.index);
}

std::string ValueText::Of(ir::ValueId value) const { return Spell(value).text; }
std::string ValueText::Definition(ir::ValueId value) const { return SpellDefinition(value).text; }

std::string ValueText::Place(ir::PlaceId place, ir::ValueId index) const {
  const ir::Place& known = program_.places[place];
  const bool spelled = !known.address.empty() && SameLetters(known.address, known.name);
  const std::string& name = spelled ? known.address : known.name;
  return index.valid() && known.indexed ? name + "[" + Of(index) + "]" : name;
}

std::string ValueText::Arguments(const ir::Call& call) const {
  std::string list;
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    std::string text = Of(call.arguments[i]);
    if (call.host.valid() && i < program_.host_functions[call.host].parameters.size()) {
      const ir::Parameter& parameter = program_.host_functions[call.host].parameters[i];
      const ir::Inst& inst = program_[call.arguments[i]];
      if (inst.op == ir::OpKind::kConst && ir::ConstantValue(inst) < parameter.enumerators.size()) {
        text = parameter.enumerators[ir::ConstantValue(inst)];
      }
    }
    list += (list.empty() ? "" : ", ") + text;
  }
  return list;
}

ValueText::Spelled ValueText::Spell(ir::ValueId value) const {
  if (IsLocal(value)) return {LocalName(value), 0};
  return SpellDefinition(value);
}

ValueText::Spelled ValueText::SpellDefinition(ir::ValueId value) const {
  const ir::Inst& inst = program_[value];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kConst:
      return {ConstantText(inst), 0};
    case ir::Shape::kLoad:
      return {Place(ir::PlaceId(inst.payload), ir::ValueId(inst.a)), 0};
    case ir::Shape::kPure:
      return SpellPure(inst);
    case ir::Shape::kStep: {
      std::string text = program_.states[ir::StateId(inst.payload)].name;
      for (const uint32_t word : {inst.a, inst.b, inst.c}) {
        if (word != kNoWord) text += ", " + Of(ir::ValueId(word));
      }
      return {std::string(ir::Info(inst.op).function) + "(" + text + ")", 0};
    }
    case ir::Shape::kCall:
    case ir::Shape::kHostCall: {
      const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
      const std::string& name =
          call.host.valid() ? program_.host_functions[call.host].name : program_.routines[call.routine].name;
      return {name + "(" + Arguments(call) + ")", 0};
    }
    case ir::Shape::kStore:
    case ir::Shape::kText:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
  return {"?", 0};  // gives no value
}

ValueText::Spelled ValueText::SpellPure(const ir::Inst& inst) const {
  if (inst.op == ir::OpKind::kPoison) return {"?", 0};
  const ir::OpInfo& info = ir::Info(inst.op);
  if (info.operand_count == 1 && IsTransparent(inst.op)) return Spell(ir::ValueId(inst.a));
  const auto operand = [this](uint32_t word, int binding) {
    Spelled spelled = Spell(ir::ValueId(word));
    return spelled.binding > binding ? "(" + spelled.text + ")" : spelled.text;
  };
  if (inst.op == ir::OpKind::kBitNot) return {"not " + operand(inst.a, 0), 1};
  if (info.operand_count == 2) {
    if (const char* sign = ComparisonSign(inst.op); sign != nullptr) {
      return {operand(inst.a, kComparisonBinding - 1) + " " + sign + " " + operand(inst.b, kComparisonBinding - 1),
              kComparisonBinding};
    }
    for (const Operator& known : kOperators) {
      if (known.word != WordOf(inst.op)) continue;
      return {operand(inst.a, known.binding) + " " + known.sign + " " + operand(inst.b, known.binding - 1),
              known.binding};
    }
  }
  if (WordOf(inst.op) == "select") {
    return {
        operand(inst.a, kWeakest - 1) + " ? " + operand(inst.b, kWeakest - 1) + " : " + operand(inst.c, kWeakest - 1),
        kWeakest};
  }
  std::string text(info.function.empty() ? info.text : info.function);
  text += "(";
  for (const uint32_t word : {inst.a, inst.b, inst.c}) {
    if (word != kNoWord) text += (text.back() == '(' ? "" : ", ") + Of(ir::ValueId(word));
  }
  return {text + ")", 0};
}

}  // namespace plcxx::report
