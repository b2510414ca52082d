// What every part of the lowering works on: the tree, and the program that is made of it.
#pragma once

#include "transpiler/dialects/classicladder/machine/options.h"
#include "transpiler/dialects/classicladder/syntax/syntax.h"
#include "transpiler/dialects/common/translation.h"

namespace plcxx::classicladder {

using Translation = dialects::TranslationFrame<Program, Settings>;

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context : protected dialects::ContextFrame<Program, Settings> {
 public:
  explicit Context(Translation& translation) : ContextFrame(translation) {}

 protected:
  ir::ValueId Word(uint32_t value) const { return builder_.Constant(ir::Type::kI32, value); }
};

}  // namespace plcxx::classicladder
