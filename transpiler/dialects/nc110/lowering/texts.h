// Texts of the operator, which ASCII conditions wait for: each has a flag.
#pragma once

#include <vector>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Texts : Context {
 public:
  explicit Texts(const Context& context) : Context(context), flags_(tree_.literals.size()) {}

  ir::PlaceId FlagOf(LiteralId literal);
  /// Compares what was typed with each text that is waited for.
  void Update();

 private:
  std::vector<ir::PlaceId> flags_;  // by LiteralId
};

}  // namespace plcxx::nc110
