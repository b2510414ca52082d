#include "transpiler/sim/host.h"

namespace plcxx::sim {

HostAnswer Host::Answer(const ir::Call& call, const std::vector<uint64_t>& arguments, uint32_t now_ms, Memory& memory) {
  const ir::Schedule& schedule = program_.schedule;
  if (call.host == schedule.now) return {.result = now_ms, .out = {}};
  if (!program_.host_functions[call.host].routine_exchange) events_.push_back({call.host, arguments, call.exchange});
  if (call.host == schedule.retentive_load) {
    memory.LoadRetentive();
    return {};
  }
  if (call.host == schedule.retentive_store) {
    memory.StoreRetentive();
    return {};
  }
  return answers_ ? answers_(call.host, arguments) : HostAnswer{};
}

}  // namespace plcxx::sim
