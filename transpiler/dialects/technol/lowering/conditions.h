// The conditions of the assembler's jumps (specification 6.9).
//
// A difference is remembered as what it compares, so that the jump after it becomes a comparison, and its flags need
// not be computed:
//
//   CMP AX,BX        if (ax < bx) goto L3;     instead of     sf = ...; of = ...;
//   JL  LESS                                                  if (sf ^ of) goto L3;
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Flags;

/// Below and above without a sign, less and greater with one.
enum class Relation : uint8_t {
  kEqual,
  kNotEqual,
  kBelow,
  kNotBelow,
  kBelowOrEqual,
  kAbove,
  kLess,
  kNotLess,
  kLessOrEqual,
  kGreater,
};

class Conditions : Context {
 public:
  Conditions(const Context& context, Flags& flags) : Context(context), flags_(flags) {}

  /// What the flags hold is the difference of both.
  void Remember(ir::ValueId left, ir::ValueId right, uint32_t width);
  void Forget() { compared_ = {}; }
  /// Of what was compared last: by the remembered values, else by the flags.
  ir::ValueId Holds(Relation relation);

 private:
  ir::ValueId HoldsOfValues(Relation relation);
  ir::ValueId HoldsOfFlags(Relation relation);

  Flags& flags_;
  /// What the last difference or logic operation of this statement compared.
  struct {
    ir::ValueId left, right;  // none: nothing
    uint32_t width = 0;
  } compared_;
};

}  // namespace plcxx::technol
