// Alarms, M codes and titles (9).
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Tables : Context {
 public:
  explicit Tables(const Context& context) : Context(context) {}

  void Add();

 private:
  void AddTitle();
  void AddMCodes();
  void AddSettings();
};

}  // namespace plcxx::host50
