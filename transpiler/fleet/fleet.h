// Machines that execute one program side by side: 64, 256 or 512, each a lane.
//
// The caller owns time, which is one for all machines; each has its own memory, and its own answers of the host. Bits
// that the program does not name are not kept: they read as 0. Not its job: scenarios (fleet_engine.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "transpiler/fleet/library.h"
#include "transpiler/ir/program.h"

namespace plcxx::fleet {

/// A set of lanes: a bit for each, 64 in a word.
using LaneSet = std::vector<uint64_t>;

/// One host function, called by all lanes of `mask` at once. Raw bits; rows of `lanes` elements.
struct FleetCall {
  ir::HostFunctionId function;
  unsigned lanes = 0;
  const uint64_t* mask = nullptr;
  const uint64_t* arguments = nullptr;  // row after row
  uint64_t* results = nullptr;          // 0 at first; null: the function gives none
  uint64_t* seconds = nullptr;          // likewise
  uint64_t* has_second = nullptr;       // a bit for each lane, 0 at first

  bool calls(unsigned lane) const { return (mask[lane / 64] >> (lane % 64) & 1) != 0; }
};

class Fleet {
 public:
  explicit Fleet(std::shared_ptr<const Library> library);
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  const ir::Program& program() const { return *library_->program; }
  const Library& library() const { return *library_; }
  unsigned lanes() const { return library_->lanes; }
  LaneSet AllLanes() const { return LaneSet(lanes() / 64, ~uint64_t{0}); }

  /// Of every call but those for the time; the store of retentive memory is the fleet's own, who asks may note it.
  void AnswerHostCalls(std::function<void(const FleetCall& call)> answers) { answers_ = std::move(answers); }

  /// Clears everything that is not retentive storage of the host, then runs init. Forces stay.
  void PowerOn();
  void Run(Piece piece, uint32_t now_ms);

  bool Holds(ir::SpaceId space, uint32_t offset, uint8_t bit) const;
  bool Bit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit) const;
  /// Bits that the fleet does not hold are 0.
  uint8_t Byte(unsigned lane, ir::SpaceId space, uint32_t offset) const;
  /// The host writes: a forced bit keeps its value. Nothing where the fleet does not hold it. What is the same in every
  /// machine is written in all of them.
  void SetBit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit, bool value);
  /// `element` of a field that is an array; else 0.
  uint64_t Field(unsigned lane, ir::StateId state, uint8_t field, uint32_t element = 0) const;
  void SetField(unsigned lane, ir::StateId state, uint8_t field, uint64_t value, uint32_t element = 0);
  /// A place of the program that is not indexed.
  uint64_t Read(unsigned lane, const ir::Place& place) const;
  void Write(unsigned lane, const ir::Place& place, uint64_t value);

  /// Needs a library with forces. Forced bits keep the value that they have now.
  void ForceBit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit, bool forced);
  void ForceField(unsigned lane, ir::StateId state, uint8_t field, bool forced);

  void StoreRetentive();
  void StoreRetentive(unsigned lane);
  /// The host has stored nothing, as before the first power-on.
  void ForgetRetentive() { has_stored_ = LaneSet(lanes() / 64, 0); }
  /// As sim::Engine::SendText, into one machine.
  void SendText(unsigned lane, std::string_view text);

  /// Every lane becomes what a lane of a fleet of the same library is now, which has no forces.
  void BecomeAll(const Fleet& other, unsigned lane);
  /// As sim::Engine::Snapshot, with bits of spaces that are not held taken from `others` (a byte vector for each
  /// space).
  std::vector<uint8_t> Snapshot(unsigned lane, const std::vector<std::vector<uint8_t>>& others) const;

  /// The words of a plane, a bit for each lane, to be written before the next Run; none where the bit is not held or
  /// the same in every machine.
  std::span<uint64_t> PlaneOf(ir::SpaceId space, uint32_t offset, uint8_t bit);

 private:
  uint64_t* PlaneAt(uint32_t plane) { return words_ + size_t{plane} * (lanes() / 64); }
  const uint64_t* PlaneAt(uint32_t plane) const { return words_ + size_t{plane} * (lanes() / 64); }
  bool PlaneBit(uint32_t plane, unsigned lane) const { return (PlaneAt(plane)[lane / 64] >> (lane % 64) & 1) != 0; }
  void SetPlaneBit(uint32_t plane, unsigned lane, bool value);
  /// Of a field that the planes do not hold while the timer's clock runs.
  std::optional<uint64_t> ByClock(unsigned lane, ir::StateId state, uint8_t field) const;
  /// From here on the planes of a timer's times are what they are called.
  void StopClock(ir::StateId state);
  uint64_t PlanesOfField(unsigned lane, ir::StateId state, uint8_t field, uint32_t element) const;
  void SetPlanesOfField(unsigned lane, ir::StateId state, uint8_t field, uint64_t value, uint32_t element);
  uint32_t FieldPlane(ir::StateId state, uint8_t field, uint32_t element) const;
  void HostCalled(uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
                  uint64_t* seconds, uint64_t* has_second);
  void LoadRetentive(const uint64_t* mask);
  void StoreRetentive(const uint64_t* mask);

  struct Free {
    void operator()(void* memory) const;
  };
  std::shared_ptr<const Library> library_;
  std::unique_ptr<void, Free> memory_;
  uint64_t* words_ = nullptr;  // the planes
  Clock* clocks_ = nullptr;
  uint8_t* scalars_ = nullptr;
  uint8_t* touched_ = nullptr;  // blocks of retentive memory, written since they were stored
  uint64_t* forced_ = nullptr;  // planes, when the library has forces
  HostTable host_;
  std::function<void(const FleetCall&)> answers_;
  std::vector<uint64_t> stored_planes_;  // the host's store of retentive memory, as planes
  LaneSet has_stored_;
};

}  // namespace plcxx::fleet
