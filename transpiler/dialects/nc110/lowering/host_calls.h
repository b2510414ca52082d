// The functions by which a program reaches its host (specification 8.1).
#pragma once

#include <vector>

#include "transpiler/dialects/common/host_calls.h"

namespace plcxx::nc110 {

enum class HostCall : uint8_t { kNow, kReadInputs, kWriteOutputs, kRetentiveLoad, kRetentiveStore, kFault, kCount };

using HostCalls = dialects::HostCalls<HostCall>;

const std::vector<dialects::HostRow<HostCall>>& HostRows();

}  // namespace plcxx::nc110
