// S, AX, and with first-check=dynamic whether the next operation is the first of a sequence, while a module is lowered.
#pragma once

#include <optional>

#include "transpiler/dialects/common/register.h"
#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Scalars;

class Registers : Context {
 public:
  Registers(const Context& context, Scalars& scalars) : Context(context), scalars_(scalars) {}

  /// What a module's registers hold at first is in their places.
  void BeginModule();
  dialects::Register& s() { return *s_; }
  dialects::Register& ax() { return *ax_; }
  /// None: the text decides.
  dialects::Register* first() { return first_ ? &*first_ : nullptr; }
  /// AL; AL replaced, AH as it was.
  ir::ValueId LowByte();
  void SetLowByte(ir::ValueId byte);

  void Spill();
  void Forget();
  void EndStatement();

 private:
  Scalars& scalars_;
  std::optional<dialects::Register> s_, ax_, first_;
};

}  // namespace plcxx::prostep
