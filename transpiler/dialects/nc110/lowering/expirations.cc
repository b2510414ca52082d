#include "transpiler/dialects/nc110/lowering/expirations.h"

namespace plcxx::nc110 {

void Expirations::Add(ir::StateId state) {
  Driven& driven = driven_[static_cast<size_t>(part_)];
  if (driven.known.insert(state.index).second) driven.order.push_back(state);
}

}  // namespace plcxx::nc110
