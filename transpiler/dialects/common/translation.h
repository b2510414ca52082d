// One tree on its way to a program, as every dialect's lowering has it: what is read, what is made, and with what.
//
// A dialect adds where in both it is (a struct Translation and a class Context of its own), and its collaborators,
// which are given the context and each other.
#pragma once

#include "transpiler/dialects/common/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::dialects {

template <class Tree, class Settings, class ProgramBuilder = Builder>
struct TranslationFrame {
  TranslationFrame(const Tree& program_tree, const Settings& options, const source::SourceManager& files)
      : tree(program_tree), settings(options), sources(files) {}

  const Tree& tree;
  const Settings& settings;
  const source::SourceManager& sources;
  ir::Program program;
  ProgramBuilder builder{program};
  ir::FactChecks facts{builder};
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
template <class Tree, class Settings, class ProgramBuilder = Builder>
class ContextFrame {
 protected:
  explicit ContextFrame(TranslationFrame<Tree, Settings, ProgramBuilder>& translation)
      : tree_(translation.tree),
        settings_(translation.settings),
        sources_(translation.sources),
        program_(translation.program),
        builder_(translation.builder),
        facts_(translation.facts) {}

  const Tree& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program& program_;
  ProgramBuilder& builder_;
  ir::FactChecks& facts_;
};

/// What the collaborators of a lowering are made with; they are members of the dialect's class.
template <class Translation, class Context>
class LoweringFrame {
 public:
  template <class Tree, class Settings>
  LoweringFrame(const Tree& tree, const Settings& settings, const source::SourceManager& sources)
      : translation_(tree, settings, sources) {}

 protected:
  Translation translation_;
  Context context_{translation_};
};

}  // namespace plcxx::dialects
