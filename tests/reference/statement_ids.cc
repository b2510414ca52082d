#include "tests/reference/statement_ids.h"

#include <map>
#include <utility>

namespace plcxx::reference {

void UniteStatementIds(ir::Program& program, const source::SourceManager& sources) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> first_at;  // by file and line of what the fault is about
  std::map<uint32_t, uint32_t> united;
  for (ir::Statement& statement : program.statements) {
    if (statement.line == 0) continue;
    const std::pair<uint32_t, uint32_t> line{sources.FileAt(statement.range.begin).index, statement.line};
    const uint32_t id = first_at.try_emplace(line, statement.id).first->second;
    if (id == statement.id) continue;
    united[statement.id] = id;
    statement.id = id;
  }
  for (const ir::Call& call : program.calls) {
    if (!call.host.valid()) continue;
    const std::vector<ir::Parameter>& parameters = program.host_functions[call.host].parameters;
    for (size_t i = 0; i < parameters.size(); ++i) {
      if (!parameters[i].is_statement) continue;
      ir::Inst& argument = program[call.arguments[i]];
      const auto id = united.find(static_cast<uint32_t>(ir::ConstantValue(argument)));
      if (id != united.end()) argument.a = id->second;
    }
  }
}

}  // namespace plcxx::reference
