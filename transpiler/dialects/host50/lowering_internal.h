// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/host50/lowering.h"
#include "transpiler/dialects/host50/places.h"
#include "transpiler/ir/facts.h"

namespace plcxx::host50 {

enum class HostCall : uint8_t { kReadInputs, kWriteOutputs, kRetentiveLoad, kAlarm, kAxisCommand, kFault, kCount };
enum class Fault : uint8_t { kJumpLoop, kRotRange, kAxisRange };
enum class Relation : uint8_t { kEqual, kNotEqual, kGreater, kGreaterEqual, kLess, kLessEqual };

/// A stretch of numbers of one area; of a timer or counter all its attributes.
struct Stretch {
  Area area{};
  uint32_t first = 0, last = 0;
};
/// What an instruction writes.
struct WriteSet {
  bool everything = false;  // a subroutine is called
  std::vector<Stretch> stretches;
};

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources);
  ir::Program Run();

 private:
  /// What is known of an instruction's result while its network is lowered.
  struct Result {
    ir::ValueId value;    // in this statement; none: computed where it is used
    ir::ValueId contact;  // of an edge: its value, taken where the instruction stands
    uint32_t uses = 0;    // by instructions still to come
  };
  /// What is being lowered.
  struct Current {
    SectionId section;
    NetworkId network;
    ir::PlaceId jumps_left;  // none: the section has no way back
    ir::PlaceId cursor;      // SLICED with jumps: the network that comes next
    uint32_t end_label = 0;
    bool end_is_used = false;
    uint32_t period_ms = 1;
    uint32_t statement_id = 0;
  };

  // --- sections, networks, statements (lowering.cc) ---
  void Sections();
  void LowerSection(SectionId id, ir::RegionId body);
  void BeginNetwork(NetworkId id);
  void LowerNetwork(NetworkId id);
  void LowerRung(Span rung);
  void EndSection();
  /// The section's jumps may be refused from here on; an own place for each section that has a way back.
  void CountJumps(ir::Lifetime lifetime);
  void BeginStatement(Span rung);
  /// Marks what follows; the comments that wait stand above it. Gives the statement's number.
  uint32_t AddStatement(source::Range range, std::string subject);
  void AddComments(Span comments);
  source::Range TextOf(source::Range comment) const;
  source::Range LinesOf(source::Range first, source::Range last, bool is_drawing) const;
  std::string SubjectOf(Span rung) const;
  void FindJumps();
  uint32_t LineOf(InstructionId id) const;
  std::vector<Span> RungsOf(const Network& network) const;
  bool Acts(const Instruction& instruction) const;

  // --- results (lowering_rungs.cc) ---
  void CountUses(Span instructions);
  void Execute(InstructionId id);
  void TakeEdge(InstructionId id);
  /// Blocks and coils that act only while their input is 1: `if (input) { ... }`, one for neighbours of one input.
  void ActIf(InstructionId id);
  ir::ValueId TakeInput(const Input& input);
  ir::ValueId Take(InstructionId id);
  void Compute(std::vector<InstructionId> wanted);
  ir::ValueId ComputeOne(InstructionId id);
  /// Computes results before something that would change them.
  void Keep(const std::vector<InstructionId>& results);
  void Coil(const Instruction& instruction);
  ir::ValueId ContactOf(InstructionId id);
  bool IsContactAlone(const Instruction& instruction) const;
  /// Results that later instructions use and that `writes` would change.
  std::vector<InstructionId> Endangered(const WriteSet& writes);
  bool ReadsAny(InstructionId id, const WriteSet& writes);
  bool SameInput(const Input& a, const Input& b) const;
  /// The input's results have one user less, or one more.
  void Release(const Input& input);
  void Retain(const Input& input);
  ir::ValueId And(ir::ValueId a, ir::ValueId b);
  ir::ValueId Or(ir::ValueId a, ir::ValueId b);
  ir::ValueId Not(ir::ValueId a);
  bool IsConstant(ir::ValueId value, uint64_t constant) const;
  /// The instructions whose results an instruction takes.
  template <class Visit>
  void ForEachTaken(const Instruction& instruction, Visit&& visit) const;

  // --- what instructions read and write (lowering_effects.cc) ---
  WriteSet WritesOf(const Instruction& instruction) const;
  bool ReadsOwn(const Instruction& instruction, const WriteSet& writes) const;
  bool ExprReads(ExprId id, const WriteSet& writes) const;

  // --- blocks (lowering_blocks.cc) ---
  void Jump(const Instruction& instruction);
  void Act(const Instruction& instruction);
  void Calculate(const Instruction& instruction);
  void Negate(const Instruction& instruction);
  void Move(const Instruction& instruction);
  void BitsToWord(const Instruction& instruction);
  void WordToBits(const Instruction& instruction);
  void Assign(const Instruction& instruction);
  void CallFault(Fault fault);

  // --- timers, counters, ROT (lowering_elements.cc) ---
  ir::ValueId Element(const Instruction& instruction);
  ir::ValueId StepTimer(const Instruction& instruction, ir::ValueId input);
  ir::ValueId StepCounter(const Instruction& instruction, ir::ValueId input);
  ir::ValueId Rotate(const Instruction& instruction, ir::ValueId input);
  ir::ValueId PinValue(const Pin& pin);

  // --- PLC axes (lowering_axes.cc) ---
  /// One axis block; the numbers are known where it is active.
  struct AxisRequest {
    const Instruction* instruction = nullptr;
    const AxisBlock* block = nullptr;
    uint32_t kind = 0;
    ir::StateId state;
    ir::ValueId method, position, speed;
  };
  void CommandAxis(InstructionId id);
  void CommandKnownAxis(AxisRequest request, uint32_t axis, ir::ValueId input);
  void CommandComputedAxis(AxisRequest request, ir::ValueId axis, ir::ValueId input);
  void StopAxis(const AxisRequest& request, ir::ValueId axis);
  void ReadNumbers(AxisRequest& request);
  void WriteAxisSignals(const AxisRequest& request, uint32_t axis);
  /// Tells the control when the request is new or other than before.
  void SendRequest(const AxisRequest& request, ir::ValueId axis);
  /// Whether a position or speed is another than the one last sent.
  ir::ValueId RealsDiffer(ir::ValueId now, ir::ValueId before);
  void SwitchOverAxes(ir::ValueId axis, const std::function<void(uint32_t)>& arm);
  ir::PlaceId AxisField(const AxisRequest& request, std::string_view field);

  // --- numbers (lowering_expressions.cc) ---
  ir::ValueId Number(const Operand& operand, Type wanted);
  ir::ValueId Constant(uint32_t bits, Type type, Type wanted, source::Range spelled);
  ir::ValueId Convert(ir::ValueId value, Type from, Type to);
  ir::ValueId Evaluate(ExprId id, Type wanted);
  ir::ValueId EvaluateExpr(const Expr& expr);
  ir::ValueId Compare(Relation relation, ir::ValueId a, ir::ValueId b, Type type);
  ir::ValueId Comparison(const Instruction& instruction);

  // --- memory (lowering_places.cc) ---
  void CollectSymbols();
  ir::PlaceId PlaceOf(const Address& address);
  ir::ValueId Load(const Address& address) { return builder_.Load(PlaceOf(address)); }
  void Store(const Address& address, ir::ValueId value);
  /// "PUMP", "Q0", "T_RUN.Q": as the source calls it, by its symbol if there is one.
  std::string SpelledName(const Address& address) const;
  /// The same, by the address where the symbol has characters that a name in C++ does not.
  std::string NameInCode(const Address& address) const;
  ir::StateId InstanceOf(const Address& timer_or_counter);
  /// Edges and axis blocks, one for each instruction: named by what they look at, and by their statement where another
  /// one looks at the same.
  ir::StateId OwnInstance(InstructionId id);
  std::string OwnName(const Instruction& instruction) const;
  void CountOwnNames();
  ir::PlaceId NewSystemPlace(std::string name, ir::Type type);
  ir::PlaceId NewLocal(std::string name);

  // --- SLICES=SLICED (lowering_slices.cc) ---
  void SlicedSlow(SectionId id);
  std::vector<uint32_t> SliceOfNetworks(const Section& section) const;
  bool JumpsLeaveSlices(const Section& section, const std::vector<uint32_t>& slices) const;
  void SlicesByChoice(const Section& section, const std::vector<uint32_t>& slices);
  void SlicesByCursor(const Section& section, const std::vector<uint32_t>& slices);
  void EndSliceBefore(uint32_t index, uint32_t slice);

  // --- the schedule (lowering_schedule.cc) ---
  void AddRoutines();
  void Init();
  void Period();
  void RunSlow();
  void ReportAlarms();
  void Schedule();

  // --- tables (lowering_tables.cc), documentation (lowering_documentation.cc) ---
  void Tables();
  void Title();
  void MCodes();
  void RecordSettings();
  void Document();

  const Program& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  ir::FactChecks facts_{builder_};
  dialects::StatementIds statement_ids_;

  Current now_;
  std::vector<Result> results_;         // by InstructionId
  std::vector<InstructionId> pending_;  // of the statement: not yet computed, and used by instructions still to come
  struct {
    ir::RegionId then;  // none: no `if` is open
    Input input;
  } open_if_;

  std::vector<bool> is_target_;                          // by NetworkId: an LBL goes there
  std::vector<bool> has_way_back_;                       // by SectionId
  std::vector<ir::RoutineId> routines_;                  // by SectionId; FAST and SLOW too
  std::unordered_map<uint32_t, ir::PlaceId> places_;     // by KeyOf
  std::unordered_map<uint32_t, ir::StateId> instances_;  // by KeyOf, without attribute
  std::vector<ir::StateId> own_instances_;               // by InstructionId
  std::unordered_map<std::string, uint32_t> own_names_;  // how many instructions want the name
  std::unordered_map<uint32_t, SymbolId> symbols_;       // by KeyOf: the one that names the address
  std::vector<Address> used_;
  std::vector<InstructionId> edges_;  // in order
  dialects::HostCalls<HostCall> host_{builder_};
  std::bitset<kAlarmCount> driven_alarms_;
  ir::RoutineId init_, fast_, slow_, period_;
  ir::PlaceId tick_, slow_done_, slice_;
  uint32_t next_local_ = 0;  // bytes of the space of locals

  std::vector<source::Range> waiting_comments_;  // printed above the next statement
};

/// One number for each address.
constexpr uint32_t KeyOf(const Address& address) {
  return static_cast<uint32_t>(address.area) << 20 | static_cast<uint32_t>(address.attribute) << 18 | address.number;
}

constexpr uint32_t kMostJumps = 10'000;  // backward, for each execution of a section (4.8)

inline const Operand& OperandOf(const Program& tree, const Instruction& instruction, uint32_t index) {
  PLCXX_CHECK(index < instruction.operands.count);
  return tree.operands[instruction.operands.first + index];
}

template <class Visit>
void Lowering::ForEachTaken(const Instruction& instruction, Visit&& visit) const {
  for (uint32_t i = 0; i < instruction.input.results.count; ++i) {
    if (instruction.input.kind == InputKind::kResults) visit(tree_.results[instruction.input.results.first + i]);
  }
  if (instruction.other.valid()) visit(instruction.other);
  for (uint32_t i = 0; i < instruction.pins.count; ++i) {
    const Pin& pin = tree_.pins[instruction.pins.first + i];
    if (pin.from_stack) visit(pin.result);
  }
}

}  // namespace plcxx::host50
