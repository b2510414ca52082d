// The flags of the assembler instructions: computed where some path reads them, else not at all (specification 6.9).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Flags : Context {
 public:
  explicit Flags(const Context& context) : Context(context) {}

  ir::ValueId Value(Resources flag) { return registers_.Flag(flag).Get(); }
  /// The flag becomes what `compute` builds.
  template <class Compute>
  void Set(Resources flag, Compute&& compute);
  /// The same, but it stays as it was where `count` is 0.
  template <class Compute>
  void SetUnlessZero(Resources flag, ir::ValueId count, Compute&& compute);
  /// Zero and sign.
  void SetResult(ir::ValueId result, uint32_t width);
  /// Where somebody looks at an undefined flag all the same (a count of 0 in CL keeps it), it is 0 (D41).
  void Undefine(Resources flags);
  ir::ValueId SignOf(ir::ValueId value, uint32_t width);
  ir::ValueId IsZero(ir::ValueId value, uint32_t width);

 private:
  /// Is the flag read on some path after the instruction?
  bool IsWanted(Resources flag) const { return (frame_.wanted_flags & flag) != 0; }
};

template <class Compute>
void Flags::Set(Resources flag, Compute&& compute) {
  dialects::Register& reg = registers_.Flag(flag);
  if (IsWanted(flag)) {
    reg.Set(compute());
  } else {
    reg.Forget();
  }
}

template <class Compute>
void Flags::SetUnlessZero(Resources flag, ir::ValueId count, Compute&& compute) {
  if (!IsWanted(flag)) return Set(flag, compute);
  const ir::ValueId old = Value(flag);
  const ir::ValueId moves = Pure(ir::OpKind::kNotEqual32, {count, builder_.Number(0)});
  const ir::ValueId changed = Pure(ir::OpKind::kBitAnd, {moves, compute()});
  const ir::ValueId kept = Pure(ir::OpKind::kBitAnd, {builder_.Not(moves), old});
  Set(flag, [&] { return Pure(ir::OpKind::kBitOr, {changed, kept}); });
}

}  // namespace plcxx::technol
