// The functions by which a program reaches its host (specification 8.1 to 8.4).
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/common/host_calls.h"

namespace plcxx::technol {

enum class HostCall : uint8_t {
  kReadInputs,
  kWriteOutputs,
  kMachineConstants,
  kRestore,
  kRequest,
  kSendPlcmem,
  kSendTabtech,
  kSetNcTable,
  kNcTableRefused,
  kBackupPos,
  kBackupMem,
  kCloseAll,
  kHaltPass,
  kErrorRaised,
  kFault,
  kCount
};

using HostCalls = dialects::HostCalls<HostCall>;

const std::vector<dialects::HostRow<HostCall>>& HostRows();
/// In the order of SET_NCTAB (5.5).
const std::vector<std::string>& NcTableFields();

}  // namespace plcxx::technol
