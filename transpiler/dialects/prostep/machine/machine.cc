#include "transpiler/dialects/prostep/machine/machine.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "transpiler/support/check.h"

namespace plcxx::prostep {
namespace {

struct SpaceRow {
  std::string_view name;
  uint32_t bytes;
};
constexpr SpaceRow kSpaces[] = {
#define PROSTEP_SPACE(Key, Bytes) {#Key, Bytes},
#include "transpiler/dialects/prostep/machine/machine.def"
};

struct ClassRow {
  std::string_view name;
  Space space;
  Shape shape;
};
constexpr ClassRow kClasses[] = {
#define PROSTEP_CLASS(Key, SpaceKey, ShapeKey) {#Key, Space::k##SpaceKey, Shape::k##ShapeKey},
#include "transpiler/dialects/prostep/machine/machine.def"
};

struct PortsRow {
  Access access;
  Shape shape;
  uint32_t first, last;
};
constexpr PortsRow kPorts[] = {
#define PROSTEP_PORTS(AccessKey, ShapeKey, First, Last) {Access::k##AccessKey, Shape::k##ShapeKey, First, Last},
#include "transpiler/dialects/prostep/machine/machine.def"
};

constexpr InstructionInfo kInstructions[] = {
#define PROSTEP_INSTRUCTION(Key, Text, LinesKey, Own, Next, AccessKey, RoleKey, UseKey, AxKey)             \
  {Op::k##Key,      Text,           Lines::k##LinesKey, Own, Next, Access::k##AccessKey, Role::k##RoleKey, \
   SUse::k##UseKey, AxUse::k##AxKey},
#include "transpiler/dialects/prostep/machine/machine.def"
    {},
};

constexpr std::string_view kModuleMarks[] = {
#define PROSTEP_MODULE_MARK(Key, Text) Text,
#include "transpiler/dialects/prostep/machine/machine.def"
};

constexpr ShapeInfo kShapes[] = {
#define PROSTEP_SHAPE(Key, Bytes, AccessKey, ConstantKey) {Bytes, Access::k##AccessKey, Constant::k##ConstantKey},
#include "transpiler/dialects/prostep/machine/machine.def"
};

/// The names of the shapes, as the rows of the functional modules use them.
namespace shapes {
#define PROSTEP_SHAPE(Key, ...) constexpr ArgumentShape Key = ArgumentShape::k##Key;
#include "transpiler/dialects/prostep/machine/machine.def"
}  // namespace shapes

constexpr FunctionInfo MakeFunction(std::string_view name, AxUse ax_use, uint8_t fewest,
                                    std::initializer_list<ArgumentShape> arguments) {
  FunctionInfo info{.name = name, .ax_use = ax_use, .fewest = fewest, .count = static_cast<uint8_t>(arguments.size())};
  std::copy(arguments.begin(), arguments.end(), info.arguments);
  return info;
}

std::span<const FunctionInfo> Functions() {
  using namespace shapes;
  static constexpr FunctionInfo kRows[] = {
#define PROSTEP_FUNCTION(Key, UseKey, Fewest, ...) MakeFunction(#Key, AxUse::k##UseKey, Fewest, {__VA_ARGS__}),
#include "transpiler/dialects/prostep/machine/machine.def"
  };
  return kRows;
}

struct NumberRow {
  uint32_t number;
  Function function;
};
constexpr NumberRow kNumbers[] = {
#define PROSTEP_FUNCTION_NUMBER(Number, Key) {Number, Function::k##Key},
#include "transpiler/dialects/prostep/machine/machine.def"
};

struct VariableRow {
  uint32_t index;
  std::string_view read, written;  // digits: widths in bytes
  std::string_view name;
};
constexpr VariableRow kVariables[] = {
#define PROSTEP_VARIABLE(Index, Read, Written, NameText) {Index, Read, Written, NameText},
#include "transpiler/dialects/prostep/machine/machine.def"
};

struct ForeignRow {
  std::string_view word, hint;
};
constexpr ForeignRow kForeign[] = {
#define PROSTEP_FOREIGN(Word, Hint) {Word, Hint},
#include "transpiler/dialects/prostep/machine/machine.def"
};

const VariableRow* RowOfVariable(uint32_t index) {
  const auto row = std::ranges::find(kVariables, index, &VariableRow::index);
  return row == std::end(kVariables) ? nullptr : row;
}

}  // namespace

uint32_t BytesOf(Space space) { return space == Space::kNone ? 0 : kSpaces[static_cast<size_t>(space)].bytes; }
std::string_view Name(Space space) { return space == Space::kNone ? "" : kSpaces[static_cast<size_t>(space)].name; }

std::string_view Name(OperandClass operand_class) {
  return operand_class == OperandClass::kNone ? "" : kClasses[static_cast<size_t>(operand_class)].name;
}

Shape ShapeOf(OperandClass operand_class) {
  PLCXX_CHECK(operand_class != OperandClass::kNone);
  return kClasses[static_cast<size_t>(operand_class)].shape;
}

Space SpaceOf(OperandClass operand_class) {
  return operand_class == OperandClass::kNone ? Space::kNone : kClasses[static_cast<size_t>(operand_class)].space;
}

OperandClass ClassByName(std::string_view word) {
  const auto row = std::ranges::find(kClasses, word, &ClassRow::name);
  return static_cast<OperandClass>(row - std::begin(kClasses));
}

bool IsPort(Access access, Shape shape, uint32_t number) {
  return std::ranges::any_of(kPorts, [&](const PortsRow& row) {
    return row.access == access && row.shape == shape && row.first <= number && number <= row.last;
  });
}

bool Accepts(OperandSet set, OperandClass operand_class) {
  if (operand_class == OperandClass::kNone) return false;
  switch (ShapeOf(operand_class)) {
    case Shape::kBit:
      return (set & kBits) != 0;
    case Shape::kByte:
      return (set & kBytes) != 0;
    case Shape::kWord:
      return (set & kWords) != 0;
    case Shape::kCounter:
      return (set & kCounterSet) != 0;
    case Shape::kTimer:
      return (set & kTimerSet) != 0;
    case Shape::kConstant:
      return (set & kConstants) != 0;
    case Shape::kModule:
      return (set & kModuleSet) != 0;
    case Shape::kFunction:
      return (set & kFunctions) != 0;
    case Shape::kDouble:
      return false;
  }
  PLCXX_UNREACHABLE();
}

std::span<const InstructionInfo> Instructions() { return kInstructions; }
const InstructionInfo& Info(Op op) { return kInstructions[static_cast<size_t>(op)]; }

std::optional<ModuleMark> ModuleMarkByName(std::string_view word) {
  const auto row = std::ranges::find(kModuleMarks, word);
  if (row == std::end(kModuleMarks)) return std::nullopt;
  return static_cast<ModuleMark>(row - std::begin(kModuleMarks));
}

const ShapeInfo& Info(ArgumentShape shape) { return kShapes[static_cast<size_t>(shape)]; }
const FunctionInfo& Info(Function function) { return Functions()[static_cast<size_t>(function)]; }

std::optional<Function> FunctionByNumber(uint32_t number) {
  const auto row = std::ranges::find(kNumbers, number, &NumberRow::number);
  if (row == std::end(kNumbers)) return std::nullopt;
  return row->function;
}

std::string_view VariableName(uint32_t index) {
  const VariableRow* row = RowOfVariable(index);
  return row == nullptr ? std::string_view() : row->name;
}

bool IsVariable(uint32_t index, uint32_t width, VariableUse use) {
  const VariableRow* row = RowOfVariable(index);
  if (row == nullptr) return false;
  const std::string_view widths = use == VariableUse::kRead ? row->read : row->written;
  return widths.find(static_cast<char>('0' + width)) != std::string_view::npos;
}

std::string_view ForeignOperandHint(std::string_view word) {
  struct ForeignOperand {
    std::string_view word, hint;
  };
  constexpr ForeignOperand kForeignOperands[] = {
      {"E", "inputs are I: I 0.0"},
      {"EB", "input bytes are IB: IB 0"},
      {"EW", "input words are IW: IW 0"},
      {"A", "outputs are O: O 0.0"},
      {"AB", "output bytes are OB: OB 0"},
      {"AW", "output words are OW: OW 0"},
      {"Q", "outputs are O: O 0.0"},
      {"QB", "output bytes are OB: OB 0"},
      {"QW", "output words are OW: OW 0"},
      {"M", "flags are F: F 0.0"},
      {"MB", "flag bytes are FB: FB 0"},
      {"MW", "flag words are FW: FW 0"},
      {"Z", "counters are C: C 0"},
      {"KF", "a constant is K and its number, on the next line"},
      {"KB", "a constant is K and its number, on the next line"},
      {"KH", "a constant is K and its number, 0FFH, on the next line"},
      {"KC", "a count is K and its digits, 30D, on the next line"},
      {"KZ", "a count is K and its digits, 30D, on the next line"},
      {"KT", "a time is K, a scale digit and three digits, on the next line: K 2030D is 30 times 100 ms"},
      {"KM", "a constant is K and its number, 0FFH, on the next line"},
      {"KY", "a constant is K and its number, 0FFH, on the next line"},
  };
  const auto row = std::ranges::find(kForeignOperands, word, &ForeignOperand::word);
  return row == std::end(kForeignOperands) ? std::string_view() : row->hint;
}

std::string_view ForeignHint(std::string_view word) {
  const auto row = std::ranges::find(kForeign, word, &ForeignRow::word);
  return row == std::end(kForeign) ? std::string_view() : row->hint;
}

}  // namespace plcxx::prostep
