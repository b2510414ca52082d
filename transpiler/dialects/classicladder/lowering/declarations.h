// What the lines of a project declare: values at power-on, symbols with their comments.
#pragma once

#include <set>

#include "transpiler/dialects/classicladder/lowering/context.h"
#include "transpiler/dialects/classicladder/lowering/names.h"

namespace plcxx::classicladder {

class Declarations : Context {
 public:
  explicit Declarations(const Context& context) : Context(context) {}

  /// Presets; the time left of old timers; 1 for initial steps. What no line declares has 0 in seconds.
  void AddInitialValues();
  /// Of the symbols and of the variables in `used`.
  void AddDocumentation(std::set<VariableKey> used);

 private:
  void Initial(const ir::Place& place, uint32_t value);
};

}  // namespace plcxx::classicladder
