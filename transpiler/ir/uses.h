// Which words of an instruction are values, without building a list: for phases that visit every instruction.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// Calls `visit(uint32_t& word)` for every word of the instruction that names a used value, in the order of UsedValues:
/// all that it uses but the arguments of calls.
template <class AnyInst, class Visit>
void ForEachOperand(AnyInst& inst, Visit&& visit) {
  constexpr uint32_t kNone = support::Id<void>::kNone;
  switch (Info(inst.op).shape) {
    case Shape::kPure:
    case Shape::kStep:
      if (inst.a != kNone) visit(inst.a);
      if (inst.b != kNone) visit(inst.b);
      if (inst.c != kNone) visit(inst.c);
      break;
    case Shape::kStore:
      if (inst.a != kNone) visit(inst.a);
      if (inst.b != kNone) visit(inst.b);
      break;
    case Shape::kLoad:
    case Shape::kIf:
    case Shape::kSwitch:
    case Shape::kExit:
    case Shape::kRepeat:
    case Shape::kJump:
      if (inst.a != kNone) visit(inst.a);
      break;
    case Shape::kCall:
    case Shape::kHostCall:
    case Shape::kConst:
    case Shape::kText:
    case Shape::kStatement:
    case Shape::kLoop:
    case Shape::kBlock:
    case Shape::kLabel:
      break;
  }
}

inline bool IsCall(const Inst& inst) { return inst.op == OpKind::kCall || inst.op == OpKind::kHostCall; }

/// Calls `visit(uint32_t& word)` for every word that names a used value, in the order of UsedValues, those of the
/// arguments of calls, too. Works on const programs, too.
template <class AnyProgram, class AnyInst, class Visit>
void ForEachUse(AnyProgram& program, AnyInst& inst, Visit&& visit) {
  if (IsCall(inst)) {
    for (auto& argument : program.calls[CallId(inst.payload)].arguments) visit(argument.index);
  } else {
    ForEachOperand(inst, visit);
  }
}

/// Whether an instruction owns regions; asks no allocation, unlike OwnedRegions.
inline bool OwnsRegions(const Inst& inst) {
  switch (Info(inst.op).shape) {
    case Shape::kIf:
    case Shape::kSwitch:
    case Shape::kLoop:
    case Shape::kBlock:
    case Shape::kRepeat:
      return true;
    case Shape::kJump:
      return RegionId(inst.b).valid();
    case Shape::kPure:
    case Shape::kStep:
    case Shape::kConst:
    case Shape::kLoad:
    case Shape::kStore:
    case Shape::kText:
    case Shape::kStatement:
    case Shape::kExit:
    case Shape::kCall:
    case Shape::kHostCall:
    case Shape::kLabel:
      return false;
  }
  return false;
}

/// Turns an instruction that no region lists any more into one without operands and effects, so that phases that go
/// through Program::insts do not count what it used.
inline void Forget(Inst& inst) { inst = Inst{.op = OpKind::kPoison, .range = inst.range, .a = 0, .b = 0}; }

}  // namespace plcxx::ir
