// Several engines of one program as one: every command goes to each, and after each period their states are compared.
//
// In: a simulator, compiled code, or both. Out: the engine that a scenario drives, and the first difference. The first
// engine answers for all. Its host calls are answered by whoever drives the scenario; the others, which execute the
// same period after it, must make the same calls and get the same answers, with the same changes of memory. Not its
// job: what a difference means for a scenario (scenario_run.h).
#pragma once

#include <cstdint>
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

  const std::vector<std::unique_ptr<sim::Engine>>& engines() const { return engines_; }
  /// The first one since the beginning; stays.
  const std::optional<Difference>& difference() const { return difference_; }
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
  /// Each engine executes a piece of the program, the first one before the others.
  void Execute(uint32_t now_ms, const Change& piece);
  /// To each engine; while a call of the first one is answered to that one only, the others follow at the same call.
  void Each(Change change);
  sim::HostAnswer AnswerFirst(ir::HostFunctionId function, std::span<const uint64_t> arguments);
  sim::HostAnswer AnswerAgain(sim::Engine& engine, ir::HostFunctionId function, std::span<const uint64_t> arguments);
  void CallsDiffer(const sim::Engine& other, const std::string& first, const std::string& second);
  void Compare(uint32_t now_ms);
  void CompareEvents(sim::Engine& other, const std::vector<sim::HostEvent>& expected);
  void CompareStates(sim::Engine& other, const std::vector<uint8_t>& expected, uint32_t now_ms);

  const ir::Program& program_;
  std::vector<std::unique_ptr<sim::Engine>> engines_;
  std::vector<sim::HostEvent> events_;
  sim::HostAnswers answers_;
  std::vector<sim::AnsweredCall> calls_;  // of the piece that is being executed
  size_t repeated_ = 0;                   // those that the engine which is executing has made, too
  bool has_answers_ = false;              // that engine has taken the answers with the changes (ExpectCalls)
  bool answering_ = false;                // the last one of calls_ is being answered
  uint32_t now_ms_ = 0;
  std::optional<Difference> difference_;
  ir::HostFunctionId false_fact_function_;  // none: facts are trusted
  std::optional<sim::HostEvent> false_fact_;
};

/// "fault(kind: PARAM_RANGE, index: 20)"
std::string ToText(const ir::Program& program, const sim::HostEvent& event);
std::string ToText(const ir::Program& program, const std::vector<sim::HostEvent>& events);

/// A value as messages show it: "1" for a bit, "18 (0x12)" for a byte, "-7 (0xFFFFFFF9)" for a double word with a sign,
/// "12.5 (0x41480000)" for a float.
std::string ValueText(ir::Type type, uint64_t value, sim::Sign sign = sim::Sign::kNone);

}  // namespace plcxx::engines
