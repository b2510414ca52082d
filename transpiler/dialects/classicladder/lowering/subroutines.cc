#include "transpiler/dialects/classicladder/lowering/subroutines.h"

#include <string>

namespace plcxx::classicladder {

void Subroutines::AddCalledBy(const Section& section) {
  for (const uint32_t number : ChainOf(tree_, section)) {
    for (const auto& row : tree_.rungs.at(number).rows) {
      for (const Element& element : row) {
        if (element.kind != ElementKind::kCall) continue;
        const Section* called = SubroutineOf(tree_, element.number);
        if (called == nullptr || routines_.contains(called->number)) continue;
        const std::string name = "SR" + std::to_string(called->subroutine);
        routines_[called->number] =
            builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, "Subroutine " + name + ": " + called->name);
        called_.push_back(called);
        AddCalledBy(*called);
      }
    }
  }
}

}  // namespace plcxx::classicladder
