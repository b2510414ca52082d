// DOF ... ENDF DOE ... ENDE as nested If, DOW ... ENDW as a guarded Loop.
//
//   DOF: a  ... ENDF           if a { ... }
//   DOE: b  ... ENDE     ->    else { if b { ... } else { if 1 { ... } } }
//   DOE:    ... ENDE
//
// The condition of a DOE is computed in the else region right before its If, so it is evaluated only where 6.8 says.
// The end of a block is the last statement inside it, so that its comments are printed there.
#pragma once

#include <vector>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Expressions;
class Faults;
class StatementWriter;

class Blocks : Context {
 public:
  Blocks(const Context& context, Expressions& expressions, Faults& faults, StatementWriter& statements)
      : Context(context), expressions_(expressions), faults_(faults), statements_(statements) {}

  void Head(ItemId id);
  void End(ItemId id);
  /// What still waits for the next member of a chain, or is open, is over.
  void LeaveChain();
  void CloseAll();

 private:
  struct OpenBlock {
    BlockId block;
    ir::RegionId behind;  // where the program goes on after the whole chain
    ir::RegionId otherwise;
  };

  void Loop(const Block& block, ir::StatementId statement);

  Expressions& expressions_;
  Faults& faults_;
  StatementWriter& statements_;
  std::vector<OpenBlock> open_;
  OpenBlock waiting_;  // closed, its chain goes on; block none: nothing waits
};

}  // namespace plcxx::nc110
