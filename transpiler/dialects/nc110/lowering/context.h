// What every part of the lowering works on: the tree, the program that is made, and where in both it is.
#pragma once

#include "transpiler/dialects/common/translation.h"
#include "transpiler/dialects/nc110/machine/machine.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"

namespace plcxx::nc110 {

enum class Part : uint8_t { kFast, kSlow };

/// One tree on its way to a program.
struct Translation : dialects::TranslationFrame<Program, Settings> {
  Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files);

  Part part = Part::kFast;  // the one that is lowered
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context : protected dialects::ContextFrame<Program, Settings> {
 public:
  explicit Context(Translation& translation);

 protected:
  bool sliced() const { return settings_.slices > 1 || settings_.slices_by_cost; }
  ir::ValueId Byte(uint32_t value) const { return builder_.Constant(ir::Type::kI8, value); }

  Part& part_;
};

/// One number for each operand, I and U told apart.
constexpr uint32_t KeyOf(const Operand& operand) {
  return static_cast<uint32_t>(operand.kind) << 26 | static_cast<uint32_t>(operand.package) << 24 |
         static_cast<uint32_t>(operand.number) << 8 | operand.index;
}

}  // namespace plcxx::nc110
