#include "transpiler/dialects/classicladder/lowering/edges.h"

#include <utility>

namespace plcxx::classicladder {

ir::StateId Edges::Of(const Element& element) {
  const auto [found, is_new] = states_.try_emplace(element.range.begin);
  if (is_new) {
    std::string name = names_.Of(element.variable.address) + "_edge";
    const uint32_t count = ++counts_[name];
    if (count > 1) name += "_" + std::to_string(count);
    found->second = program_.states.Add({.kind = ir::StateKind::kEdgeMemory, .name = std::move(name)});
    elements_.push_back(&element);
  }
  return found->second;
}

void Edges::Preset() {
  for (const Element* element : elements_) {
    const bool zero = !element->variable.index && Info(element->variable.address.kind).group == Group::kBits;
    if (zero) continue;
    const ir::ValueId operand = accesses_.ReadBit(element->variable);
    builder_.Step(ir::OpKind::kPresetEdge, Of(*element), {operand});
  }
}

}  // namespace plcxx::classicladder
