// The memories of contacts that look at edges: each element has one of its own, as it has in the engine.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "transpiler/dialects/classicladder/lowering/accesses.h"
#include "transpiler/dialects/classicladder/lowering/names.h"

namespace plcxx::classicladder {

class Edges : Context {
 public:
  Edges(const Context& context, const Names& names, Accesses& accesses)
      : Context(context), names_(names), accesses_(accesses) {}

  /// Named by what the element looks at.
  ir::StateId Of(const Element& element);
  /// Edges know their variables as they are at power-on: bits in memory are 0, presets need not be.
  void Preset();

 private:
  const Names& names_;
  Accesses& accesses_;
  std::map<source::Offset, ir::StateId> states_;  // by the place of the element
  std::vector<const Element*> elements_;          // in their order
  std::map<std::string, uint32_t> counts_;
};

}  // namespace plcxx::classicladder
