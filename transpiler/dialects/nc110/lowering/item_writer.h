// The items of the program in their order, into the fast part and, after the cycle mark, the slow one.
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Blocks;
class Routines;
class StatementWriter;
class Targets;

class ItemWriter : Context {
 public:
  ItemWriter(const Context& context, const Routines& routines, Blocks& blocks, Targets& targets,
             StatementWriter& statements)
      : Context(context), routines_(routines), blocks_(blocks), targets_(targets), statements_(statements) {}

  void LowerAll();

 private:
  void EnterPart(Part part);

  const Routines& routines_;
  Blocks& blocks_;
  Targets& targets_;
  StatementWriter& statements_;
};

}  // namespace plcxx::nc110
