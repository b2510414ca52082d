// The syntax tree of dialect @name@: statements in the order of the sources.
#pragma once

#include <vector>

#include "transpiler/dialects/@name@/machine/machine.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::@name@ {

using StatementId = support::Id<struct StatementTag>;

struct Statement {
  Instruction instruction = Instruction::kUnsupported;  // then it was reported
  source::Range range;                                  // with its operands, without the comment
};

struct SourceFile {
  source::FileId file;
  StatementId first;
  uint32_t count = 0;
};

struct Program {
  std::vector<SourceFile> files;
  support::Store<StatementId, Statement> statements;
  uint32_t line_count = 0;
};

}  // namespace plcxx::@name@
