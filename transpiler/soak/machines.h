// The border between what runs machines and what steers them: N machines of one program, each with inputs and a time of
// its own.
//
// What runs them may take one after the other (simulated_machines.h) or all at once, a machine a lane; what steers them
// sets inputs, gives each a piece of time, is called after each part that was executed, and takes copies of moments to
// go back to. Whatever runs them, equal inputs give equal machines. Not its job: which inputs, and what is looked for.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/engine.h"

namespace plcxx::soak {

/// A machine between two steps; what is in it only those know that made it. Safe to be read from several threads.
class Moment {
 public:
  virtual ~Moment() = default;
};

/// How long a machine runs; one of the three is not 0, as in a scenario's `run`.
struct Piece {
  size_t machine = 0;
  uint32_t slow = 0;  // complete slow passes
  uint32_t fast = 0;  // ticks of the fast part
  uint32_t ms = 0;
};

/// How a piece ended.
enum class PieceEnd : uint8_t {
  kDone,
  kStuck,   // a part was not completed within the periods that it may take
  kEndless  // a part executed more than any part should: the machine is in the middle of it
};

class Machines {
 public:
  /// After each part of a machine.
  using AfterPart = std::function<void(size_t machine, sim::Clock::Part part)>;

  virtual ~Machines() = default;
  virtual size_t count() const = 0;

  /// A new machine gets power for the first time.
  virtual void PowerOn(size_t machine) = 0;
  virtual void PowerCycle(size_t machine) = 0;
  /// As a scenario's `set`; `location` is neither a text input nor absent.
  virtual void Set(size_t machine, const dialects::Location& location, uint64_t value) = 0;
  virtual void SendText(size_t machine, std::string_view text) = 0;
  /// Each piece is another machine's.
  virtual void Run(std::span<const Piece> pieces, const AfterPart& after) = 0;
  /// Of the last piece of a machine. After kEndless only PowerOn and Restore are of use.
  virtual PieceEnd EndOf(size_t machine) const = 0;

  /// For who reads places; it is driven through this border alone.
  virtual sim::Engine& EngineOf(size_t machine) = 0;
  virtual const std::vector<uint32_t>& ActiveMessages(size_t machine) const = 0;
  virtual uint64_t TimeMs(size_t machine) const = 0;
  /// From now on what each instruction of the machine gives is noted there, by InstId: see Simulator::NoteGiven.
  virtual void NoteGiven(size_t machine, std::span<uint8_t> given) = 0;
  /// What the machine has cost so far, in a unit that is the same everywhere; no time.
  virtual uint64_t Work(size_t machine) const = 0;

  virtual std::shared_ptr<const Moment> Save(size_t machine) = 0;
  /// A moment of any machine that machines of this kind and program have saved.
  virtual void Restore(size_t machine, const Moment& moment) = 0;
};

/// Makes as many machines as are asked for; called from several threads.
using MakeMachines = std::function<std::unique_ptr<Machines>(size_t count)>;

}  // namespace plcxx::soak
