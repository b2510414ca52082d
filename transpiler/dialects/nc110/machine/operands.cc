#include "transpiler/dialects/nc110/machine/operands.h"

#include "transpiler/support/check.h"

namespace plcxx::nc110 {

Type TypeOf(OperandKind kind) {
  switch (kind) {
    case OperandKind::kNone:
      return Type::kUnknown;
    case OperandKind::kWord:
    case OperandKind::kCounterValue:
      return Type::kWord;
    case OperandKind::kInput:
    case OperandKind::kOutput:
    case OperandKind::kTimerInput:
    case OperandKind::kTimerHold:
    case OperandKind::kTimerElapsed:
    case OperandKind::kTimerRunning:
    case OperandKind::kCounterInput:
    case OperandKind::kCounterCarry:
    case OperandKind::kCounterReset:
    case OperandKind::kCounterDown:
    case OperandKind::kOneShot:
      return Type::kSignal;
  }
  PLCXX_UNREACHABLE();
}

char PackageLetter(Package package) {
  switch (package) {
    case Package::kA:
      return 'A';
    case Package::kK:
      return 'K';
    case Package::kN:
      return 'N';
    case Package::kT:
      return 'T';
  }
  PLCXX_UNREACHABLE();
}

std::string ToText(const Operand& operand) {
  const std::string number = std::to_string(operand.number);
  const auto memory = [&](char letter) {
    return letter + number + PackageLetter(operand.package) + std::to_string(operand.index);
  };
  switch (operand.kind) {
    case OperandKind::kNone:
      return "?";
    case OperandKind::kInput:
      return memory('I');
    case OperandKind::kOutput:
      return memory('U');
    case OperandKind::kWord:
      return memory('W');
    case OperandKind::kTimerInput:
      return "T" + number + "I";
    case OperandKind::kTimerHold:
      return "T" + number + "A";
    case OperandKind::kTimerElapsed:
      return "T" + number + "U";
    case OperandKind::kTimerRunning:
      return "T" + number + "D";
    case OperandKind::kCounterInput:
      return "C" + number + "I";
    case OperandKind::kCounterCarry:
      return "C" + number + "R";
    case OperandKind::kCounterReset:
      return "C" + number + "Z";
    case OperandKind::kCounterDown:
      return "C" + number + "A";
    case OperandKind::kCounterValue:
      return "C" + number + "W";
    case OperandKind::kOneShot:
      return "P" + number;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::nc110
