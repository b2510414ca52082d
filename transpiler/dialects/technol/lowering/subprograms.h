// CALL and RET (specification 6.4).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Exits;
class Mechanisms;

class Subprograms : Context {
 public:
  Subprograms(const Context& context, Exits& exits, Mechanisms& mechanisms)
      : Context(context), exits_(exits), mechanisms_(mechanisms) {}

  void Call(const Instruction& instruction);
  void Return();

 private:
  Exits& exits_;
  Mechanisms& mechanisms_;
};

}  // namespace plcxx::technol
