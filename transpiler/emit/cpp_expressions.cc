#include "transpiler/emit/cpp_printer.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit {
namespace {

using ir::Precedence;

std::string Hex(uint64_t value, uint32_t digits) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string out;
  do {
    out.insert(out.begin(), kHex[value & 15]);
    value >>= 4;
  } while (value != 0 || out.size() < digits);
  return "0x" + out;
}

Spelling SpellConstant(const ir::Inst& inst) {
  const uint64_t value = ir::ConstantValue(inst);
  if (inst.type == ir::Type::kBit) return {value != 0 ? "true" : "false", Precedence::kPrimary};
  if (inst.c == 16) return {Hex(value, 2 * ir::Bytes(inst.type)), Precedence::kPrimary};
  // A literal that no int holds needs its suffix on every target.
  const bool wide = value > 0x7FFF;
  return {std::to_string(value) + (wide ? "u" : ""), Precedence::kPrimary};
}

/// C++ compilers warn where `&` meets `|` without brackets, and readers hesitate; only a chain of one operator goes
/// without.
bool NeedsBrackets(Precedence inner, Precedence outer, bool left) {
  if (inner == Precedence::kPrimary) return false;
  // "!a & b" makes GCC ask whether "!(a & b)" was meant when b is a packed bit; behind the operator it does not.
  if (inner == Precedence::kUnary) return left && outer >= Precedence::kAnd;
  if (outer == Precedence::kUnary) return true;
  return !(inner == outer && left && inner >= Precedence::kAnd);
}

/// Compilers warn of a comparison with a constant that no value passes; called by name it is just false.
bool NeverTrue(const Emittable& emittable, const ir::Inst& inst) {
  const bool less = inst.op == ir::OpKind::kLess8, greater = inst.op == ir::OpKind::kGreater8;
  if (!less && !greater) return false;
  const auto is = [&emittable](uint32_t word, uint64_t value) {
    const ir::Inst& operand = (*emittable.program)[ir::ValueId(word)];
    return operand.op == ir::OpKind::kConst && ir::ConstantValue(operand) == value;
  };
  return is(inst.b, less ? 0 : 255) || is(inst.a, less ? 255 : 0);
}

Spelling SpellPure(const Emittable& emittable, const LocalNames& local_names, const ir::Inst& inst) {
  const ir::OpInfo& info = ir::Info(inst.op);
  const uint32_t words[] = {inst.a, inst.b, inst.c};
  // "{0}" alone: the conversion is C++'s own.
  if (info.spelling == "{0}") return Spell(emittable, local_names, ir::ValueId(inst.a));
  if (NeverTrue(emittable, inst)) {
    const std::string name = inst.op == ir::OpKind::kLess8 ? "Less8(" : "Greater8(";
    return {name + Spell(emittable, local_names, ir::ValueId(inst.a)).text + ", " +
                Spell(emittable, local_names, ir::ValueId(inst.b)).text + ")",
            Precedence::kPrimary};
  }
  std::string out;
  const std::string_view pattern = info.spelling;
  const bool operation = info.precedence != Precedence::kPrimary;
  for (size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      const auto operand = static_cast<uint32_t>(pattern[i + 1] - '0');
      Spelling inner = Spell(emittable, local_names, ir::ValueId(words[operand]));
      if (operation && NeedsBrackets(inner.precedence, info.precedence, operand == 0)) {
        out += '(';
        out += inner.text;
        out += ')';
      } else {
        out += inner.text;
      }
      i += 2;
    } else if (operation && pattern[i] == ' ' && i + 1 < pattern.size() && pattern[i + 1] != '{') {
      out += kBreak;  // before an operator
    } else {
      out += pattern[i];
    }
  }
  return {std::move(out), info.precedence};
}

}  // namespace

Spelling Spell(const Emittable& emittable, const LocalNames& local_names, ir::ValueId value) {
  if (emittable.local_value[value.index]) return {local_names.at(value.index), Precedence::kPrimary};
  return SpellDefinition(emittable, local_names, value);
}

Spelling SpellDefinition(const Emittable& emittable, const LocalNames& local_names, ir::ValueId value) {
  const ir::Program& program = *emittable.program;
  const ir::Inst& inst = program[value];
  const ir::OpInfo& info = ir::Info(inst.op);
  switch (info.shape) {
    case ir::Shape::kConst:
      return SpellConstant(inst);
    case ir::Shape::kPure:
      return SpellPure(emittable, local_names, inst);
    case ir::Shape::kLoad: {
      const ir::PlaceId place(inst.payload);
      const std::string& name = emittable.place_names[place.index];
      if (emittable.layout.places[place.index].storage == Storage::kLocal) return {name, Precedence::kPrimary};
      return {"m[" + name + "]", Precedence::kPrimary};
    }
    case ir::Shape::kStep: {
      std::string out;
      const uint32_t words[] = {inst.a, inst.b, inst.c};
      for (size_t i = 0; i < info.spelling.size(); ++i) {
        if (info.spelling[i] != '{') {
          out += info.spelling[i];
          continue;
        }
        const char what = info.spelling[i + 1];
        out += what == 's' ? "m[" + emittable.state_names[inst.payload] + "]"
                           : Spell(emittable, local_names, ir::ValueId(words[what - '0'])).text;
        i += 2;
      }
      return {std::move(out), Precedence::kPrimary};
    }
    case ir::Shape::kHostCall: {
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      const ir::HostFunction& function = program.host_functions[call.host];
      std::string out = function.name + "(host";
      if (function.access == ir::HostAccess::kReadsState || function.access == ir::HostAccess::kWritesState)
        out += ", m";
      if (function.access == ir::HostAccess::kReadsRetentive) out += ", m.retentive";
      for (size_t i = 0; i < call.arguments.size(); ++i) {
        const ir::Parameter& parameter = function.parameters[i];
        const ir::Inst& argument = program[call.arguments[i]];
        out += ", ";
        if (!parameter.enumerators.empty() && argument.op == ir::OpKind::kConst) {
          out += function.name + "_" + parameter.name + "::" + parameter.enumerators.at(ir::ConstantValue(argument));
        } else {
          out += Spell(emittable, local_names, call.arguments[i]).text;
        }
      }
      return {out + ")", Precedence::kPrimary};
    }
    case ir::Shape::kCall: {
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      std::string out = program.routines[call.routine].name + "(m";
      for (const ir::ValueId argument : call.arguments) out += ", " + Spell(emittable, local_names, argument).text;
      return {out + ", host)", Precedence::kPrimary};
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
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::emit
