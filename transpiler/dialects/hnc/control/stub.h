// The simulated NC of dialect hnc (specification 4.4, 8.1): it holds what the host side of X, F and P is, and hands it
// over where the cycle asks for it. It moves no axes.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::hnc {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

}  // namespace plcxx::hnc
