// The outermost uses of macros by where they begin: nearly every expression of a program that is written in macros asks
// for its own, one after the other.
#pragma once

#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

class MacroUses {
 public:
  /// Of two at one place, in a file that is included twice, the later one counts.
  void Add(source::Offset begin, MacroUseId use) { uses_.emplace_back(begin, use); }
  /// To be called when all are there.
  void Sort();
  /// None: no use begins there.
  MacroUseId At(source::Offset begin);

 private:
  std::vector<std::pair<source::Offset, MacroUseId>> uses_;
  size_t last_ = 0;  // that was found
};

}  // namespace plcxx::hnc
