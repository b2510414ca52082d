// Executes a program as it is: structured IR, one instruction after the other.
//
// In: a structured program whose sliced routines are cut (or have one slice); it must outlive the simulator. Out: the
// Engine of engine.h. Total: an access out of bounds reads 0 and writes nothing, every loop ends by its bound. Not its
// job: time (clock.h), what a control does around its partitions (that is a routine of the program).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/changed_inst.h"
#include "transpiler/sim/decoded.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/forced_bytes.h"
#include "transpiler/sim/instances.h"
#include "transpiler/sim/last_writes.h"
#include "transpiler/sim/local_stretches.h"
#include "transpiler/sim/place_access.h"
#include "transpiler/sim/rungs.h"

namespace plcxx::sim {

class Simulator : public Engine {
 public:
  explicit Simulator(const ir::Program& program);

  std::string_view name() const override { return "simulator"; }
  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void AnswerHostCalls(HostAnswers answers) override { answers_ = std::move(answers); }
  uint64_t Read(const ir::Place& place) override;
  void Write(const ir::Place& place, uint64_t value) override;
  std::span<const uint8_t> Memory(ir::SpaceId space) const override { return spaces_[space.index].bytes(); }
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void SendText(std::string_view text) override;
  void EnableStatement(ir::StatementId statement, bool enabled) override;
  void StoreRetentive() override;
  std::vector<HostEvent> TakeEvents() override;
  std::vector<uint8_t> Snapshot() override;

  /// Everything that decides the future, at the end of a part; not which writes were noted.
  struct Saved {
    std::vector<ForcedBytes> spaces;
    Instances instances;
    std::optional<std::vector<uint8_t>> stored;
  };
  Saved Save() const { return {.spaces = spaces_, .instances = instances_, .stored = stored_}; }
  /// Goes back, or to what another simulator of this program has saved; events that nobody took are gone.
  void Restore(const Saved& saved);

  /// Goes where `other` is, which becomes what this one was; of one program. Events that nobody took are gone.
  void Exchange(Saved& other);
  /// Whether both go on alike, and look alike to the host.
  bool IsAt(const Saved& other) const;

  /// What decides nothing, but is told of: who wrote last, and since when the clock runs.
  struct Noted {
    uint32_t now_ms = 0;
    uint64_t whole_ms = 0;
    LastWrites writes;
  };
  Noted SaveNoted() const;
  void RestoreNoted(const Noted& noted);

  /// From now on every write is noted; costs time, so it is off at first.
  void RecordLastWrites();
  /// None unless RecordLastWrites was called.
  const LastWrites* last_writes() const { return last_writes_.get(); }
  /// Asked now and then while a routine runs: true ends the run where it is, for a program may take for ever within one
  /// period. After that the memory is that of a period half done, and only good for being looked at.
  void StopWhen(std::function<bool()> stop) { stop_ = std::move(stop); }
  bool stopped() const { return stopped_; }
  /// Called before each statement that is executed, also one that is switched off; true ends the run there, as StopWhen
  /// does.
  void AtStatements(std::function<bool(ir::StatementId statement)> at) { at_statement_ = std::move(at); }
  /// From now on what each instruction gave is noted, by InstId, in bytes that the caller keeps and may clear: kGave0,
  /// kGaveOther. One without a value gives 0. None: it ends.
  static constexpr uint8_t kGave0 = 1, kGaveOther = 2;
  void NoteGiven(std::span<uint8_t> given) { given_ = given; }
  /// From now on the program is executed with this change; none: as it is. A loop that has a proven bound and comes to
  /// it is then ended as StopWhen ends it.
  void Change(const std::optional<ChangedInst>& changed);
  /// From now on it is noted where one of these would make a difference: of what is computed, the result; of what is
  /// not stored, the memory; of all else, that it is executed with another operand. By number; costs time.
  void LookForDifferences(const std::vector<ChangedInst>& changes);
  /// Only those that are looked for are found; all are at first, and none of those that were found.
  void LookFor(uint32_t change, bool wanted) { differences_[change].wanted = wanted; }
  /// Found since the last call, each once.
  std::vector<uint32_t> TakeDifferences() { return std::exchange(found_, {}); }
  const Instances& instances() const { return instances_; }
  /// What an instruction gave when it was executed last, as raw bits.
  uint64_t ValueOf(ir::ValueId id) const { return values_[id.index]; }
  /// Instructions executed so far, those of switched-off statements not counted.
  uint64_t executed() const { return executed_; }

 private:
  /// The functions of decoded instructions.
  struct Functions;

  /// The statement whose instructions are being executed.
  struct Current {
    ir::StatementId statement;
    bool skipped = false;        // switched off: its instructions have no effect
    bool head_is_false = false;  // the head of a block, switched off: its condition counts as false
  };

  void SetTime(uint32_t now_ms);
  void Run(ir::RoutineId routine);
  /// With its named locals 0.
  void RunPartition(ir::RoutineId routine);
  void BeginLocals(const LocalStretches& locals);
  /// Those of the callers, while a partition runs that may use the same ones.
  void KeepLocals(const LocalStretches& locals);
  void PutBackLocals(const LocalStretches& locals, size_t from);
  /// Once it has stopped, what is left is no block or loop (`leaving_`), so that everything is left.
  Flow Execute(ir::RegionId region);
  /// All instructions of a region, where none is switched off and nobody is asked at statements.
  template <bool kNotes>
  Flow ExecuteAll(const DecodedRegion& region);
  Flow ExecuteWithCare(ir::RegionId region);
  bool is_careful() const { return switched_off_count_ > 0 || at_statement_ || looks_for_differences_; }

  // --- changes (simulator_changes.cc) ---
  /// A changed instruction as it is executed.
  struct Changed {
    ChangedInst what;
    ir::Inst inst;
    std::optional<ir::Call> call;  // of a call with a changed argument
    uint32_t operand = 0;          // kOperand: the value that stands there in the program
    bool wanted = true;            // is looked for
  };
  Changed MakeChanged(const ChangedInst& what) const;
  /// The region of the change.
  Flow ExecuteChangedRegion(const DecodedRegion& region);
  static bool IsRung(const Decoded& inst);
  Flow ExecuteChangedRung(const Decoded& rung);
  Flow ExecuteChangedInst();
  Flow ExecuteLookingForDifferences(const Decoded& inst);
  bool DiffersBefore(const Changed& changed);
  bool DiffersInResult(const Changed& changed);
  /// `inst` as it is here, its result at `id`.
  Flow ExecuteAs(ir::InstId id, const ir::Inst& inst);
  uint32_t NumberValue() const { return static_cast<uint32_t>(program_.insts.size()); }
  uint32_t OtherResult() const { return NumberValue() + 1; }
  const ir::Call& CallOf(const ir::Inst& inst) const {
    return inst.payload == program_.calls.size() ? *changed_->call : program_.calls[ir::CallId(inst.payload)];
  }

  void Note(uint32_t id) { given_[id] = static_cast<uint8_t>(given_[id] | (values_[id] != 0 ? kGaveOther : kGave0)); }
  void Decode();
  void FindRungs(DecodedRegion& region);
  /// Where bits of rungs stand, which may be other memory after a Restore.
  void FindBases();
  Decoded DecodedOf(ir::InstId id) const;

  /// Of a statement that is switched off: the other statements in the regions that its jumps made.
  Flow ExecuteOthers(ir::InstId id, const ir::Inst& inst);
  // One for each operation that is the IR's own.
#define PLCXX_PURE(...)
#define PLCXX_STEP(...)
#define PLCXX_CORE(Kind, ...) Flow Execute##Kind(ir::InstId id, const ir::Inst& inst);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE

  /// Counts what may repeat, and asks `stop_` for each so many.
  bool Stops();
  /// What an Exit means for the block or loop that it has come to.
  Flow Leave(ir::InstId block);
  HostAnswer CallHost(const ir::Call& call);
  void LoadRetentive();

  /// Of an indexed place `index` says which element; of others it is 0.
  uint64_t Get(const PlaceAccess& access, uint64_t index) const;
  void Set(const PlaceAccess& access, uint64_t index, uint64_t value, Writer writer);
  /// After an operation on an instance: its forces are put back, its fields are written.
  void Stepped(uint32_t instance);
  LastWrite NewWrite(Writer writer) const;
  void NoteField(uint32_t instance, uint8_t field, LastWrite write);

  const ir::Program& program_;
  std::vector<PlaceAccess> places_;     // by PlaceId
  std::vector<ForcedBytes> spaces_;     // by SpaceId
  std::vector<LocalStretches> locals_;  // by RoutineId
  std::vector<uint8_t> kept_locals_;    // of all callers, the innermost at the end
  Instances instances_;
  std::vector<uint64_t> values_;  // by ValueId, raw bits; constants are there from the start
  std::vector<Decoded> decoded_;
  std::vector<uint32_t> decoded_at_;            // by InstId: in decoded_
  std::vector<DecodedRegion> decoded_regions_;  // by RegionId
  std::vector<Decoded> ready_;                  // what is executed; see DecodedRegion
  std::vector<LogicStep> logic_;
  std::vector<const unsigned char*> bases_;  // by BitBase
  std::vector<bool> switched_off_;           // by StatementId
  size_t switched_off_count_ = 0;
  Current current_;
  ir::InstId leaving_;
  bool repeats_ = false;  // what leaves is a Repeat: another round of the loop it names
  uint32_t now_ms_ = 0;
  uint64_t whole_ms_ = 0;  // the same since power-on, without wrapping
  uint64_t executed_ = 0;
  std::function<bool()> stop_;
  std::function<bool(ir::StatementId)> at_statement_;
  std::span<uint8_t> given_;
  std::optional<Changed> changed_;
  ir::RegionId changed_region_;
  uint32_t changed_entry_ = 0;               // in ready_: what executes the change
  std::vector<Changed> differences_;         // by number
  std::vector<uint32_t> differences_begin_;  // by InstId: in differences_in_order_
  std::vector<uint32_t> differences_in_order_;
  std::vector<uint32_t> found_;
  bool looks_for_differences_ = false;
  uint32_t regions_ = 0;  // begun since `stop_` was asked
  bool stopped_ = false;
  std::vector<HostEvent> events_;
  HostAnswers answers_;
  std::optional<std::vector<uint8_t>> stored_;  // the host's store: all retentive spaces in order
  std::unique_ptr<LastWrites> last_writes_;
};

}  // namespace plcxx::sim
