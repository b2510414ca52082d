// Statements: each one of C is a statement of the IR, heads of ifs, loops and switches included, so that the structure
// and the comments of the source survive.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Branches;
class CriticalSections;
class Expressions;
class Gotos;
class Initialisers;
class Jumps;
class LivePath;
class Loops;
class Returns;
class StatementWriter;
class Switches;

class Statements : Context {
 public:
  Statements(const Context& context, CriticalSections& critical, Jumps& jumps, LivePath& path, StatementWriter& writer,
             Expressions& expressions, Loops& loops, Gotos& gotos, Switches& switches, Initialisers& initialisers,
             Branches& branches, Returns& returns)
      : Context(context),
        critical_(critical),
        jumps_(jumps),
        path_(path),
        writer_(writer),
        expressions_(expressions),
        loops_(loops),
        gotos_(gotos),
        switches_(switches),
        initialisers_(initialisers),
        branches_(branches),
        returns_(returns) {}

  void Lower(StatementId id, Tail tail);

 private:
  void LowerReached(StatementId id, const Statement& statement, Tail tail);
  void LowerBody(const std::vector<StatementId>& body, Tail tail);
  void Compound(const Statement& statement, Tail tail);

  CriticalSections& critical_;
  Jumps& jumps_;
  LivePath& path_;
  StatementWriter& writer_;
  Expressions& expressions_;
  Loops& loops_;
  Gotos& gotos_;
  Switches& switches_;
  Initialisers& initialisers_;
  Branches& branches_;
  Returns& returns_;
  bool unreachable_reported_ = false;
};

}  // namespace plcxx::hnc
