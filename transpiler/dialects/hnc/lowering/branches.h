// Ifs: choices of the IR, or jumps in the list around them where a jump leads into an arm.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Expressions;
class Intervals;
class Jumps;
class LivePath;
class StatementWriter;
class Statements;

class Branches : Context {
 public:
  Branches(const Context& context, Jumps& jumps, LivePath& path, Intervals& intervals, StatementWriter& writer,
           Expressions& expressions, Statements& statements)
      : Context(context),
        jumps_(jumps),
        path_(path),
        intervals_(intervals),
        writer_(writer),
        expressions_(expressions),
        statements_(statements) {}

  void Lower(StatementId id, const Statement& statement, Tail tail);

 private:
  void LowerFlat(const Statement& statement);

  Jumps& jumps_;
  LivePath& path_;
  Intervals& intervals_;
  StatementWriter& writer_;
  Expressions& expressions_;
  Statements& statements_;
};

}  // namespace plcxx::hnc
