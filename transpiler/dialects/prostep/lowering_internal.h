// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
//
// Every module is a routine. S and AX are registers (dialects/common/register.h) that begin as 0 where only the
// scheduler enters a module; a module that is called shares the places of its caller.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/common/register.h"
#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/common/statement_texts.h"
#include "transpiler/dialects/prostep/lowering.h"
#include "transpiler/dialects/prostep/memory.h"
#include "transpiler/ir/facts.h"

namespace plcxx::prostep {

/// Scalars of the scheduler and of the registers.
enum class ScalarPlace : uint8_t {
  // space `system`, as long as the machine has power
  kNow,         // time of the last period in ms, simulation only
  kOfSecond,    // t modulo 1000
  kSlowDone,    // complete slow passes
  kSlowRounds,  // what is left of the loop budget of the slow pass that is going on
  kRounds,      // the same of the partition that is running
  kNextSlice,
  // space `registers`, as long as a partition runs
  kS,
  kAx,
  kFirst,  // with --set first-check=dynamic
  kNcValue,
  kPortWord,  // a time or preset that comes from a port
  kCount
};

enum class HostCall : uint8_t {
  kNow,
  kReadPort,
  kWritePort,
  kNcRead,
  kNcWrite,
  kNcToPlc,
  kPlcToNc,
  kRetentiveLoad,
  kFault,
  kCount
};
/// In the order of the enumerators of fault(): 8.1.
enum class Fault : uint8_t { kDivZero, kDivOverflow, kIndex, kNcAccess, kLoopBudget };

/// Label of a module's end; the others count from 1 by the instruction behind them.
constexpr uint32_t kEndLabel = 0;

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources);
  ir::Program Run();

 private:
  // --- modules (lowering.cc) ---
  void InitialData();
  void FindCalledModules();
  void AddModuleRoutines();
  /// Whether calls enter the module; then S and AX are its caller's.
  bool IsCalled(ModuleId module) const { return called_[module.index]; }
  void LowerModule(ModuleId id);
  void Execute(InstructionId id);
  void Dispatch(InstructionId id, const Instruction& instruction);

  // --- statements (lowering_statements.cc) ---
  /// Finds which instructions begin a statement of the module.
  void CutStatements(const Module& module);
  void BeginStatement(InstructionId first, InstructionId end);
  void EndComments(const Module& module);
  std::string SubjectOf(InstructionId first, InstructionId end) const;
  uint32_t StatementNumber(InstructionId first, InstructionId end);

  // --- logic and setting operations (lowering_logic.cc) ---
  /// As 5.3 and 6.1.2: `first` decided by the text, or at run time.
  void Operate(dialects::Join join, ir::ValueId operand);
  void BeginString();
  void Fold();
  void Open(dialects::Join join);
  void Close();
  void Compare(const Instruction& instruction);
  void Assign(const Operand& target);
  void SetOrReset(const Operand& target, bool set);
  ir::ValueId ReadBit(const Operand& operand);
  void Decided(uint64_t first);  // what the next operation is

  // --- timers and counters (lowering_timers.cc) ---
  void StartTimer(const Instruction& instruction, ir::OpKind start);
  void Count(const Instruction& instruction, ir::OpKind step);
  void SetCounter(const Instruction& instruction);
  ir::StateId TimerOf(uint32_t number);
  ir::StateId CounterOf(uint32_t number);
  ir::PlaceId OutputOf(uint32_t timer);
  ir::PlaceId ValueOf(uint32_t counter);
  ir::ValueId StartsTimer(const Instruction& instruction, ir::OpKind start, ir::ValueId condition);
  ir::ValueId PortWord(const Operand& operand, ir::ValueId needed);
  /// A bit of an instance that has no name in the language.
  ir::PlaceId FieldOf(ir::StateId state, std::string_view field, std::string name);
  /// The time word or preset of an instruction, no port.
  ir::ValueId Parameter(const Instruction& instruction);

  // --- load and transfer (lowering_data.cc) ---
  void Load(const Instruction& instruction);
  void Transfer(const Operand& target);
  /// A byte operand, or the bits of a word operand or constant.
  ir::ValueId ReadData(const Operand& operand);
  /// A value of 8 or 16 bits, as wide as the operand.
  void WriteData(const Operand& operand, ir::ValueId value);
  /// AL; AL replaced, AH as it was.
  ir::ValueId LowByte();
  void SetLowByte(ir::ValueId byte);
  ir::ValueId ReadPort(uint32_t port);
  void WritePort(uint32_t port, ir::ValueId byte);
  /// The latch of an output byte goes out.
  void SendLatch(uint32_t port);

  // --- control flow (lowering_control.cc) ---
  void Jump(InstructionId id, const Instruction& instruction, bool conditional);
  void Call(const Instruction& instruction, bool conditional);
  void EndModule(InstructionId id, bool conditional);
  void SpillAll();
  void ForgetAll();
  void CallFault(Fault fault);
  uint32_t LabelBefore(InstructionId at) const { return at.index - module_->begin_of().index + 1; }

  // --- functional modules (lowering_functions.cc, _indirect.cc, _nc.cc, _long.cc) ---
  void Perform(const Instruction& instruction, bool conditional);
  void PerformNow(const Instruction& instruction);
  void AddOrSubtract(const Instruction& instruction, Function function);
  void Multiply(const Instruction& instruction);
  void Divide(const Instruction& instruction);
  void ToBcd();
  void Shift(const Instruction& instruction, ir::OpKind op);
  void Bitwise(const Instruction& instruction, ir::OpKind bytes, ir::OpKind words);
  /// val(x) of 6.9 in 32 bits; with muldiv=unsigned everything is zero-extended.
  ir::ValueId Value32(const Operand& operand);
  /// val(x) modulo 2^16, and modulo 2^8.
  ir::ValueId Value16(const Operand& operand);
  ir::ValueId Value8(const Operand& operand);

  void ReadIndirect(const Instruction& instruction, ir::Type type);
  void WriteIndirect(const Instruction& instruction, ir::Type type);
  /// What an indirect access reaches: a constant address, or one that is computed.
  struct Reach {
    std::optional<int32_t> constant;
    ir::ValueId address;  // i32
    ir::ValueId outside;  // bit; none: it is always inside
  };
  Reach ReachOf(const Instruction& instruction, uint32_t bytes);

  void NcRead(const Instruction& instruction, ir::Type type);
  void NcWrite(const Instruction& instruction, ir::Type type);

  void LongOperation(const Instruction& instruction, ir::OpKind op);
  /// Its only operand by what `change` gives for its value.
  void LongChange(const Instruction& instruction, ir::ValueId (Lowering::*change)(ir::ValueId));
  ir::ValueId Negated(ir::ValueId value) { return builder_.Pure(ir::OpKind::kSub32, {Number(0), value}); }
  ir::ValueId Complemented(ir::ValueId value) { return builder_.Pure(ir::OpKind::kNot32, {value}); }
  ir::ValueId Incremented(ir::ValueId value) { return builder_.Pure(ir::OpKind::kAdd32, {value, Number(1)}); }
  ir::ValueId Decremented(ir::ValueId value) { return builder_.Pure(ir::OpKind::kSub32, {value, Number(1)}); }
  void LongCompare(const Instruction& instruction, ir::OpKind op);
  void MoveLong(const Instruction& instruction);
  void MultiplyLong(const Instruction& instruction);
  void DivideLong(const Instruction& instruction);
  ir::ValueId LoadField(const Operand& operand, ir::Type type) { return LoadAt(operand.space(), operand.number, type); }
  void StoreField(const Operand& operand, ir::Type type, ir::ValueId value, uint32_t behind = 0) {
    StoreAt(operand.space(), operand.number + behind, type, value);
  }

  // --- memory (lowering_places.cc) ---
  ir::ValueId LoadAt(Space space, uint32_t address, ir::Type type);
  void StoreAt(Space space, uint32_t address, ir::Type type, ir::ValueId value);
  ir::PlaceId BitPlace(const Operand& operand);
  ir::PlaceId PlaceAt(Space space, uint32_t address, ir::Type type);
  ir::PlaceId LatchPlace(uint32_t port);
  /// Access to memory by a computed byte address, an i32; what is not wholly inside the space reads 0 and writes
  /// nothing.
  ir::ValueId LoadIndexed(Space space, ir::ValueId address, ir::Type type);
  void StoreIndexed(Space space, ir::ValueId address, ir::Type type, ir::ValueId value);
  ir::ValueId Moved(ir::ValueId address, uint32_t by);
  /// A word in D as two bytes, which may lie in different parts; `behind` is 0 for the low one.
  template <class Visit>
  void ForEachPart(uint32_t behind, uint32_t bytes, Visit&& visit);
  ir::PlaceId IndexedPlace(ir::SpaceId space, ir::Type type, std::string name, uint32_t low, uint32_t high);
  ir::PlaceId PlaceOf(ScalarPlace scalar);
  ir::ValueId LoadScalar(ScalarPlace scalar) { return builder_.Load(PlaceOf(scalar)); }
  void StoreScalar(ScalarPlace scalar, ir::ValueId value) { builder_.Store(PlaceOf(scalar), value); }
  ir::ValueId Byte(uint32_t value) { return builder_.Constant(ir::Type::kI8, value & 0xFF); }
  ir::ValueId Word(uint32_t value) { return builder_.Constant(ir::Type::kI16, value & 0xFFFF); }
  ir::ValueId Number(uint32_t value) { return builder_.Constant(ir::Type::kI32, value); }

  // --- the schedule (lowering_schedule.cc, lowering_refresh.cc) ---
  void AddScheduleRoutines();
  /// A place that lives as long as the routine that uses it.
  ir::PlaceId AddLocal(std::string name, ir::Type type);
  /// The place of a new parameter of the routine.
  ir::PlaceId AddParameter(ir::RoutineId routine, std::string name, ir::Type type);
  void Init();
  void Fast();
  void Slow();
  void Advance();
  void Tick();
  void SlowPass();
  void SlowStep();
  void Periods();
  void SystemSignals();
  void RefreshInputs();
  void RefreshOutputs();
  void Enter(ModuleId module);
  void EnterWhenActive(ModuleId module);
  ModuleId ModuleOf(uint32_t number) const { return tree_.module_of[number]; }
  void FillSchedule();

  // --- declarations (lowering_tables.cc) ---
  void Messages();
  void MFunctions();
  /// Of the places that statements use: before the schedule adds its own.
  void Document();
  std::string DeclaredComment(uint32_t address, uint32_t bytes) const;
  /// Sets or clears the bits that the M function `number`, an i8, has by its DMF.
  void SetDeclaredBits(ir::ValueId number, bool value, bool also_static);

  const Program& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  ir::FactChecks facts_{builder_};
  Memory memory_;

  const Module* module_ = nullptr;  // the one being lowered
  dialects::Register* s_ = nullptr;
  dialects::Register* ax_ = nullptr;
  dialects::Register* first_ = nullptr;  // none: the text decides
  dialects::LogicStack* logic_ = nullptr;
  std::vector<dialects::Join> brackets_;
  bool end_is_used_ = false;  // something jumps to the module's end
  // Of the module being lowered, by the instruction's number in it:
  std::vector<bool> begins_statement_;
  std::vector<bool> label_at_;  // something jumps there

  std::vector<bool> called_;                              // by ModuleId
  std::vector<ir::RoutineId> routines_;                   // by ModuleId
  std::unordered_map<uint32_t, ir::PlaceId> places_;      // by address and type
  std::unordered_map<std::string, ir::PlaceId> indexed_;  // by name
  std::unordered_map<std::string, ir::PlaceId> fields_;   // by name
  std::array<ir::PlaceId, static_cast<size_t>(ScalarPlace::kCount)> scalars_;
  dialects::HostCalls<HostCall> host_{builder_};
  std::array<ir::StateId, kTimers> timers_;
  std::array<ir::StateId, kCounters> counters_;
  std::array<ir::PlaceId, kTimers> outputs_;
  std::array<ir::PlaceId, kCounters> values_;
  bool loops_ = false;        // the program jumps backward somewhere
  uint32_t local_count_ = 0;  // of AddLocal

  ir::RoutineId init_, fast_, slow_, advance_, tick_, slow_pass_, slow_step_, period_, fast_only_, elapse_;
  ir::RoutineId refresh_inputs_, refresh_outputs_;

  std::vector<source::Range> waiting_comments_;
  size_t next_file_ = 0;
  std::unordered_map<uint32_t, uint32_t> equal_texts_;
  std::unordered_set<uint32_t> used_numbers_;
};

}  // namespace plcxx::prostep
