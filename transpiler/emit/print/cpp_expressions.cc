#include <algorithm>
#include <bit>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

#include "transpiler/emit/print/cpp_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"
#include "transpiler/support/hex.h"

namespace plcxx::emit::print {
namespace {

using ir::Precedence;

constexpr std::string_view kChoice = "({0} ?";  // how rows of ops.def begin that choose one of two values

std::string Hex(uint64_t value, uint32_t digits) {
  return "0x" + support::HexDigits(value, digits, support::HexLetters::kCapital);
}

/// As many as a byte, a word, a double word has: the mask 0x20 is spelled alike wherever it is used.
uint32_t DigitsOfWidth(uint64_t value) {
  if (value <= 0xFF) return 2;
  if (value <= 0xFFFF) return 4;
  return value <= 0xFFFFFFFF ? 8 : 16;
}

/// "500" of 4294966796: what is subtracted where that is added.
std::string Negated(const ir::Inst& constant) {
  return std::to_string((uint64_t{1} << 32) - ir::ConstantValue(constant));
}

/// The shortest decimal that reads back as the same number; numbers that have none by their bits.
template <class T>
std::string FloatText(T value, std::string_view suffix) {
  char text[32];
  const std::to_chars_result end = std::to_chars(std::begin(text), std::end(text), value);
  std::string out(text, end.ptr);
  if (out.find_first_of(".e") == std::string::npos) out += ".0";
  return out.append(suffix);
}

Spelling SpellConstant(const ir::Inst& inst) {
  const uint64_t value = ir::ConstantValue(inst);
  const bool integer = inst.type != ir::Type::kBit && inst.type != ir::Type::kF32 && inst.type != ir::Type::kF64;
  if (integer && inst.c == 16) return {IntegerText(value, inst.c), Precedence::kPrimary};
  const std::string text = ConstantText(inst.type, value);
  return {text, text.front() == '-' ? Precedence::kUnary : Precedence::kPrimary};
}

/// C++ compilers warn where `&` meets `|` without brackets, and readers hesitate; only a chain of one operator goes
/// without.
bool NeedsBrackets(Precedence inner, Precedence outer, bool left) {
  if (inner == Precedence::kPrimary) return false;
  // "!a & b" makes GCC ask whether "!(a & b)" was meant when b is a packed bit; after the operator it does not.
  if (inner == Precedence::kUnary) return left && outer >= Precedence::kAnd;
  if (outer == Precedence::kUnary) return true;
  return !(inner == outer && left && inner >= Precedence::kAnd);
}

/// A constant read as two's complement, where 16 bits hold it: the lowest number of an int, which has no literal, stays
/// a call.
std::optional<int64_t> SignedConstant(const ir::Program& program, ir::ValueId value) {
  const ir::Inst& inst = program[value];
  const bool minus = inst.op == ir::OpKind::kMinus16 || inst.op == ir::OpKind::kMinus32;
  const ir::Inst& constant = minus ? program[ir::ValueId(inst.a)] : inst;
  if (constant.op != ir::OpKind::kConst || constant.c == 16) return std::nullopt;
  const uint32_t bits = 8 * ir::Bytes(constant.type);
  if (bits < 8 || bits > 32) return std::nullopt;
  const auto raw = static_cast<int64_t>(ir::ConstantValue(constant));
  const int64_t number = raw >= int64_t{1} << (bits - 1) ? raw - (int64_t{1} << bits) : raw;
  const int64_t read = minus ? -number : number;
  if (read > 0x7FFF || read < -0x8000) return std::nullopt;
  return read;
}

/// "{0} != {1}" of "{0} == {1}".
std::string Complement(std::string_view comparison) {
  constexpr std::pair<std::string_view, std::string_view> kComplements[] = {
      {" == ", " != "}, {" < ", " >= "}, {" <= ", " > "}, {" > ", " <= "}, {" >= ", " < "}, {" != ", " == "}};
  for (const auto& [sign, complement] : kComplements) {
    const size_t at = comparison.find(sign);
    if (at == std::string_view::npos) continue;
    return std::string(comparison).replace(at, sign.size(), complement);
  }
  PLCXX_UNREACHABLE();
}

/// The name of a function of runtime_support, for which the program has a `using`.
Text Declared(const Emittable& emittable, std::string_view function) {
  PLCXX_CHECK(std::ranges::binary_search(emittable.functions, function));
  return Text(std::string(function));
}

Spelling SpellPattern(const Emittable& emittable, const ir::Inst& inst, std::string_view pattern);

Spelling SpellPure(const Emittable& emittable, ir::InstId id) {
  const ir::Inst& inst = (*emittable.program)[id];
  const ir::OpInfo& info = ir::Info(inst.op);
  const ir::ValueId first(inst.a);
  // "{0}" alone: the conversion is C++'s own.
  if (info.spelling == "{0}") return Spell(emittable, first);
  switch (emittable.wordings[id.index]) {
    case Wording::kFunction:
      return {Declared(emittable, info.function) + "(" + Spell(emittable, first).text + ", " +
                  Spell(emittable, ir::ValueId(inst.b)).text + ")",
              Precedence::kPrimary};
    case Wording::kComplement: {
      const ir::Inst& comparison = (*emittable.program)[first];
      return SpellPattern(emittable, comparison, Complement(ir::Info(comparison.op).spelling));
    }
    case Wording::kSubtract:
      return {Declared(emittable, ir::Info(ir::OpKind::kSub32).function) + "(" + Spell(emittable, first).text + ", " +
                  Negated((*emittable.program)[ir::ValueId(inst.b)]) + ")",
              Precedence::kPrimary};
    case Wording::kTable:
    case Wording::kDiscard:
    case Wording::kNegative:
      break;
  }
  Spelling spelled = SpellPattern(emittable, inst, info.spelling);
  if (!IsChoiceByOneBit(emittable, inst)) return spelled;
  return {Text("static_cast<" + std::string(ir::CppName(inst.type)) + ">") + spelled.text, Precedence::kPrimary};
}

/// What a text is to C++ where it is nothing but stored data: m[a], or a choice of such.
struct Stored {
  ir::Type type = ir::Type::kNone;  // kNone: it is something else
  bool converts = false;            // an object of runtime_support that converts to the type, no member of State
};

Stored StoredBy(const Emittable& emittable, ir::ValueId value) {
  const ir::Inst& inst = (*emittable.program)[value];
  if (emittable.forms[value.index] == Form::kLocal) return {};
  if (inst.op == ir::OpKind::kLoad) {
    const layout::Storage storage = emittable.layout.places[inst.payload].storage;
    if (storage == layout::Storage::kLocal) return {};
    const bool bytes = storage == layout::Storage::kWide || storage == layout::Storage::kIndexed ||
                       storage == layout::Storage::kRetentiveWide || storage == layout::Storage::kRetentiveIndexed;
    return {inst.type, bytes || emittable.options.flavour == Flavour::kDebug};
  }
  const std::string_view spelling = ir::Info(inst.op).spelling;
  if (spelling == "{0}") return StoredBy(emittable, ir::ValueId(inst.a));
  if (!spelling.starts_with(kChoice)) return {};
  const Stored first = StoredBy(emittable, ir::ValueId(inst.b)), second = StoredBy(emittable, ir::ValueId(inst.c));
  if (first.type != second.type) return {};
  return {first.type, first.converts || second.converts};
}

/// Of a choice one arm takes the type of the other, and where one is an object that converts, it takes that of the
/// other whatever it is: "c ? a < b : m[w]" is a bool. So that arm says its own type: "c ? a < b : uint16_t{m[w]}".
bool SaysItsType(const Emittable& emittable, ir::ValueId arm, ir::ValueId other) {
  const Stored stored = StoredBy(emittable, arm);
  return stored.converts && stored.type != ir::Type::kBit && StoredBy(emittable, other).type != stored.type;
}

/// The operation as `pattern` spells it, which binds as the operation's own.
Spelling SpellPattern(const Emittable& emittable, const ir::Inst& inst, std::string_view pattern) {
  const ir::OpInfo& info = ir::Info(inst.op);
  const uint32_t words[] = {inst.a, inst.b, inst.c};
  Text out;
  const bool operation = info.precedence != Precedence::kPrimary;
  const size_t name = pattern.find('(');
  if (name != std::string_view::npos && name > 0) Declared(emittable, pattern.substr(0, name));
  for (size_t i = 0; i < pattern.size(); ++i) {
    // "S16({1})" of a constant is the number itself.
    const size_t bracket = operation && pattern[i] == 'S' ? pattern.find("({", i) : std::string_view::npos;
    if (bracket != std::string_view::npos && bracket - i <= 3) {
      const ir::ValueId operand(words[pattern[bracket + 2] - '0']);
      if (const std::optional<int64_t> number = SignedConstant(*emittable.program, operand)) {
        out += std::to_string(*number);
        i = bracket + 4;
        continue;
      }
    }
    if (pattern[i] == '{') {
      const auto operand = static_cast<uint32_t>(pattern[i + 1] - '0');
      Spelling inner = Spell(emittable, ir::ValueId(words[operand]));
      // A choice binds loosest; compilers ask whether its condition was meant to be all that stands before it.
      const bool choice = pattern.starts_with(kChoice);
      if (choice && operand > 0 &&
          SaysItsType(emittable, ir::ValueId(words[operand]), ir::ValueId(words[3 - operand]))) {
        const ir::Type type = StoredBy(emittable, ir::ValueId(words[operand])).type;
        inner = {Text(ir::CppName(type)) + "{" + inner.text + "}", Precedence::kPrimary};
      }
      const bool condition = operand == 0 && choice && inner.precedence >= Precedence::kAnd;
      const bool brackets = condition || (operation && NeedsBrackets(inner.precedence, info.precedence, operand == 0));
      if (brackets) out.chars += '(';
      out += inner.text;
      if (brackets) out.chars += ')';
      i += 2;
    } else if (operation && pattern[i] == ' ' && i + 1 < pattern.size() && pattern[i + 1] != '{') {
      out.chars += kBreak;  // before an operator
    } else {
      out.chars += pattern[i];
    }
  }
  return {std::move(out), info.precedence};
}

}  // namespace

std::string IntegerText(uint64_t value, uint32_t base) {
  return base == 16 ? Hex(value, DigitsOfWidth(value)) : std::to_string(value);
}

std::string ConstantText(ir::Type type, uint64_t value) {
  switch (type) {
    case ir::Type::kBit:
      return value != 0 ? "true" : "false";
    case ir::Type::kF32: {
      const auto number = std::bit_cast<float>(static_cast<uint32_t>(value));
      if (!HasLiteral(type, value)) return "F32OfBits(" + Hex(value, 8) + ")";
      return FloatText(number, "F");
    }
    case ir::Type::kF64: {
      const auto number = std::bit_cast<double>(value);
      if (!HasLiteral(type, value)) return "F64OfBits(" + Hex(value, 16) + ")";
      return FloatText(number, "");
    }
    case ir::Type::kNone:
    case ir::Type::kI8:
    case ir::Type::kI16:
    case ir::Type::kI32:
    case ir::Type::kI64:
      break;
  }
  // A literal that no int holds needs its suffix on every target.
  return std::to_string(value) + (value > 0x7FFF ? "u" : "");
}

std::string ElementName(const Emittable& emittable, layout::Storage storage, uint32_t index) {
  if (storage == layout::Storage::kRetentiveByte) return std::to_string(index);
  const auto name = emittable.element_names.find({storage, index});
  if (name != emittable.element_names.end()) return name->second;
  PLCXX_CHECK(storage == layout::Storage::kByte);  // all others have the name of a place
  const auto& stretches = emittable.layout.stretches;
  const auto behind =
      std::upper_bound(stretches.begin(), stretches.end(), index,
                       [](uint32_t wanted, const layout::Stretch& stretch) { return wanted < stretch.index; });
  PLCXX_CHECK(behind != stretches.begin());
  const uint32_t first = std::prev(behind)->index;
  return emittable.element_names.at({storage, first}) + " + " + std::to_string(index - first);
}

Spelling SpellPlace(const Emittable& emittable, ir::PlaceId place, ir::ValueId index) {
  const std::string& name = emittable.place_names[place.index];
  if (emittable.layout.places[place.index].storage == layout::Storage::kLocal) return {name, Precedence::kPrimary};
  const std::vector<bool>& shared = emittable.options.shared;
  if (!shared.empty() && shared[place.index]) return {"plcxx::Once(m[" + name + "])", Precedence::kPrimary};
  if (!emittable.program->places[place].indexed) return {"m[" + name + "]", Precedence::kPrimary};
  return {"m[At(" + name + ", " + Spell(emittable, index).text + ")]", Precedence::kPrimary};
}

Spelling Spell(const Emittable& emittable, ir::ValueId value) {
  if (emittable.forms[value.index] == Form::kLocal) return {emittable.value_names[value.index], Precedence::kPrimary};
  return SpellDefinition(emittable, value);
}

Text SpellInItsType(const Emittable& emittable, ir::ValueId value) {
  const ir::Inst& inst = (*emittable.program)[value];
  const ir::OpInfo& info = ir::Info(inst.op);
  const Text text = Spell(emittable, value).text;
  // Names, loads and calls of functions have it.
  const bool is_function =
      info.precedence == Precedence::kPrimary && info.spelling != "{0}" && !info.spelling.starts_with(kChoice);
  const bool is_computed = info.shape == ir::Shape::kConst || (info.shape == ir::Shape::kPure && !is_function);
  if (inst.type != ir::Type::kI32 || emittable.forms[value.index] == Form::kLocal || !is_computed) return text;
  return Text("static_cast<" + std::string(ir::CppName(inst.type)) + ">(") + text + ")";
}

bool IsSpelledAsBool(const Emittable& emittable, ir::ValueId value) {
  const ir::Inst& inst = (*emittable.program)[value];
  if (inst.type == ir::Type::kBit) return true;
  if (emittable.forms[value.index] == Form::kLocal || ir::Info(inst.op).shape != ir::Shape::kPure) return false;
  const std::string_view spelling = ir::Info(inst.op).spelling;
  if (spelling.starts_with(kChoice))
    return IsSpelledAsBool(emittable, ir::ValueId(inst.b)) && IsSpelledAsBool(emittable, ir::ValueId(inst.c));
  return spelling == "{0}" && IsSpelledAsBool(emittable, ir::ValueId(inst.a));
}

Spelling SpellDefinition(const Emittable& emittable, ir::ValueId value) {
  const ir::Program& program = *emittable.program;
  const ir::Inst& inst = program[value];
  const ir::OpInfo& info = ir::Info(inst.op);
  switch (info.shape) {
    case ir::Shape::kConst:
      if (emittable.wordings[value.index] == Wording::kNegative)
        return {Declared(emittable, ir::Info(ir::OpKind::kMinus32).function) + "(" + Negated(inst) + ")",
                Precedence::kPrimary};
      return SpellConstant(inst);
    case ir::Shape::kPure:
      return SpellPure(emittable, value);
    case ir::Shape::kLoad:
      return SpellPlace(emittable, ir::PlaceId(inst.payload), ir::ValueId(inst.a));
    case ir::Shape::kStep: {
      Text out;
      const uint32_t words[] = {inst.a, inst.b, inst.c};
      for (size_t i = 0; i < info.spelling.size(); ++i) {
        if (info.spelling[i] != '{') {
          out.chars += info.spelling[i];
          continue;
        }
        const char what = info.spelling[i + 1];
        out += what == 's' ? Text("m[" + emittable.state_names[inst.payload] + "]")
                           : Spell(emittable, ir::ValueId(words[what - '0'])).text;
        i += 2;
      }
      return {Spelled(std::move(out), value), Precedence::kPrimary};
    }
    case ir::Shape::kHostCall: {
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      const ir::HostFunction& function = program.host_functions[call.host];
      Text out(function.name + "(host");
      if (function.access == ir::HostAccess::kReadsState || function.access == ir::HostAccess::kWritesState)
        out += ", m";
      if (function.access == ir::HostAccess::kReadsRetentive) out += ", m.retentive";
      for (size_t i = 0; i < call.arguments.size(); ++i) {
        const ir::Parameter& parameter = function.parameters[i];
        const ir::Inst& argument = program[call.arguments[i]];
        out += ", ";
        if (!parameter.enumerators.empty() && argument.op == ir::OpKind::kConst) {
          out += function.name + "_" + parameter.name + "::" + parameter.enumerators.at(ir::ConstantValue(argument));
        } else if (!parameter.enumerators.empty()) {
          out += "static_cast<" + function.name + "_" + parameter.name + ">(" +
                 Spell(emittable, call.arguments[i]).text + ")";
        } else {
          out += Spell(emittable, call.arguments[i]).text;
        }
      }
      if (call.out.valid()) out += ", " + SpellPlace(emittable, call.out, {}).text;
      return {Spelled(std::move(out) + ")", value), Precedence::kPrimary};
    }
    case ir::Shape::kCall: {
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      Text out(emittable.routine_names[call.routine.index] + "(m");
      for (const ir::ValueId argument : call.arguments) out += ", " + Spell(emittable, argument).text;
      for (const ir::PlaceId place : emittable.routine_locals[call.routine.index].shared) {
        out += ", " + emittable.place_names[place.index];
      }
      return {Spelled(std::move(out) + ", host)", value), Precedence::kPrimary};
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

}  // namespace plcxx::emit::print
