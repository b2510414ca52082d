// A simulated control for dialect technol (specification 5.7, 8.3): no request completes by itself; with retain=dual
// the scenario's end of REQ_BACKUP_MEM is the backup that power-on restores.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::technol {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

}  // namespace plcxx::technol
