// Every C function is a routine with the same name, parameters and locals.
#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/locals.h"

namespace plcxx::hnc {

class Gotos;
class Intervals;
class Jumps;
class LivePath;
class Locals;
class Memory;
class CellPlaces;
class Records;
class Returns;
class StatementWriter;
class Statements;
class Switches;

/// Which functions are lowered: what no part reaches is checked, but no part of the program (4.1).
enum class Scope : uint8_t { kAll, kReached };

class Functions : Context {
 public:
  Functions(Scope scope, const Context& context, Memory& memory, CellPlaces& places, Locals& locals, Jumps& jumps,
            LivePath& path, Intervals& intervals, StatementWriter& writer, Records& records, Gotos& gotos,
            Switches& switches, Returns& returns, Statements& statements)
      : Context(context),
        scope_(scope),
        memory_(memory),
        places_(places),
        locals_(locals),
        jumps_(jumps),
        path_(path),
        intervals_(intervals),
        writer_(writer),
        records_(records),
        gotos_(gotos),
        switches_(switches),
        returns_(returns),
        statements_(statements) {}

  /// Routines with their parameters and results, so that bodies may call them in any order.
  void AddRoutines();
  void Lower(FunctionId id);
  /// Callees before their callers, so that bounds of results are known.
  std::vector<FunctionId> CalleesFirst() const;

 private:
  /// Whether the routine of the function is made.
  bool IsIncluded(FunctionId id) const { return scope_ == Scope::kAll || facts_.PartsOf(id) != 0; }
  std::string LinesOf(const std::vector<const Comment*>& comments) const;
  void AddComments(const Function& function, ir::Routine& routine);
  void BeginLocals(const Function& function);

  Scope scope_;
  Memory& memory_;
  CellPlaces& places_;
  Locals& locals_;
  Jumps& jumps_;
  LivePath& path_;
  Intervals& intervals_;
  StatementWriter& writer_;
  Records& records_;
  Gotos& gotos_;
  Switches& switches_;
  Returns& returns_;
  Statements& statements_;
  std::vector<Locals::Position> own_locals_;                     // by FunctionId, after its parameters
  std::set<uint32_t> begun_files_;                               // by FileId: whose first function has its comment
  std::unordered_map<uint32_t, ir::PlaceId> copied_parameters_;  // by VariableId: those that lie in memory
};

}  // namespace plcxx::hnc
