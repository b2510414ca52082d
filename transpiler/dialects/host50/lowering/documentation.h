// What is known of the addresses that the program uses or names: for maps, comments and reports.
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Cells;
class Names;

class Documentation : Context {
 public:
  Documentation(const Context& context, const Cells& cells, const Names& names)
      : Context(context), cells_(cells), names_(names) {}

  void Add();

 private:
  const Cells& cells_;
  const Names& names_;
};

}  // namespace plcxx::host50
