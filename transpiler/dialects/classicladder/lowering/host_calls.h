// The functions by which a program reaches its host.
#pragma once

#include <vector>

#include "transpiler/dialects/common/host_calls.h"

namespace plcxx::classicladder {

enum class HostCall : uint8_t { kReadInputs, kWriteOutputs, kFault, kCount };

using HostCalls = dialects::HostCalls<HostCall>;

const std::vector<dialects::HostRow<HostCall>>& HostRows();

}  // namespace plcxx::classicladder
