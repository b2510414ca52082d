#include "transpiler/dialects/technol/lowering/register_file.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr std::string_view kFlagNames[kFlagCount] = {"cf", "zf", "sf", "of", "af"};
constexpr std::string_view kNarrowNames[kWholeRegisters] = {"ax", "bx", "dr", "dx", "si", "di"};
constexpr std::string_view kWideNames[kWholeRegisters] = {"eax", "ebx", "dr", "edx", "esi", "edi"};

}  // namespace

void RegisterFile::Begin(const std::function<ir::PlaceId(std::string_view, Type)>& local) {
  rlo_.emplace(builder_, local("rlo", Type::kBit), facts_);
  for (uint32_t i = 0; i < kFlagCount; ++i) flags_[i].emplace(builder_, local(kFlagNames[i], Type::kBit), facts_);
  for (uint32_t i = 0; i < kWholeRegisters; ++i) {
    registers_[i].emplace(
        builder_, local(wide_[i] ? kWideNames[i] : kNarrowNames[i], wide_[i] ? Type::kI32 : Type::kI16), facts_);
  }
}

void RegisterFile::Zero() {
  rlo_->Set(builder_.Bit(0));
  for (auto& flag : flags_) flag->Set(builder_.Bit(0));
  for (uint32_t i = 0; i < kWholeRegisters; ++i) registers_[i]->Set(builder_.Constant(0, WidthOf(i)));
}

template <class Visit>
void RegisterFile::ForEach(Visit&& visit) {
  visit(*rlo_);
  for (auto& flag : flags_) visit(*flag);
  for (auto& reg : registers_) visit(*reg);
}

void RegisterFile::Spill() {
  ForEach([](dialects::Register& reg) { reg.Spill(); });
}

void RegisterFile::Forget() {
  ForEach([](dialects::Register& reg) { reg.Forget(); });
}

void RegisterFile::EndStatement() {
  ForEach([](dialects::Register& reg) { reg.EndStatement(); });
}

dialects::Register& RegisterFile::Flag(Resources flag) {
  uint32_t number = 0;
  while (kCf << number != flag) ++number;
  return *flags_[number];
}

void RegisterFile::WriteWhole(Register reg, ValueId value) {
  const uint32_t number = WholeIndex(reg);
  registers_[number]->Set(builder_.ToWidth(value, WidthOf(number)));
}

ValueId RegisterFile::Read(Register reg) {
  const RegisterInfo& info = Info(reg);
  const uint32_t number = WholeIndex(reg);
  const ValueId whole = registers_[number]->Get();
  if (info.width == 32) return builder_.ToWidth(whole, 32);
  const ValueId word = wide_[number] ? builder_.Low16(whole) : whole;
  if (info.width == 16) return word;
  return info.shift == 0 ? builder_.Low8(word) : builder_.High8(word);
}

void RegisterFile::Write(Register reg, ValueId value) {
  const RegisterInfo& info = Info(reg);
  const uint32_t number = WholeIndex(reg);
  dialects::Register& whole = *registers_[number];
  if (info.width == 32) return whole.Set(builder_.ToWidth(value, WidthOf(number)));
  ValueId word = value;
  if (info.width == 8) {
    const ValueId old = wide_[number] ? builder_.Low16(whole.Get()) : whole.Get();
    const ValueId low = info.shift == 0 ? value : builder_.Low8(old),
                  high = info.shift == 0 ? builder_.High8(old) : value;
    if (builder_.KnownValue(high) == 0) {
      word = builder_.ToWidth(low, 16);
    } else if (info.shift == 0 && builder_.program()[high].op == OpKind::kHighByte16) {
      word = builder_.Pure(OpKind::kWithLowByte16, {ValueId(builder_.program()[high].a), low});
    } else {
      word = builder_.Pure(OpKind::kPair16, {low, high});
    }
  }
  if (!wide_[number]) return whole.Set(word);
  const ValueId high = builder_.High16(whole.Get());
  whole.Set(builder_.KnownValue(high) == 0 ? builder_.ToWidth(word, 32) : builder_.Pure(OpKind::kPair32, {word, high}));
}

}  // namespace plcxx::technol
