#include "transpiler/emit/print/host_function_head.h"

namespace plcxx::emit::print {
namespace {

std::string CppType(const ir::HostFunction& function, const ir::Parameter& parameter) {
  return parameter.enumerators.empty() ? std::string(ir::CppName(parameter.type))
                                       : function.name + "_" + parameter.name;
}

}  // namespace

std::string HostFunctionHead(const ir::HostFunction& function) {
  const bool loads = function.access == ir::HostAccess::kWritesRetentive;  // into a copy; its result is not used
  std::string out = (loads ? "void" : std::string(ir::CppName(function.result))) + " " + function.name + "(Host& host";
  switch (function.access) {
    case ir::HostAccess::kNone:
      break;
    case ir::HostAccess::kReadsState:
      out += ", const State& m";
      break;
    case ir::HostAccess::kWritesState:
      out += ", State& m";
      break;
    case ir::HostAccess::kReadsRetentive:
      out += ", const Retentive& retentive";
      break;
    case ir::HostAccess::kWritesRetentive:
      out += ", Retentive& retentive";
      break;
  }
  for (const ir::Parameter& parameter : function.parameters)
    out += ", " + CppType(function, parameter) + " " + parameter.name;
  if (!function.out.name.empty()) out += ", " + std::string(ir::CppName(function.out.type)) + "& " + function.out.name;
  return out + ") noexcept";
}

}  // namespace plcxx::emit::print
