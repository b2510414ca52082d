// Functional modules: what all of them have in common, and which part lowers each (specification 6.6, 6.9).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Arithmetic;
class IndirectAccess;
class Logic;
class LongWords;
class NcVariables;
class Registers;

class Functions : Context {
 public:
  Functions(const Context& context, Registers& registers, Logic& logic, Arithmetic& arithmetic,
            IndirectAccess& indirect, NcVariables& nc, LongWords& long_words)
      : Context(context),
        registers_(registers),
        logic_(logic),
        arithmetic_(arithmetic),
        indirect_(indirect),
        nc_(nc),
        long_words_(long_words) {}

  void Perform(const Instruction& instruction);
  void PerformIf(const Instruction& instruction);

 private:
  /// Has it an operand with which it does nothing?
  bool IsDisabled(const Instruction& instruction) const;

  Registers& registers_;
  Logic& logic_;
  Arithmetic& arithmetic_;
  IndirectAccess& indirect_;
  NcVariables& nc_;
  LongWords& long_words_;
};

}  // namespace plcxx::prostep
