// W04, W10, W17, W20, N01, N02: what a single instruction shows, or the second one for a timer or counter.
#include <set>
#include <utility>

#include "transpiler/dialects/host50/analysis/warnings.h"

namespace plcxx::host50 {
namespace {

constexpr uint32_t kFloatSign = 0x8000'0000;

bool IsZero(Type type, uint32_t bits) { return (type == Type::kFloat ? bits & ~kFloatSign : bits) == 0; }

class InstructionChecks {
 public:
  InstructionChecks(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics)
      : program_(program), sources_(sources), diagnostics_(diagnostics), used_(program.instructions.size()) {
    for (const InstructionId result : program.results) used_[result.index] = true;
    for (const Instruction& instruction : program.instructions) {
      if (instruction.other.valid()) used_[instruction.other.index] = true;
    }
    for (const Pin& pin : program.pins) {
      if (pin.result.valid()) used_[pin.result.index] = true;
    }
  }

  void Check(InstructionId id) {
    const Instruction& instruction = program_.instructions[id];
    if (instruction.unknown || instruction.faulty) return;
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      CheckOperand(program_.operands[instruction.operands.first + i], instruction);
    }
    if (instruction.op == Op::kTp) {
      const bool iec = program_.settings.tp == TpOption::kIec;
      diagnostics_.Report(instruction.range, diag::Host50TpEdge, iec ? "rising" : "falling");
    }
    if (instruction.op == Op::kRot && used_[id.index]) {
      const bool reverse = program_.settings.rotq == RotQOption::kReverse;
      diagnostics_.Report(instruction.range, diag::Host50RotDirection, reverse ? "reverse" : "forward");
    }
    if (instruction.op == Op::kEq || instruction.op == Op::kNe) CheckEquality(instruction);
    CheckSeries(id);
  }

 private:
  void CheckOperand(const Operand& operand, const Instruction& instruction) {
    const bool constant = operand.kind == OperandKind::kConstant;
    const bool divisor = operand.role == OperandRole::kIntDivisor || operand.role == OperandRole::kFloatDivisor;
    if (constant && divisor && IsZero(operand.type, operand.bits)) {
      diagnostics_.Report(operand.range, diag::Host50DivisionByZero);
    }
    if (constant && operand.role == OperandRole::kHomingMethod && !IsHomingMethod(static_cast<int32_t>(operand.bits))) {
      diagnostics_.Report(operand.range, diag::Host50HomingMethod, sources_.Text(operand.range));
    }
    if (operand.role == OperandRole::kTimer || operand.role == OperandRole::kCounter) {
      if (!instances_.emplace(operand.address.area, operand.address.number).second) {
        diagnostics_.Report(instruction.range, diag::Host50UsedTwice, ToText(operand.address));
      }
    }
    if (operand.kind == OperandKind::kExpression) CheckExpression(operand.expr);
  }

  void CheckExpression(ExprId id) {
    const Expr& expr = program_.exprs[id];
    for (const ExprId child : {expr.left, expr.right}) {
      if (child.valid()) CheckExpression(child);
    }
    if (expr.kind == ExprKind::kDivide) {
      const Expr& divisor = program_.exprs[expr.right];
      if (divisor.kind == ExprKind::kConstant && IsZero(divisor.type, divisor.bits)) {
        diagnostics_.Report(divisor.range, diag::Host50DivisionByZero);
      }
    }
    if (expr.kind != ExprKind::kEqual && expr.kind != ExprKind::kNotEqual) return;
    if (program_.exprs[expr.left].type == Type::kFloat || program_.exprs[expr.right].type == Type::kFloat) {
      diagnostics_.Report(expr.range, diag::Host50FloatEquality, expr.kind == ExprKind::kEqual ? "=" : "<>");
    }
  }

  /// W23. Back through the contacts in series with this one, as long as nothing between them could write the bit.
  void CheckSeries(InstructionId id) {
    constexpr uint32_t kMostContacts = 64;
    const Contact contact = Info(program_.instructions[id].op).contact;
    const Operand* own = ContactOf(id);
    if (own == nullptr || Info(program_.instructions[id].op).effect != RungEffect::kSeries) return;
    InstructionId at = id;
    for (uint32_t i = 0; i < kMostContacts; ++i) {
      const Instruction& instruction = program_.instructions[at];
      if (Info(instruction.op).effect != RungEffect::kSeries || instruction.input.kind != InputKind::kResults) return;
      if (instruction.input.results.count != 1) return;
      const InstructionId before = program_.results[instruction.input.results.first];
      if (before.index >= at.index || WritesBetween(before, at)) return;
      at = before;
      const Operand* other = ContactOf(at);
      if (other == nullptr) return;
      if (other->address == own->address && Info(program_.instructions[at].op).contact != contact) {
        diagnostics_.Report(program_.instructions[id].range, diag::Host50ContactsExclude, ToText(own->address))
            .notes.push_back({program_.instructions[at].range, "the other contact"});
        return;
      }
    }
  }

  /// The bit of a contact that is not an edge; none for anything else.
  const Operand* ContactOf(InstructionId id) const {
    const Instruction& instruction = program_.instructions[id];
    if (instruction.unknown || instruction.faulty || instruction.operands.count != 1) return nullptr;
    const InstructionInfo& info = Info(instruction.op);
    const bool series = info.effect == RungEffect::kSeries || info.effect == RungEffect::kLoad;
    if (!series || (info.contact != Contact::kPlain && info.contact != Contact::kInverted)) return nullptr;
    const Operand& operand = program_.operands[instruction.operands.first];
    return operand.kind == OperandKind::kAddress ? &operand : nullptr;
  }

  bool WritesBetween(InstructionId first, InstructionId last) const {
    for (uint32_t i = first.index + 1; i < last.index; ++i) {
      const RungEffect effect = Info(program_.instructions[InstructionId(i)].op).effect;
      const bool contact =
          effect == RungEffect::kSeries || effect == RungEffect::kLoad || effect == RungEffect::kParallel;
      if (!contact) return true;
    }
    return false;
  }

  void CheckEquality(const Instruction& instruction) {
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      if (program_.operands[instruction.operands.first + i].type != Type::kFloat) continue;
      diagnostics_.Report(instruction.range, diag::Host50FloatEquality, Info(instruction.op).name);
      return;
    }
  }

  const Program& program_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::vector<bool> used_;  // by instruction: something takes its result
  std::set<std::pair<Area, uint16_t>> instances_;
};

}  // namespace

void CheckInstructions(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  InstructionChecks checks(program, sources, diagnostics);
  for (uint32_t i = 0; i < program.instructions.size(); ++i) checks.Check(InstructionId(i));
}

}  // namespace plcxx::host50
