// One program being executed, by the simulator or as compiled code: what scenarios, traces and stubs drive.
//
// The caller owns time: it says at which millisecond each period runs. A period is the program's own `period`
// routine (see ir/program.h), so no implementation knows a control.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::sim {

/// A call of a host function that is an event (HostFunction::routine_exchange is false). Arguments as raw bits.
struct HostEvent {
  ir::HostFunctionId function;
  std::vector<uint64_t> arguments;
  /// This call is part of the regular exchange (Call::exchange). Only the simulator knows, so that equality does not.
  bool exchange = false;
  bool operator==(const HostEvent& other) const { return function == other.function && arguments == other.arguments; }
};

/// What a host call gives back, as raw bits that fit the function's types; no `out`: the place of the second result
/// keeps its value.
struct HostAnswer {
  uint64_t result = 0;
  std::optional<uint64_t> out;
  bool operator==(const HostAnswer&) const = default;
};

class Engine;

/// A host call that an engine has made, how it was answered, and what was done to the engine meanwhile.
struct AnsweredCall {
  HostEvent call;
  HostAnswer answer;
  std::vector<std::function<void(Engine& engine)>> changes;
};

/// Answers a host call in the middle of a period; it may read and write the engine that asks.
using HostAnswers = std::function<HostAnswer(ir::HostFunctionId function, std::span<const uint64_t> arguments)>;

/// What a clock runs: a program in one engine, or as many machines of it as there are.
class Clocked {
 public:
  virtual ~Clocked() = default;
  /// Clears everything that is not retentive storage of the host, then runs init. Forces stay.
  virtual void PowerOn() = 0;
  virtual void RunPeriod(uint32_t now_ms) = 0;
  virtual void RunFastOnly(uint32_t now_ms) = 0;
  /// The schedule's `elapse`: time has passed without a period.
  virtual void RunElapse(uint32_t now_ms) = 0;
  /// Any place, also one that the program does not use. Of many machines one that is the same in all of them: a clock
  /// asks for counts of the scheduler.
  virtual uint64_t Read(const ir::Place& place) = 0;
  /// The host takes the retentive memory into its store, as a control does at power-off.
  virtual void StoreRetentive() = 0;
};

class Engine : public Clocked {
 public:
  /// For messages: "simulator", "compiled".
  virtual std::string_view name() const = 0;

  /// From now on `answers` is asked for every host call but those that the engine answers itself: the time, and the
  /// host's store of retentive memory. Without it calls give 0 and no second result.
  virtual void AnswerHostCalls(HostAnswers answers) = 0;

  /// What the next piece (PowerOn, RunPeriod ...) will ask if it does what another engine did, which has executed it.
  /// An engine to which a question costs much takes the answers with the changes from here, and says so: its questions
  /// are then told to `answers` without what it gives, up to as many as are in `calls`.
  virtual bool ExpectCalls(std::span<const AnsweredCall> /*calls*/) { return false; }

  /// From now on a piece is only begun, and EndPiece waits for its end: so many may be open at a time, more where
  /// asking a process costs much more than what it does. Until the last one is ended nothing is read of the engine but
  /// what its TakeEvents and Snapshot tell behind EndPiece, and nothing is written but what ExpectCalls is given. 1: a
  /// piece ends where it begins.
  virtual uint32_t RunAhead() { return 1; }
  /// Ends the oldest piece that is open: its events, and the snapshot behind it, are there.
  virtual void EndPiece() {}

  /// Any place, as with Read. A write is the host's: forced bits keep their value.
  virtual void Write(const ir::Place& place, uint64_t value) = 0;
  /// The bytes of a space as they are, for who reads many of them; empty: Read has to do.
  virtual std::span<const uint8_t> Memory(ir::SpaceId /*space*/) const { return {}; }
  /// The same from `offset` on, as many of them as are at hand.
  virtual std::span<const uint8_t> MemoryFrom(ir::SpaceId space, uint32_t offset) const {
    const std::span<const uint8_t> all = Memory(space);
    return offset < all.size() ? all.subspan(offset) : std::span<const uint8_t>();
  }
  virtual void Force(const ir::Place& place, uint64_t value) = 0;
  virtual void Release(const ir::Place& place) = 0;
  virtual void SendText(std::string_view text) = 0;

  /// Switches a statement off or on (a switched-off head of a block counts as a false condition).
  virtual void EnableStatement(ir::StatementId statement, bool enabled) = 0;

  virtual std::vector<HostEvent> TakeEvents() = 0;

  /// All bytes that decide the future: host-visible spaces in order, then the fields of all instances in order.
  /// Equal programs in equal histories give equal snapshots, whatever executes them.
  virtual std::vector<uint8_t> Snapshot() = 0;
};

}  // namespace plcxx::sim
