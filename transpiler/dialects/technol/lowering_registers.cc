// RLO, registers and flags while a routine is lowered: values of the IR, put together from their parts and taken apart
// again without computing anything (specification 5.6, 6.9).

#include "transpiler/dialects/technol/lowering_internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr std::string_view kFlagNames[kFlagCount] = {"cf", "zf", "sf", "of", "af"};
constexpr std::string_view kNarrowNames[kWholeRegisters] = {"ax", "bx", "dr", "dx", "si", "di"};
constexpr std::string_view kWideNames[kWholeRegisters] = {"eax", "ebx", "dr", "edx", "esi", "edi"};

}  // namespace

void Lowering::BeginRegisters() {
  rlo_.emplace(builder_, Local("rlo", Type::kBit), facts_);
  for (uint32_t i = 0; i < kFlagCount; ++i) flags_[i].emplace(builder_, Local(kFlagNames[i], Type::kBit), facts_);
  for (uint32_t i = 0; i < kWholeRegisters; ++i) {
    registers_[i].emplace(
        builder_, Local(wide_[i] ? kWideNames[i] : kNarrowNames[i], wide_[i] ? Type::kI32 : Type::kI16), facts_);
  }
}

void Lowering::ZeroRegisters() {
  rlo_->Set(builder_.Bit(0));
  for (auto& flag : flags_) flag->Set(builder_.Bit(0));
  for (uint32_t i = 0; i < kWholeRegisters; ++i) registers_[i]->Set(Constant(0, wide_[i] ? 32 : 16));
}

void Lowering::SpillAll() {
  ForEachRegister([](dialects::Register& reg) { reg.Spill(); });
}

void Lowering::ForgetAll() {
  ForEachRegister([](dialects::Register& reg) { reg.Forget(); });
}

void Lowering::EndStatementOfAll() {
  ForEachRegister([](dialects::Register& reg) { reg.EndStatement(); });
}

uint32_t Lowering::WidthOf(ValueId value) const { return 8 * ir::Bytes(program_[value].type); }

std::optional<uint64_t> Lowering::KnownValue(ValueId value) const {
  const ir::Inst& inst = program_[value];
  if (inst.op != OpKind::kConst) return std::nullopt;
  return ir::ConstantValue(inst);
}

ValueId Lowering::Low16(ValueId value) {
  const ir::Inst inst = program_[value];
  switch (inst.op) {
    case OpKind::kConst:
      return builder_.Constant(Type::kI16, ir::ConstantValue(inst) & 0xFFFF, inst.c);
    case OpKind::kWiden16To32:
    case OpKind::kSignExtend16To32:
    case OpKind::kPair32:
      return ValueId(inst.a);
    case OpKind::kWiden8To32:
      return Pure(OpKind::kWiden8To16, {ValueId(inst.a)});
    case OpKind::kSignExtend8To32:
      return Pure(OpKind::kSignExtend8To16, {ValueId(inst.a)});
    default:
      return Pure(OpKind::kLowHalf32, {value});
  }
}

ValueId Lowering::High16(ValueId value) {
  const ir::Inst inst = program_[value];
  switch (inst.op) {
    case OpKind::kConst:
      return builder_.Constant(Type::kI16, ir::ConstantValue(inst) >> 16 & 0xFFFF, inst.c);
    case OpKind::kWiden16To32:
    case OpKind::kWiden8To32:
      return Constant(0, 16);
    case OpKind::kPair32:
      return ValueId(inst.b);
    default:
      return Pure(OpKind::kHighHalf32, {value});
  }
}

ValueId Lowering::Low8(ValueId value) {
  const ir::Inst inst = program_[value];
  switch (inst.op) {
    case OpKind::kConst:
      return builder_.Constant(Type::kI8, ir::ConstantValue(inst) & 0xFF, inst.c);
    case OpKind::kWiden8To16:
    case OpKind::kSignExtend8To16:
    case OpKind::kPair16:
      return ValueId(inst.a);
    case OpKind::kWithLowByte16:
      return ValueId(inst.b);
    default:
      return Pure(OpKind::kLowByte16, {value});
  }
}

ValueId Lowering::High8(ValueId value) {
  const ir::Inst inst = program_[value];
  switch (inst.op) {
    case OpKind::kConst:
      return builder_.Constant(Type::kI8, ir::ConstantValue(inst) >> 8 & 0xFF, inst.c);
    case OpKind::kWiden8To16:
      return Byte(0);
    case OpKind::kPair16:
      return ValueId(inst.b);
    case OpKind::kWithLowByte16:
      return High8(ValueId(inst.a));
    default:
      return Pure(OpKind::kHighByte16, {value});
  }
}

ValueId Lowering::ToWidth(ValueId value, uint32_t width) {
  const uint32_t from = WidthOf(value);
  if (from == width) return value;
  if (const auto known = KnownValue(value)) return Constant(*known, width, program_[value].c);
  if (from == 32) return width == 16 ? Low16(value) : Low8(Low16(value));
  if (from == 16) return width == 8 ? Low8(value) : Pure(OpKind::kWiden16To32, {value});
  return Pure(width == 16 ? OpKind::kWiden8To16 : OpKind::kWiden8To32, {value});
}

ValueId Lowering::SignedTo32(ValueId value) {
  switch (WidthOf(value)) {
    case 8:
      return Pure(OpKind::kSignExtend8To32, {value});
    case 16:
      return Pure(OpKind::kSignExtend16To32, {value});
    default:
      return value;
  }
}

ValueId Lowering::ReadRegister(Register reg) {
  const RegisterInfo& info = Info(reg);
  const uint32_t number = WholeIndex(reg);
  const ValueId whole = registers_[number]->Get();
  if (info.width == 32) return ToWidth(whole, 32);
  const ValueId word = wide_[number] ? Low16(whole) : whole;
  if (info.width == 16) return word;
  return info.shift == 0 ? Low8(word) : High8(word);
}

/// A part leaves the rest as it is (6.9).
void Lowering::WriteRegister(Register reg, ValueId value) {
  const RegisterInfo& info = Info(reg);
  const uint32_t number = WholeIndex(reg);
  dialects::Register& whole = *registers_[number];
  if (info.width == 32) return whole.Set(ToWidth(value, wide_[number] ? 32 : 16));
  ValueId word = value;
  if (info.width == 8) {
    const ValueId old = wide_[number] ? Low16(whole.Get()) : whole.Get();
    const ValueId low = info.shift == 0 ? value : Low8(old), high = info.shift == 0 ? High8(old) : value;
    if (KnownValue(high) == 0) {
      word = ToWidth(low, 16);
    } else if (info.shift == 0 && program_[high].op == OpKind::kHighByte16) {
      word = Pure(OpKind::kWithLowByte16, {ValueId(program_[high].a), low});
    } else {
      word = Pure(OpKind::kPair16, {low, high});
    }
  }
  if (!wide_[number]) return whole.Set(word);
  const ValueId high = High16(whole.Get());
  whole.Set(KnownValue(high) == 0 ? ToWidth(word, 32) : Pure(OpKind::kPair32, {word, high}));
}

}  // namespace plcxx::technol
