// The functions by which a program reaches its host (specification section 8).
#pragma once

#include <vector>

#include "transpiler/dialects/common/host_calls.h"

namespace plcxx::host50 {

enum class HostCall : uint8_t { kReadInputs, kWriteOutputs, kRetentiveLoad, kAlarm, kAxisCommand, kFault, kCount };

using HostCalls = dialects::HostCalls<HostCall>;

const std::vector<dialects::HostRow<HostCall>>& HostRows();

}  // namespace plcxx::host50
