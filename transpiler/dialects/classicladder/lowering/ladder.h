// Sections of rungs: column by column, each element where it stands.
#pragma once

#include "transpiler/dialects/classicladder/lowering/blocks.h"
#include "transpiler/dialects/classicladder/lowering/contacts.h"
#include "transpiler/dialects/classicladder/lowering/expressions.h"
#include "transpiler/dialects/classicladder/lowering/grid.h"
#include "transpiler/dialects/classicladder/lowering/jumps.h"
#include "transpiler/dialects/classicladder/lowering/statement_writer.h"
#include "transpiler/dialects/classicladder/lowering/subroutines.h"

namespace plcxx::classicladder {

class Ladder : Context {
 public:
  Ladder(const Context& context, Logic& logic, Grid& grid, Contacts& contacts, Blocks& blocks, Expressions& expressions,
         Jumps& jumps, Subroutines& subroutines, StatementWriter& statements)
      : Context(context),
        logic_(logic),
        grid_(grid),
        contacts_(contacts),
        blocks_(blocks),
        expressions_(expressions),
        jumps_(jumps),
        subroutines_(subroutines),
        statements_(statements) {}

  void Lower(const Section& section, ir::RegionId body);

 private:
  void LowerRung(const Rung& rung);
  /// False: nothing after the element is executed.
  bool Execute(uint32_t x, uint32_t y, const Element& element);

  Logic& logic_;
  Grid& grid_;
  Contacts& contacts_;
  Blocks& blocks_;
  Expressions& expressions_;
  Jumps& jumps_;
  Subroutines& subroutines_;
  StatementWriter& statements_;
};

}  // namespace plcxx::classicladder
