#include "transpiler/dialects/classicladder/lowering/ladder.h"

#include <vector>

namespace plcxx::classicladder {

bool Ladder::Execute(uint32_t x, uint32_t y, const Element& element) {
  builder_.SetRange(element.range);
  switch (element.kind) {
    case ElementKind::kFree:
    case ElementKind::kPart:
      return true;  // keeps what a block above has put here
    case ElementKind::kContact:
    case ElementKind::kContactNot:
    case ElementKind::kRising:
    case ElementKind::kFalling:
      contacts_.Contact(x, y, element);
      return true;
    case ElementKind::kWire:
      grid_.Put(x, y, grid_.Left(x, y));
      return true;
    case ElementKind::kTimer:
      blocks_.Timer(x, y, element.number);
      return true;
    case ElementKind::kMonostable:
      blocks_.Monostable(x, y, element.number);
      return true;
    case ElementKind::kCounter:
      blocks_.Counter(x, y, element.number);
      return true;
    case ElementKind::kTimerIec:
      blocks_.TimerIec(x, y, element.number);
      return true;
    case ElementKind::kCompare: {
      const Signal before = grid_.Left(x - 2, y);
      grid_.Put(x, y, logic_.And(before, expressions_.Compare(element.number)));
      return true;
    }
    case ElementKind::kCoil:
    case ElementKind::kCoilNot:
    case ElementKind::kSet:
    case ElementKind::kReset:
      contacts_.Coil(x, y, element);
      return true;
    case ElementKind::kJump:
      return jumps_.Jump(grid_.Left(x, y), element.number);
    case ElementKind::kCall: {
      const Section* called = SubroutineOf(tree_, element.number);
      if (called == nullptr) return true;
      logic_.When(grid_.Left(x, y), [&] { subroutines_.Call(*called); });
      return true;
    }
    case ElementKind::kOperate:
      logic_.When(grid_.Left(x - 2, y), [&] { expressions_.Operate(element.number); });
      return true;
  }
  PLCXX_UNREACHABLE();
}

void Ladder::LowerRung(const Rung& rung) {
  grid_.Begin(rung);
  statements_.Begin(rung);
  for (uint32_t x = 0; x < kRungWidth; ++x) {
    for (uint32_t y = 0; y < kRungHeight; ++y) {
      if (!Execute(x, y, rung.At(x, y))) return;
    }
  }
}

void Ladder::Lower(const Section& section, ir::RegionId body) {
  builder_.SetRegion(body);
  builder_.SetRange({});
  const std::vector<uint32_t> chain = ChainOf(tree_, section);
  jumps_.Begin(section, chain);
  for (const uint32_t number : chain) {
    builder_.SetRange({});
    jumps_.BeginRung(number);
    LowerRung(tree_.rungs.at(number));
  }
  builder_.SetRange({});
  jumps_.End();
}

}  // namespace plcxx::classicladder
