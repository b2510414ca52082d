// The functions by which a program reaches its host: rows of a dialect's table, and their calls.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/ir/builder.h"

namespace plcxx::dialects {

template <class Call>
struct HostRow {
  Call call;
  std::string_view name;
  ir::HostAccess access = ir::HostAccess::kNone;
  bool routine_exchange = false;
  std::string_view comment;
  ir::Type result = ir::Type::kNone;
  std::vector<ir::Parameter> parameters;
  ir::Parameter out;
  bool polled = false;
};

/// By the dialect's own enumerators, of which kCount is the last one.
template <class Call>
class HostCalls {
 public:
  explicit HostCalls(ir::Builder& builder) : builder_(builder) {}

  void Add(const std::vector<HostRow<Call>>& rows) {
    for (const HostRow<Call>& row : rows) {
      ids_[static_cast<size_t>(row.call)] =
          builder_.program().host_functions.Add({.name = std::string(row.name),
                                                 .parameters = row.parameters,
                                                 .result = row.result,
                                                 .out = row.out,
                                                 .access = row.access,
                                                 .routine_exchange = row.routine_exchange,
                                                 .polled = row.polled,
                                                 .comment = std::string(row.comment)});
    }
  }
  ir::HostFunctionId operator[](Call call) const { return ids_[static_cast<size_t>(call)]; }

  /// Calls it. `out`: the place for the second result of a function that gives one.
  ir::ValueId operator()(Call call, std::vector<ir::ValueId> arguments = {}, ir::PlaceId out = {}) {
    return builder_.CallHost((*this)[call], std::move(arguments), out);
  }

 private:
  ir::Builder& builder_;
  std::array<ir::HostFunctionId, static_cast<size_t>(Call::kCount)> ids_;
};

}  // namespace plcxx::dialects
