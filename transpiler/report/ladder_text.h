// Values as text, for words in boxes and for what has no shape of its own: "TNOW + 1", "BCD(W4K0)".
#pragma once

#include <string>
#include <vector>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

/// A word of an instruction that it has not.
inline constexpr uint32_t kNoWord = support::Id<void>::kNone;

class ValueText {
 public:
  explicit ValueText(const ProgramInput& input);

  /// A value where it is used: a local by its name.
  std::string Of(ir::ValueId value) const;
  /// What a local's name stands for; the same as Of for a value without one.
  std::string Definition(ir::ValueId value) const;
  /// "homing[a]": a place as the source names it; its address where the name is that made safe for C++.
  std::string Place(ir::PlaceId place, ir::ValueId index) const;
  /// The arguments of a call, ", " between them.
  std::string Arguments(const ir::Call& call) const;

  /// Is it kept under a name: by generated code, or because several read it?
  bool IsLocal(ir::ValueId value) const;
  std::string LocalName(ir::ValueId value) const;
  bool IsUsed(ir::ValueId value) const { return uses_[value.index] != 0; }

 private:
  struct Spelled {
    std::string text;
    int binding;  // the weakest operator outside of parentheses; the tightest is 0
  };
  Spelled Spell(ir::ValueId value) const;
  Spelled SpellDefinition(ir::ValueId value) const;
  Spelled SpellPure(const ir::Inst& inst) const;

  const ProgramInput& input_;
  const ir::Program& program_;
  std::vector<uint8_t> uses_;  // by InstId, saturating
};

/// "=" for eq.i8, "<" for slt.i16, ...; none: the operation is no comparison of two values.
const char* ComparisonSign(ir::OpKind op);
/// Of the opposite comparison: "\u2260" for eq.i8; none where it is not exact (floats).
const char* OppositeSign(ir::OpKind op);

}  // namespace plcxx::report
