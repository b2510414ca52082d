// What is known of the addresses that a program uses: the signal table's names and meanings, else the comment of the
// declaration that gives the address its first value (specification 8).
#pragma once

#include <string>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Instances;

class Documentation : Context {
 public:
  Documentation(const Context& context, Cells& cells, Instances& instances)
      : Context(context), cells_(cells), instances_(instances) {}

  /// Of the places that statements use: before the schedule adds its own.
  void Add();

 private:
  void AddCells();
  void AddInstances();
  std::string DeclaredComment(uint32_t address, uint32_t bytes) const;

  Cells& cells_;
  Instances& instances_;
};

}  // namespace plcxx::prostep
