// What is an effect and has no text nevertheless: asked where texts are placed, and by the last look at them.
#pragma once

#include "transpiler/emit/emittable.h"

namespace plcxx::emit {

/// Whether it is an instruction with an effect (IsEffect) whose text would do nothing: it has none.
bool ChangesNothing(const Emittable& emittable, ir::InstId id);

}  // namespace plcxx::emit
