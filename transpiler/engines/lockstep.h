// Several engines of one program as one: every command goes to each, and after each period their states are compared.
//
// In: a simulator, compiled code, or both. Out: the engine that a scenario drives, and the first difference. The first
// engine answers for all. Its host calls are answered by whoever drives the scenario; the others, which execute the
// same period after it, must make the same calls and get the same answers, with the same changes of memory. Not its
// job: what a difference means for a scenario (scenarios/run.h).
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::engines {

/// What two engines disagree about.
struct Difference {
  std::string what;                // "U4A8", "T5.elapsed_ms", "the host calls"
  std::optional<ir::Place> place;  // none: not a place of the program
  std::string first, second;       // "simulator: 1", "compiled: 0"
  uint32_t now_ms = 0;             // of the period after which it was seen
};

class Lockstep : public sim::Engine {
 public:
  Lockstep(const ir::Program& program, std::vector<std::unique_ptr<sim::Engine>> engines);

  /// From now on the others may be some pieces behind the first one, which saves most of the time of those in processes
  /// of their own. They have caught up, and differences are known, behind CatchUp, and whenever something is written.
  void FollowLater();
  void CatchUp();

  /// They have caught up.
  const std::vector<std::unique_ptr<sim::Engine>>& engines() {
    CatchUp();
    return engines_;
  }
  /// The first one since the beginning; stays.
  const std::optional<Difference>& difference() const { return difference_; }
  /// It was seen late: the first engine had gone on from where it is (FollowLater).
  bool went_on() const { return went_on_; }
  /// The first call that says so of a program whose facts are checked (ir/facts.h); stays.
  const std::optional<sim::HostEvent>& false_fact() const { return false_fact_; }

  std::string_view name() const override { return engines_.front()->name(); }
  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void AnswerHostCalls(sim::HostAnswers answers) override;
  uint64_t Read(const ir::Place& place) override { return engines_.front()->Read(place); }
  void Write(const ir::Place& place, uint64_t value) override;
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void SendText(std::string_view text) override;
  void EnableStatement(ir::StatementId statement, bool enabled) override;
  void StoreRetentive() override;
  std::vector<sim::HostEvent> TakeEvents() override;
  std::vector<uint8_t> Snapshot() override { return engines_.front()->Snapshot(); }

 private:
  using Change = std::function<void(sim::Engine& engine)>;
  /// What the first engine did in a piece of the program, and the others must do.
  struct Piece {
    uint32_t now_ms = 0;
    std::vector<sim::AnsweredCall> calls;
    std::vector<sim::HostEvent> events;
    std::vector<uint8_t> state;
  };
  /// A piece that another engine executes.
  struct Followed {
    std::shared_ptr<const Piece> piece;
    bool has_answers = false;  // the engine has taken the answers with the changes (ExpectCalls)
    size_t repeated = 0;       // of the calls: the engine has made them, too
  };
  struct Follower {
    sim::Engine* engine;
    uint32_t most_open = 1;
    std::deque<Followed> open;
  };
  /// Each engine executes a piece of the program, the first one before the others.
  void Execute(uint32_t now_ms, const Change& piece);
  /// To each engine; while a call of the first one is answered to that one only, the others follow at the same call.
  void Each(Change change);
  void Follow(Follower& follower, Followed followed, const Change& piece);
  void EndOldest(Follower& follower);
  sim::HostAnswer AnswerFirst(ir::HostFunctionId function, std::span<const uint64_t> arguments);
  sim::HostAnswer AnswerAgain(sim::Engine& engine, ir::HostFunctionId function, std::span<const uint64_t> arguments);
  void TakeEventsOfFirst();
  void Differ(std::string what, std::optional<ir::Place> place, std::string first, std::string second);
  void CallsDiffer(const sim::Engine& other, const std::string& first, const std::string& second);
  /// What has been followed and what the first engine did.
  void Compare(sim::Engine& other);
  void CompareEvents(sim::Engine& other);
  void CompareStates(sim::Engine& other);

  const ir::Program& program_;
  std::vector<std::unique_ptr<sim::Engine>> engines_;
  std::vector<Follower> followers_;  // all but the first
  std::vector<sim::HostEvent> events_;
  sim::HostAnswers answers_;
  std::shared_ptr<Piece> piece_;  // that the first engine is executing
  bool answering_ = false;        // its last call is being answered
  Followed followed_;             // what another engine is executing
  std::optional<Difference> difference_;
  bool went_on_ = false;
  ir::HostFunctionId false_fact_function_;  // none: facts are trusted
  std::optional<sim::HostEvent> false_fact_;
};

/// An argument of a host call, a word without a sign; but nothing counts up to where small negative numbers are.
std::string ArgumentText(ir::Type type, uint64_t value);
/// "fault(kind: PARAM_RANGE, index: 20)"
std::string ToText(const ir::Program& program, const sim::HostEvent& event);
std::string ToText(const ir::Program& program, const std::vector<sim::HostEvent>& events);

/// A value as messages show it: "1" for a bit, "18 (0x12)" for a byte, "-7 (0xFFFFFFF9)" for a double word with a sign,
/// "12.5 (0x41480000)" for a float.
std::string ValueText(ir::Type type, uint64_t value, sim::Sign sign = sim::Sign::kNone);

}  // namespace plcxx::engines
