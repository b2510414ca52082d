// Switches (specification 6.7). A switch whose labels stand in its body is one of the IR; one with labels deeper inside
// becomes jumps in the list around it.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Conversions;
class Expressions;
class Intervals;
class Jumps;
class LivePath;
class StatementWriter;
class Statements;

class Switches : Context {
 public:
  Switches(const Context& context, Jumps& jumps, LivePath& path, Intervals& intervals, StatementWriter& writer,
           Conversions& conversions, Expressions& expressions, Statements& statements)
      : Context(context),
        jumps_(jumps),
        path_(path),
        intervals_(intervals),
        writer_(writer),
        conversions_(conversions),
        expressions_(expressions),
        statements_(statements) {}

  void Lower(const Statement& statement);
  void BeginFunction() {
    case_labels_ = {};
    groups_in_front_ = {};
  }
  /// A label that lies deeper than its switch's body.
  void PlaceCase(StatementId id);

 private:
  Value ConvertSelector(ExprId id);
  void CheckFallThrough(StatementId first, std::span<const StatementId> others, StatementId to);
  void LowerFlat(const Statement& statement, const Value& selector);

  Jumps& jumps_;
  LivePath& path_;
  Intervals& intervals_;
  StatementWriter& writer_;
  Conversions& conversions_;
  Expressions& expressions_;
  Statements& statements_;
  std::unordered_map<uint32_t, uint32_t> case_labels_;  // by StatementId of a case, of a flat switch
  /// The statements of the group that ends in front of a case of a flat switch, by its StatementId.
  std::unordered_map<uint32_t, std::vector<StatementId>> groups_in_front_;
};

}  // namespace plcxx::hnc
