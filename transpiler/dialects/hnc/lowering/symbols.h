// Names of the program's data for scenarios and reports: every element and member, whether or not a statement names it.
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Memory;

class Symbols : Context {
 public:
  Symbols(const Context& context, Memory& memory) : Context(context), memory_(memory) {}

  void Add();
  /// Register cells that statements name, and all variables, by address.
  void Document();

 private:
  void AddSymbol(const std::string& name, TypeId type_id, uint32_t offset,
                 const std::vector<ir::Symbol::Index>& indices);
  std::string MeaningOf(const Variable& variable) const;
  std::string CommentOf(source::Range name) const;
  void AddLinesAbove(source::Range name, std::vector<source::Range>& lines) const;

  Memory& memory_;
};

}  // namespace plcxx::hnc
