// What a host function is for, told from its declaration. In: a declaration. Not its job: who calls it.
#pragma once

#include <string_view>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// As every language names the function by which a program reports a run-time fault.
constexpr std::string_view kFaultFunction = "fault";

/// Whether it reports a run-time fault: it is told which, answers nothing and is given nothing of the state.
inline bool ReportsFault(const HostFunction& function) {
  return function.name == kFaultFunction && function.result == Type::kNone && function.out.name.empty() &&
         function.access == HostAccess::kNone;
}

}  // namespace plcxx::ir
