#include "transpiler/dialects/@name@/control/stub.h"

namespace plcxx::@name@ {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& /*program*/,
                                                const std::map<std::string, std::string>& /*options*/) {
  return nullptr;  // nothing plays the control but the steps of a scenario
}

}  // namespace plcxx::@name@
