// A rung is a statement.
#pragma once

#include <string>

#include "transpiler/dialects/classicladder/lowering/context.h"
#include "transpiler/dialects/classicladder/lowering/names.h"
#include "transpiler/dialects/common/statement_ids.h"

namespace plcxx::classicladder {

class StatementWriter : Context {
 public:
  StatementWriter(const Context& context, const Names& names) : Context(context), names_(names) {}

  /// Its rows down to the last one that has something.
  void Begin(const Rung& rung);
  /// A sequential page.
  void Begin(const Section& page);

 private:
  /// Of the first coil or block.
  std::string SubjectOf(const Rung& rung) const;

  const Names& names_;
  dialects::StatementIds ids_;
};

}  // namespace plcxx::classicladder
