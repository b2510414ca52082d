#include "transpiler/dialects/hnc/lowering/context.h"

#include <string>

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

Types::Types(const Unit& unit) : types_(unit.types) {}

TypeId Types::Integer(uint8_t bits, bool is_signed) {
  for (uint32_t i = 0; i < types_.size(); ++i) {
    const Type& type = types_[TypeId(i)];
    if (type.kind == TypeKind::kInteger && type.bits == bits && type.is_signed == is_signed) return TypeId(i);
  }
  return types_.Add({.kind = TypeKind::kInteger,
                     .bits = bits,
                     .is_signed = is_signed,
                     .element = {},
                     .count = 0,
                     .record = {},
                     .size = bits / 8u,
                     .text = std::string(is_signed ? "" : "unsigned ") + (bits == 8    ? "char"
                                                                          : bits == 16 ? "int"
                                                                                       : "long")});
}

TypeId Types::Double() {
  TypeId last;
  for (uint32_t i = 0; i < types_.size(); ++i) {
    if (types_[TypeId(i)].kind == TypeKind::kReal && types_[TypeId(i)].bits == 64) last = TypeId(i);
  }
  return last.valid() ? last : types_.Add({.kind = TypeKind::kReal, .bits = 64, .size = 8, .text = "double"});
}

Context::Context(Translation& translation)
    : unit_(translation.unit),
      settings_(translation.settings),
      sources_(translation.sources),
      diagnostics_(translation.diagnostics),
      program_(translation.program),
      builder_(translation.builder),
      objects_(translation.objects),
      facts_(translation.facts),
      types_(translation.types),
      flow_(translation.flow),
      statement_(translation.statement),
      frame_(translation.frame),
      placement_(translation.placement),
      int_(types_.Integer(16, true)),
      unsigned_(types_.Integer(16, false)),
      long_(types_.Integer(32, true)),
      unsigned_long_(types_.Integer(32, false)),
      double_(types_.Double()) {}

ir::Type Context::IrType(TypeId id) const {
  const Type& type = TypeAt(id);
  if (type.kind == TypeKind::kReal) return type.bits == 32 ? ir::Type::kF32 : ir::Type::kF64;
  if (type.kind == TypeKind::kPointer || type.bits == 32) return ir::Type::kI32;
  return type.bits == 8 ? ir::Type::kI8 : ir::Type::kI16;
}

std::optional<int64_t> Context::KnownInteger(const Value& value) const {
  if (TypeAt(value.type).kind != TypeKind::kInteger) return std::nullopt;
  const ir::Inst& inst = program_[value.id];
  const bool minus = inst.op == OpKind::kMinus16 || inst.op == OpKind::kMinus32;
  const bool constant = inst.op == OpKind::kConst || (minus && program_[ValueId(inst.a)].op == OpKind::kConst);
  if (!constant || !value.bounds.IsOne()) return std::nullopt;
  return value.bounds.low;
}

bool Context::HasEffects(ExprId id) const {
  bool found = false;
  ForEachExpr(unit_, id, [&](ExprId part) {
    const ExprKind kind = ExprAt(part).kind;
    found = found || kind == ExprKind::kAssign || kind == ExprKind::kCompoundAssign || kind == ExprKind::kIncrement ||
            kind == ExprKind::kCall;
  });
  return found;
}

bool Context::IsSimple(ExprId id) const {
  bool simple = true;
  ForEachExpr(unit_, id, [&](ExprId part) {
    const Expr& expr = ExprAt(part);
    switch (expr.kind) {
      case ExprKind::kIndex:
      case ExprKind::kDereference:
        if (!facts_.AddressOf(part)) simple = false;
        break;
      case ExprKind::kBinary:
        if (expr.binary == BinaryOp::kDivide || expr.binary == BinaryOp::kRemainder) {
          const Expr& divisor = ExprAt(expr.b);
          if (!divisor.constant || divisor.constant->integer == 0 || divisor.constant->integer == -1) simple = false;
        }
        break;
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement:
      case ExprKind::kCall:
        simple = false;
        break;
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kVariable:
      case ExprKind::kFunction:
      case ExprKind::kLoad:
      case ExprKind::kDecay:
      case ExprKind::kConvert:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kUnary:
      case ExprKind::kAnd:
      case ExprKind::kOr:
      case ExprKind::kConditional:
      case ExprKind::kComma:
      case ExprKind::kAddress:
      case ExprKind::kMember:
        break;
    }
  });
  return simple;
}

}  // namespace plcxx::hnc
