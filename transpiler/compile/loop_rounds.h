// Which loop of the text a loop of the compiled code is.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/compile/longest_path.h"
#include "transpiler/compile/measurement.h"
#include "transpiler/compile/object_facts.h"

namespace plcxx::compile {

/// The most rounds of a loop of `function`, by the lines that its instructions come from: never too few where the
/// text's loop is found, too many where several are in question. None: not found, or its bound is not known.
Rounds RoundsOf(const ObjectFacts& object, const CodeFunction& function, const PathLoop& loop,
                const LoopBounds& bounds);

}  // namespace plcxx::compile
