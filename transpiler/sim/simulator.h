// Executes a program as it is: structured IR, one instruction after the other.
//
// In: a structured program whose sliced routines are cut (or have one slice); it must outlive the simulator. Out: the
// Engine of engine.h. Total: an access out of bounds reads 0 and writes nothing, every loop ends by its bound. Not its
// job: time (clock.h), what a control does around its partitions (that is a routine of the program).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/execution.h"

namespace plcxx::sim {

class Simulator : public Engine {
 public:
  explicit Simulator(const ir::Program& program) : execution_(program) {}

  std::string_view name() const override { return "simulator"; }
  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void AnswerHostCalls(HostAnswers answers) override { execution_.host.AnswerWith(std::move(answers)); }
  uint64_t Read(const ir::Place& place) override;
  void Write(const ir::Place& place, uint64_t value) override;
  std::span<const uint8_t> Memory(ir::SpaceId space) const override {
    return execution_.memory.spaces()[space.index].bytes();
  }
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void SendText(std::string_view text) override { execution_.memory.SendText(text); }
  void EnableStatement(ir::StatementId statement, bool enabled) override {
    execution_.switched_off.Set(statement, !enabled);
  }
  void StoreRetentive() override { execution_.memory.StoreRetentive(); }
  std::vector<HostEvent> TakeEvents() override { return execution_.host.TakeEvents(); }
  std::vector<uint8_t> Snapshot() override { return execution_.memory.Snapshot(); }

  /// Everything that decides the future, at the end of a part; not which writes were noted.
  using Saved = sim::Memory::Saved;
  Saved Save() const { return execution_.memory.Save(); }
  /// Goes back, or to what another simulator of this program has saved; events that nobody took are gone.
  void Restore(const Saved& saved);
  /// Goes where `other` is, which becomes what this one was; of one program. Events that nobody took are gone.
  void Exchange(Saved& other);
  /// Whether both go on alike, and look alike to the host.
  bool IsAt(const Saved& other) const { return execution_.memory.IsAt(other); }

  /// What decides nothing, but is told of: who wrote last, and since when the clock runs.
  struct Noted {
    Time time;
    LastWrites writes;
  };
  Noted SaveNoted() const;
  void RestoreNoted(const Noted& noted);

  /// From now on every write is noted; costs time, so it is off at first.
  void RecordLastWrites() { execution_.recorder.Begin(); }
  /// None unless RecordLastWrites was called.
  const LastWrites* last_writes() const { return execution_.recorder.writes(); }
  /// Asked now and then while a routine runs: true ends the run where it is, for a program may take for ever within one
  /// period. After that the memory is that of a period half done, and only good for being looked at.
  void StopWhen(std::function<bool()> stop) { execution_.stop = std::move(stop); }
  bool stopped() const { return execution_.stopped; }
  /// Called before each statement that is executed, also one that is switched off; true ends the run there, as StopWhen
  /// does.
  void AtStatements(std::function<bool(ir::StatementId statement)> at) { execution_.at_statement = std::move(at); }
  /// From now on what each instruction gave is noted, by InstId, in bytes that the caller keeps and may clear: kGave0,
  /// kGaveOther. One without a value gives 0. None: it ends.
  static constexpr uint8_t kGave0 = Execution::kGave0, kGaveOther = Execution::kGaveOther;
  void NoteGiven(std::span<uint8_t> given) { execution_.given = given; }
  /// What is executed otherwise than the program says, or looked for.
  Changes& changes() { return execution_.changes; }
  const Instances& instances() const { return execution_.memory.instances(); }
  /// What an instruction gave when it was executed last, as raw bits.
  uint64_t ValueOf(ir::ValueId id) const { return execution_.values[id.index]; }
  /// Instructions executed so far, those of switched-off statements not counted.
  uint64_t executed() const { return execution_.executed; }

 private:
  void RunAt(uint32_t now_ms, ir::RoutineId partition);
  void NoteWrite(Writer writer, const PlaceAccess& access);
  void BeginAnew();

  Execution execution_;
};

}  // namespace plcxx::sim
