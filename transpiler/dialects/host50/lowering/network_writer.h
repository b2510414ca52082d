// Networks and their rungs, which are the statements.
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class InstructionSet;
class Jumps;
class Results;
class StatementWriter;

class NetworkWriter : Context {
 public:
  NetworkWriter(const Context& context, Jumps& jumps, Results& results, InstructionSet& instructions,
                StatementWriter& statements)
      : Context(context), jumps_(jumps), results_(results), instructions_(instructions), statements_(statements) {}

  /// Where jumps to it arrive; its comments wait for its first statement.
  void Begin(NetworkId id);
  void Lower(NetworkId id);

 private:
  void LowerRung(Span rung);
  std::vector<Span> RungsOf(const Network& network) const;
  uint32_t LineOf(InstructionId id) const;
  static bool Acts(const Instruction& instruction);

  Jumps& jumps_;
  Results& results_;
  InstructionSet& instructions_;
  StatementWriter& statements_;
};

}  // namespace plcxx::host50
