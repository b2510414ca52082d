// Choices that GCC computes as a shift: of x & 0x100 ? 128 : 0 it makes (x >> 1) & 128 before it looks at types, and
// warns that the int might not fit into a byte (-Wconversion). Such a choice is given its type by the printer.

#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {
namespace {

std::optional<uint64_t> Constant(const ir::Program& program, uint32_t value) {
  const ir::Inst& inst = program[ir::ValueId(value)];
  if (inst.op == ir::OpKind::kConst) return ir::ConstantValue(inst);
  if (inst.op != ir::OpKind::kMinus16 && inst.op != ir::OpKind::kMinus32) return std::nullopt;
  const std::optional<uint64_t> minus = Constant(program, inst.a);
  if (!minus) return std::nullopt;
  const uint64_t mask = inst.op == ir::OpKind::kMinus16 ? 0xFFFF : 0xFFFFFFFF;
  return (mask + 1 - *minus) & mask;
}

/// The bit of a number of 16 or 32 bits that a comparison looks at; 0: at more than one.
uint64_t BitOf(const Emittable& emittable, const ir::Inst& comparison) {
  const ir::Program& program = *emittable.program;
  if (ir::Info(comparison.op).shape != ir::Shape::kPure || comparison.type != ir::Type::kBit) return 0;
  const ir::Precedence precedence = ir::Info(comparison.op).precedence;
  if (precedence != ir::Precedence::kRelational && precedence != ir::Precedence::kEquality) return 0;
  const ir::Type type = program[ir::ValueId(comparison.a)].type;
  if (type != ir::Type::kI16 && type != ir::Type::kI32) return 0;
  const uint64_t highest = type == ir::Type::kI16 ? 0x8000 : 0x80000000, all = 2 * highest - 1;
  const std::optional<uint64_t> left = Constant(program, comparison.a), right = Constant(program, comparison.b);
  if (left.has_value() == right.has_value()) return 0;
  const uint64_t limit = left ? *left : *right;
  if (precedence == ir::Precedence::kRelational) {
    // "x < 0", "x >= 0", "0 > x", "0 <= x": the limit is the first number on its side; else it is the last one.
    const std::string_view spelling = ir::Info(comparison.op).spelling;
    const bool excludes =
        spelling.find(" < ") != std::string_view::npos || spelling.find(" >= ") != std::string_view::npos;
    const bool is_first = excludes != left.has_value();
    const uint64_t first = spelling.front() == 'S' ? 0 : highest;
    return limit == (is_first ? first : (first - 1) & all) ? highest : 0;
  }
  const ir::ValueId other(left ? comparison.b : comparison.a);
  const ir::Inst& inst = program[other];
  const bool is_and = inst.op == ir::OpKind::kAnd16 || inst.op == ir::OpKind::kAnd32;
  if (limit != 0 || !is_and || emittable.forms[other.index] == Form::kLocal) return 0;
  const std::optional<uint64_t> first = Constant(program, inst.a), second = Constant(program, inst.b);
  const uint64_t mask = first ? *first : second.value_or(0);
  return std::has_single_bit(mask) ? mask : 0;
}

}  // namespace

bool IsChoiceByOneBit(const Emittable& emittable, const ir::Inst& choice) {
  const ir::Program& program = *emittable.program;
  if (choice.op != ir::OpKind::kSelect8 && choice.op != ir::OpKind::kSelect16) return false;
  const std::optional<uint64_t> first = Constant(program, choice.b), second = Constant(program, choice.c);
  if (!first || !second || !std::has_single_bit(*first) || *second != 0) return false;
  ir::ValueId condition(choice.a);
  if (emittable.forms[condition.index] == Form::kLocal) return false;
  while (program[condition].op == ir::OpKind::kBitNot) {
    condition = ir::ValueId(program[condition].a);
    if (emittable.forms[condition.index] == Form::kLocal) return false;
  }
  const uint64_t bit = BitOf(emittable, program[condition]);
  // What the sign alone shifted to bit 0 gives is seen to fit where it was a word's.
  return bit != 0 && (*first != 1 || bit == 0x80000000);
}

}  // namespace plcxx::emit::print
