#include "transpiler/dialects/host50/analysis/accesses.h"

#include <algorithm>

namespace plcxx::host50 {
namespace {

class Collector {
 public:
  explicit Collector(const Program& program) : program_(program) {}

  std::vector<Access> Run() {
    for (uint32_t i = 0; i < program_.instructions.size(); ++i) {
      current_ = InstructionId(i);
      AddInstruction(program_.instructions[current_]);
    }
    // Those of a drawing stand in the order of their execution.
    std::ranges::stable_sort(accesses_, {}, [](const Access& access) { return access.range.begin; });
    return std::move(accesses_);
  }

 private:
  void AddInstruction(const Instruction& instruction) {
    uint32_t bits = 1;
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      const Operand& operand = program_.operands[instruction.operands.first + i];
      if (operand.kind == OperandKind::kCount) bits = operand.bits;
    }
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      const Operand& operand = program_.operands[instruction.operands.first + i];
      if (operand.kind == OperandKind::kExpression) AddExpression(operand.expr);
      if (operand.kind != OperandKind::kAddress) continue;
      const bool field = operand.role == OperandRole::kFieldSource || operand.role == OperandRole::kFieldResult;
      if (Reads(operand.role)) Add(Access::Kind::kRead, operand.address, field ? bits : 1, operand.range);
      if (Writes(operand.role)) Add(Access::Kind::kWrite, operand.address, field ? bits : 1, operand.range);
    }
    for (uint32_t i = 0; i < instruction.pins.count; ++i) {
      const Operand& operand = program_.pins[instruction.pins.first + i].operand;
      if (operand.kind == OperandKind::kAddress) Add(Access::Kind::kRead, operand.address, 1, operand.range);
    }
  }

  void AddExpression(ExprId id) {
    const Expr& expr = program_.exprs[id];
    if (expr.kind == ExprKind::kAddress) Add(Access::Kind::kRead, expr.address, 1, expr.range);
    if (expr.left.valid()) AddExpression(expr.left);
    if (expr.right.valid()) AddExpression(expr.right);
  }

  void Add(Access::Kind kind, const Address& address, uint32_t bits, source::Range range) {
    accesses_.push_back({.kind = kind, .instruction = current_, .address = address, .bits = bits, .range = range});
  }

  const Program& program_;
  InstructionId current_;
  std::vector<Access> accesses_;
};

}  // namespace

std::vector<Access> AccessesOf(const Program& program) { return Collector(program).Run(); }

}  // namespace plcxx::host50
