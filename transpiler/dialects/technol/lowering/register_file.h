// RLO, the flags and the registers while a routine is lowered (specification 5.6, 6.9): values of the IR until a path
// needs them in memory.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "transpiler/dialects/common/register.h"
#include "transpiler/dialects/technol/analysis/effects.h"
#include "transpiler/dialects/technol/lowering/value_builder.h"

namespace plcxx::technol {

class RegisterFile {
 public:
  RegisterFile(ValueBuilder& builder, ir::FactChecks& facts) : builder_(builder), facts_(facts) {}

  /// Before the first routine: the register is used with its upper half.
  void MakeWide(Register reg) { wide_[WholeIndex(reg)] = true; }
  /// Of a new routine. `local(name, type)`: where a register is kept.
  void Begin(const std::function<ir::PlaceId(std::string_view, ir::Type)>& local);
  void Zero();

  dialects::Register& rlo() { return *rlo_; }
  /// The only flag of the set.
  dialects::Register& Flag(Resources flag);
  ir::ValueId Read(Register reg);
  /// A part leaves the rest as it is (6.9).
  void Write(Register reg, ir::ValueId value);
  /// All that it has of its 32 bits, 16 or 32 wide.
  ir::ValueId ReadWhole(Register reg) { return registers_[WholeIndex(reg)]->Get(); }
  void WriteWhole(Register reg, ir::ValueId value);

  void Spill();
  void Forget();
  void EndStatement();
  /// Choose, where the arms set registers.
  template <class Then, class Otherwise>
  void Split(ir::ValueId condition, Then&& run, Otherwise&& otherwise);

 private:
  template <class Visit>
  void ForEach(Visit&& visit);
  uint32_t WidthOf(uint32_t number) const { return wide_[number] ? 32 : 16; }

  ValueBuilder& builder_;
  ir::FactChecks& facts_;
  std::array<bool, kWholeRegisters> wide_{};
  std::optional<dialects::Register> rlo_;
  std::array<std::optional<dialects::Register>, kFlagCount> flags_;
  std::array<std::optional<dialects::Register>, kWholeRegisters> registers_;
};

template <class Then, class Otherwise>
void RegisterFile::Split(ir::ValueId condition, Then&& run, Otherwise&& otherwise) {
  Spill();
  Forget();
  const auto arm = [this](auto&& body) {
    body();
    Spill();
    Forget();
  };
  builder_.Choose(condition, [&] { arm(run); }, [&] { arm(otherwise); });
}

}  // namespace plcxx::technol
