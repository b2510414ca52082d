// What every part of the lowering works on: the tree, the program that is made, and where in both it is.
#pragma once

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/nc110/machine.h"
#include "transpiler/dialects/nc110/options.h"
#include "transpiler/dialects/nc110/syntax.h"
#include "transpiler/ir/facts.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

enum class Part : uint8_t { kFast, kSlow };

/// One tree on its way to a program.
struct Translation {
  Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files);

  const Program& tree;
  const Settings& settings;
  const source::SourceManager& sources;
  ir::Program program;
  dialects::Builder builder{program};
  ir::FactChecks facts{builder};
  Part part = Part::kFast;  // the one that is lowered
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context {
 public:
  explicit Context(Translation& translation);

 protected:
  bool sliced() const { return settings_.slices > 1 || settings_.slices_by_cost; }
  ir::ValueId Byte(uint32_t value) const { return builder_.Constant(ir::Type::kI8, value); }

  const Program& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program& program_;
  dialects::Builder& builder_;
  ir::FactChecks& facts_;
  Part& part_;
};

/// One number for each operand, I and U told apart.
constexpr uint32_t KeyOf(const Operand& operand) {
  return static_cast<uint32_t>(operand.kind) << 26 | static_cast<uint32_t>(operand.package) << 24 |
         static_cast<uint32_t>(operand.number) << 8 | operand.index;
}

}  // namespace plcxx::nc110
