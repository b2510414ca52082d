// The machines of a wide run in lockstep: as many fleets as it takes, each as wide as the library.
//
// In: a program compiled for fleets. Out: all of its machines as one for the clock, which runs them; and of a
// bit, which machines have it. Not its job: what one of them is given (fleet/lane.h), and its control.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "transpiler/fleet/fleet.h"
#include "transpiler/fleet/library.h"
#include "transpiler/ir/memory.h"
#include "transpiler/sim/engine.h"

namespace plcxx::soak {

class WideFleets : public sim::Clocked {
 public:
  WideFleets(const std::shared_ptr<const fleet::Library>& library, uint32_t machines);

  const std::vector<std::unique_ptr<fleet::Fleet>>& all() const { return fleets_; }
  /// Only the first one runs: it does what all machines have in common.
  void RunFirstAlone(bool alone) { running_ = alone ? 1 : fleets_.size(); }
  /// All machines become what the first one is.
  void BecomeFirst();

  // The place of a bit, in all of the machines.
  /// The first machine where it is set.
  std::optional<size_t> FirstWith(const ir::Place& bit) const;
  bool IsSet(size_t machine, const ir::Place& bit) const;
  struct Values {
    bool zero = false, one = false;
  };
  /// Those that it has in some machine.
  Values ValuesOf(const ir::Place& bit) const;

  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override { Run(fleet::Piece::kPeriod, now_ms); }
  void RunFastOnly(uint32_t now_ms) override { Run(fleet::Piece::kFastOnly, now_ms); }
  void RunElapse(uint32_t now_ms) override { Run(fleet::Piece::kElapse, now_ms); }
  void StoreRetentive() override;
  /// Counts of the scheduler, which are the same in every machine.
  uint64_t Read(const ir::Place& place) override { return fleets_.front()->Read(0, place); }

 private:
  void Run(fleet::Piece piece, uint32_t now_ms);

  std::vector<std::unique_ptr<fleet::Fleet>> fleets_;
  size_t running_ = 0;
};

}  // namespace plcxx::soak
