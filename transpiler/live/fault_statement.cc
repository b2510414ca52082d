#include "transpiler/live/fault_statement.h"

namespace plcxx::live {
namespace {

ir::StatementId StatementWithId(const ir::Program& program, uint64_t id) {
  for (uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[ir::StatementId(i)].id == id) return ir::StatementId(i);
  }
  return {};
}

}  // namespace

std::optional<ir::StatementId> FaultStatement(const ir::Program& program, const sim::HostEvent& event) {
  const std::vector<ir::Parameter>& parameters = program.host_functions[event.function].parameters;
  for (size_t i = 0; i < parameters.size() && i < event.arguments.size(); ++i) {
    if (parameters[i].is_statement) return StatementWithId(program, event.arguments[i]);
  }
  return std::nullopt;
}

}  // namespace plcxx::live
