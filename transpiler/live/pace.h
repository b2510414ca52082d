// How many periods are due: real time, slower, faster, or without a limit.
#pragma once

#include <cstdint>

namespace plcxx::live {

class Pace {
 public:
  /// From now on, `us` of real time, `speed` periods' time a time passes; 0: no limit.
  void Begin(uint64_t us, uint32_t unit_ms, double speed);
  /// What should have been run by now, and has not been told so far. After a long break it does not catch up.
  uint64_t Due(uint64_t us);
  /// Until something is due; 0: it is.
  uint64_t UsUntilNext(uint64_t us) const;

 private:
  uint64_t begin_us_ = 0, told_ = 0;
  double periods_per_us_ = 0;  // 0: no limit
};

}  // namespace plcxx::live
