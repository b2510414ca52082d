#include "transpiler/plant/element.h"

namespace plcxx::plant {

int64_t Amount::Value(std::span<const int64_t> reads, int64_t step_thousandths) const {
  constexpr int64_t kMax = 1'000'000'000'000;  // in thousandths: what no machine has
  if (!read) return thousandths;
  const int64_t count = reads[*read];
  const int64_t most = kMax / step_thousandths;
  return (count > most ? most : count < -most ? -most : count) * step_thousandths;
}

MadeElement MakeElement(ElementKind kind, const Fields& fields) {
  switch (kind) {
    case ElementKind::kSwitch:
      return MakeSwitch(fields);
    case ElementKind::kCylinder:
      return MakeCylinder(fields);
    case ElementKind::kTurret:
      return MakeTurret(fields);
    case ElementKind::kMagazine:
      return MakeMagazine(fields);
    case ElementKind::kAxis:
      return MakeAxis(fields);
    case ElementKind::kTank:
      return MakeTank(fields);
    case ElementKind::kSpindle:
      return MakeSpindle(fields);
    case ElementKind::kFixed:
      return MakeFixed(fields);
  }
  return {};
}

}  // namespace plcxx::plant
