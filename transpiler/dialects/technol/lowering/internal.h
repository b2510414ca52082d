// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
//
// Modules, mechanisms and groups of subprograms that share instructions are routines. RLO, registers and flags are
// registers in the sense of dialects/common: modules and mechanisms begin with zeros in them, subprograms share those
// of their callers.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/common/register.h"
#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/common/statement_texts.h"
#include "transpiler/dialects/technol/lowering/body.h"
#include "transpiler/dialects/technol/lowering/lowering.h"
#include "transpiler/dialects/technol/memory.h"
#include "transpiler/dialects/technol/register_file.h"
#include "transpiler/dialects/technol/value_builder.h"
#include "transpiler/ir/facts.h"

namespace plcxx::technol {

/// One operation in its three widths.
struct ByWidth {
  ir::OpKind narrow, word, wide;
  ir::OpKind At(uint32_t width) const { return width == 8 ? narrow : width == 16 ? word : wide; }
};

enum class HostCall : uint8_t {
  kReadInputs,
  kWriteOutputs,
  kMachineConstants,
  kRestore,
  kRequest,
  kSendPlcmem,
  kSendTabtech,
  kSetNcTable,
  kNcTableRefused,
  kBackupPos,
  kBackupMem,
  kCloseAll,
  kHaltPass,
  kErrorRaised,
  kFault,
  kCount
};
/// In the order of the enumerators of fault(): 8.1.
enum class Fault : uint8_t { kBounds, kLoop, kDivide, kBcdRange, kBcdDigit };

/// Label of a routine's end; the others are the number of their instruction and 1.
constexpr uint32_t kEndLabel = 0;

class Lowering {
 public:
  Lowering(const Program& tree, const Flow& flow, const Settings& settings, const source::SourceManager& sources);
  ir::Program Run();

 private:
  // --- routines (lowering.cc, lowering_bodies.cc) ---
  void InitialData();
  void FindWideRegisters();
  void FindBodies();
  void FindResumes(Body& body);
  void FindStretches(Body& body) const;
  void FindEntries(Body& body) const;
  void FindLeaving();
  void FindStopping();
  /// The mechanism that the instruction may stop.
  UnitId StoppedBy(const Instruction& instruction) const;
  /// May a call of the subprograms stop the mechanism?
  static bool MayStop(const Body& subprograms, UnitId mechanism) {
    return std::ranges::binary_search(subprograms.stops, mechanism);
  }
  void AddBodyRoutines();
  void LowerBody(Body& body);
  void BeginBody(Body& body);
  void BeginStretches(const Body& body);
  /// The number of the entry at which the pass begins; where jumps go back, in front of a loop around what follows.
  ir::ValueId ChosenEntry(const Body& body);
  /// The label at the end of the stretch in front of the one that begins at the instruction.
  uint32_t EndOfStretch(InstructionId next) const { return tree_.instructions.size() + next.index + 1; }
  /// Goes on in the region of the stretch that begins at the instruction, if one does.
  void EnterStretch(InstructionId id);
  void Execute(InstructionId id);
  void Dispatch(const Instruction& instruction);
  bool CanLeave(const Instruction& instruction) const;
  std::string CommentOf(const Body& body) const;
  const Body* BodyOfMechanism(UnitId mechanism) const;
  const Body* BodyOfModule(ModuleKind kind) const;
  /// `if (mechanism) mechanism()`.
  void CallMechanism(const Body& body);

  // --- statements (lowering_statements.cc) ---
  void CutStatements(const Body& body);
  void BeginStatement(size_t first, size_t end);
  void EndComments(const Body& body);
  uint32_t StatementNumber(size_t first, size_t end);
  void FindTargets();
  std::string SubjectOf(size_t first, size_t end) const;
  bool CanFault(InstructionId id) const;

  // --- bits, flags, jumps, calls (lowering_bits.cc) ---
  ir::ValueId ReadBit(const Operand& operand);
  void WriteBit(const Operand& operand, ir::ValueId value);
  void SetFlag(const Instruction& instruction);
  void Jump(InstructionId target, ir::ValueId condition);
  /// Goes to an entry by way of the choice at the head of the mechanism's loop.
  void JumpToEntry(size_t step, ir::ValueId condition, ir::RegionId refused);
  void JumpIfRlo(const Instruction& instruction, bool wanted);
  void Call(const Instruction& instruction);
  void Return();
  void RaiseError(const Instruction& instruction);
  InstructionId TargetOf(const Instruction& instruction) const;

  // --- mechanisms (lowering_waits.cc) ---
  void Wait();
  void WaitFor(const Instruction& instruction, uint64_t rlo);
  void WaitAtMost(const Instruction& instruction, uint64_t rlo);
  void Delay(const Instruction& instruction);
  /// Stores the step and leaves the routine.
  void Leave(InstructionId resume);
  ir::ValueId TimerLimit(const Operand& operand);
  void InitMechanism(const Instruction& instruction);
  void LeaveStopped(UnitId mechanism);
  /// Has a subprogram stopped the mechanism?
  ir::PlaceId StoppedPlace(UnitId mechanism);
  /// Step and automatic timers are 0; the bit is not touched.
  void Rewind(UnitId unit);
  void RewindIfCleared(UnitId unit);
  void RewindCleared();
  void EndMechanism(UnitId unit);
  ir::PlaceId StepPlace(UnitId unit);
  ir::PlaceId TimerPlace(UnitId unit, uint32_t number);
  /// Of a mechanism, or the NC's of a function module.
  ir::PlaceId ActivationPlace(UnitId unit);

  // --- DR (lowering_data.cc) ---
  void Load(const Instruction& instruction);
  void StoreData(const Instruction& instruction);
  void Combine(const Instruction& instruction, const ByWidth& operation);
  void MultiplyData(const Instruction& instruction);
  void DivideData(const Instruction& instruction);
  void RotateData(const Instruction& instruction);
  void Compare(const Instruction& instruction, ir::OpKind comparison);
  void ToBcd();
  void FromBcd();
  ir::ValueId Dr(uint32_t width);
  void SetDr(ir::ValueId value, uint32_t width);

  // --- inline assembler (lowering_assembler.cc, _shifts.cc, _multiply.cc) ---
  void Assemble(const Instruction& instruction);
  void AddOrSubtract(const Instruction& instruction);
  void Logic(const Instruction& instruction);
  void Increment(const Instruction& instruction);
  void Negate(const Instruction& instruction);
  void Exchange(const Instruction& instruction);
  void Extend(const Instruction& instruction);
  void Push(const Instruction& instruction);
  void Pop(const Instruction& instruction);
  void Decimal(const Instruction& instruction);
  void Unpack(const Instruction& instruction);
  void LoopJump(const Instruction& instruction);
  void Shift(const Instruction& instruction);
  void ShiftByConstant(const Instruction& instruction, uint32_t count);
  void ShiftByCl(const Instruction& instruction);
  ir::ValueId Shifted(Op op, ir::ValueId value, ir::ValueId count, uint32_t width);
  ir::ValueId ShiftedOut(Op op, ir::ValueId value, ir::ValueId count, uint32_t width);
  void Rotate(const Instruction& instruction);
  void RotateWithCarry(const Instruction& instruction);
  void MultiplyRegister(const Instruction& instruction);
  void DivideRegister(const Instruction& instruction);

  // --- flags (lowering_flags.cc) ---
  /// Is the flag read on some path behind the instruction?
  bool Wants(Resources flag) const { return (wanted_flags_ & flag) != 0; }
  template <class Compute>
  void Flag(Resources flag, Compute&& compute);
  /// The flag as it was where `count` is 0.
  template <class Compute>
  void KeepUnless(Resources flag, ir::ValueId count, Compute&& compute);
  void ResultFlags(ir::ValueId result, uint32_t width);
  void UndefineFlags(Resources flags);
  ir::ValueId Sign(ir::ValueId value, uint32_t width);
  ir::ValueId IsZero(ir::ValueId value, uint32_t width);
  /// The condition of an assembler jump.
  ir::ValueId Condition(Op op);
  ir::ValueId FlagValue(Resources flag);

  // --- memory (lowering_places.cc) ---
  /// A value of the operand's width: memory, constant or register.
  ir::ValueId Read(const Operand& operand);
  /// The same as the operand `width` bits wide of an operation on DR: zero-extended, constants modulo 2^width.
  ir::ValueId ReadAs(const Operand& operand, uint32_t width);
  void Write(const Operand& operand, ir::ValueId value);
  ir::PlaceId PlaceAt(const Operand& operand);
  ir::PlaceId BitPlace(Area area, uint32_t offset, uint8_t bit, std::string name);
  ir::PlaceId CellPlace(Area area, uint32_t offset, ir::Type type, std::string name);
  ir::PlaceId IndexedPlace(const Operand& operand, uint32_t offset);
  ir::PlaceId SystemPlace(std::string_view symbol);
  const Symbol* FindSymbol(std::string_view name) const;
  std::string NameOf(const Operand& operand) const;
  /// The index of an indexed access, behind the report of one that is outside.
  struct Reach {
    ir::PlaceId place;
    ir::ValueId index;
  };
  Reach ReachOf(const Operand& operand);
  /// Of what an instruction reads and writes: reached, and reported, once. A register has no place.
  Reach ReachOfTarget(const Operand& operand) {
    return operand.kind == OperandKind::kMemory ? ReachOf(operand) : Reach{};
  }
  ir::ValueId ReadAt(const Operand& operand, const Reach& reach);
  void WriteAt(const Operand& operand, const Reach& reach, ir::ValueId value);
  /// The values that an i32, read as signed, can have.
  struct Bounds32 {
    int64_t low = -0x80000000LL, high = 0x7FFFFFFFLL;
  };
  Bounds32 BoundsOf(ir::ValueId value) const;
  ir::PlaceId AddLocal(std::string name, ir::Type type);
  /// A register or what else lives as long as the routine that is lowered, and the subprograms that it calls.
  ir::PlaceId Local(std::string_view name, ir::Type type);
  /// The same, but of the routine alone.
  ir::PlaceId OwnLocal(std::string name, ir::Type type);

  // --- the host (lowering_host.cc), the schedule (lowering_schedule.cc) ---
  void CallFault(Fault fault);
  /// With --set bounds=trap a fault leaves everything.
  void LeaveAll();
  void AddHostFunctions();
  void AddScheduleRoutines();
  void Init();
  void Slow();
  void Period();
  void Requests();
  bool CanRequest(std::string_view bit) const;
  /// Runs `transfer` with the fields of SET_NCTAB when they are valid, else tells the host which one is not (8.4).
  void CheckNcTable(const std::function<void(std::vector<ir::ValueId>)>& transfer);
  ir::PlaceId NeverPlace();
  void RunFunctions(ModuleKind kind, std::string_view bit);
  void FillSchedule();
  bool IsUsed(Area area) const;

  // --- documentation (lowering_documentation.cc) ---
  void Document();
  void DocumentErrors();
  std::string CommentText(const Symbol& symbol) const;

  const Program& tree_;
  const Flow& flow_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program program_;
  ValueBuilder builder_{program_};
  ir::FactChecks facts_{builder_};
  RegisterFile registers_{builder_, facts_};
  Memory memory_;

  std::vector<Body> bodies_;
  std::unordered_map<uint32_t, uint32_t> body_of_unit_;
  std::vector<uint32_t> body_of_subprogram_;       // by Flow's numbers
  Body* body_ = nullptr;                           // the one being lowered
  InstructionId now_;                              // the instruction being lowered
  uint32_t width_ = 16;                            // of DR before it
  Resources wanted_flags_ = 0;                     // behind it
  std::vector<bool> begins_statement_, label_at_;  // of the body's instructions
  bool end_is_used_ = false;
  struct Stretch {
    ir::RegionId region;
    bool is_jumped_to = false;  // from the one before it
  };
  std::map<InstructionId, Stretch> stretches_;  // by their first instruction, the tail among them
  ir::InstId loop_;                             // of a mechanism whose jumps go back
  ir::PlaceId chosen_;                          // the entry that its next round begins at
  ir::StatementId statement_;
  std::vector<size_t> index_in_body_;  // by InstructionId, of the body's instructions

  /// What the last difference or logic operation of this statement compared.
  struct {
    ir::ValueId left, right;  // none: nothing
    uint32_t width = 0;
  } compared_;

  std::map<std::tuple<Area, uint32_t, ir::Type, uint8_t>, ir::PlaceId> places_;
  std::map<std::tuple<Area, uint32_t, ir::Type>, ir::PlaceId> indexed_;
  std::map<uint32_t, ir::PlaceId> steps_, activations_;          // by UnitId
  std::vector<uint32_t> mechanisms_before_;                      // in the source, by UnitId
  std::map<std::pair<uint32_t, uint32_t>, ir::PlaceId> timers_;  // by UnitId and number
  std::map<std::string, ir::PlaceId> locals_, own_locals_;       // by name; of all routines, of the body alone
  std::map<uint32_t, ir::SpaceId> own_spaces_;                   // locals of one routine alone, by its number
  uint32_t step_bytes_ = 0, local_count_ = 0;
  dialects::HostCalls<HostCall> host_{builder_};
  ir::RoutineId init_, fast_, slow_, requests_, period_, fast_only_;

  std::vector<source::Range> waiting_comments_;
  dialects::StatementIds statement_ids_;
  std::vector<bool> is_target_;              // by InstructionId: jumped to or called, from any routine
  std::vector<uint32_t> statement_numbers_;  // by InstructionId of the first one; 0: none yet
  source::Range last_lines_;                 // of the statement before
};

template <class Compute>
void Lowering::KeepUnless(Resources flag, ir::ValueId count, Compute&& compute) {
  if (!Wants(flag)) return Flag(flag, compute);
  const ir::ValueId old = FlagValue(flag);
  const ir::ValueId moves = builder_.Pure(ir::OpKind::kNotEqual32, {count, builder_.Number(0)});
  const ir::ValueId changed = builder_.Pure(ir::OpKind::kBitAnd, {moves, compute()});
  const ir::ValueId kept = builder_.Pure(ir::OpKind::kBitAnd, {builder_.Not(moves), old});
  Flag(flag, [&] { return builder_.Pure(ir::OpKind::kBitOr, {changed, kept}); });
}

template <class Compute>
void Lowering::Flag(Resources flag, Compute&& compute) {
  dialects::Register& reg = registers_.Flag(flag);
  if (Wants(flag)) {
    reg.Set(compute());
  } else {
    reg.Forget();  // nobody asks
  }
}

}  // namespace plcxx::technol
