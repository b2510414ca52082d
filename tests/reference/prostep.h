// A second reading of dialect prostep: an interpreter of the syntax tree, written from the tables of the specification.
//
// In: the parsed program and its settings. Out: memory, timers, counters and the calls of the host, as section 4.3
// schedules them. Numbers in parentheses are sections of the specification. It shares nothing with lowering, IR and
// runtime support, and it is not meant to be fast.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/reference/random_program.h"
#include "tests/reference/reference.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::reference {

/// 7.1
struct ProstepTimer {
  prostep::Op type = prostep::Op::kUnknown;
  bool run = false, out = false, edge = false;
  int64_t rem = 0;  // ms
  uint32_t scale = 0, sc = 0;
};

/// 7.2
struct ProstepCounter {
  uint32_t v = 0;
  bool eu = false, ed = false;
  bool es = false;  // counter-set=edge: S seen by the last S C
};

/// 8.1, in the order written there.
enum class ProstepFault : uint8_t { kDivZero, kDivOverflow, kIndex, kNcAccess, kLoopBudget };

/// What the text of its module decides about an instruction (5.3, 6.1.3): is it first, does it fold, and is the string
/// that it folds empty.
struct SequenceNote {
  bool first = false;
  bool folds = false;
  bool empty = false;
  bool asks_flag = false;  // first-check=dynamic decides `first` here: outside brackets and OR strings
};
struct SequenceNotes {
  std::vector<SequenceNote> of_instruction;
  std::vector<SequenceNote> of_end;  // END of each module
};
SequenceNotes ReadSequences(const prostep::Program& program);

class ProstepReference : public Reference {
 public:
  ProstepReference(prostep::Program program, const prostep::Settings& settings, HostCalls host);

  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void StoreRetentive() override;
  std::optional<Element> FindElement(std::string_view instance, std::string_view field) override;

 private:
  enum class Next : uint8_t { kOn, kJumped, kLeaves };

  void Tick(uint32_t t);
  void SlowPass();
  void RunModule(uint32_t number);
  void RunFromScheduler(uint32_t number);
  Next Execute(prostep::InstructionId id);
  Next Jump(const prostep::Instruction& instruction, prostep::InstructionId id);
  void Fold(const SequenceNote& note);
  bool First(const SequenceNote& note) const;
  void Combine(bool is_and, bool v, const SequenceNote& note);
  bool BitValue(const prostep::Operand& operand);
  void WriteBit(const prostep::Operand& operand, bool value);
  void Compare(const prostep::Instruction& instruction);
  void Load(const prostep::Operand& operand);
  void StartTimer(const prostep::Instruction& instruction);
  uint32_t TimeLeft(const ProstepTimer& timer) const;
  void Count(const prostep::Instruction& instruction);
  void Perform(const prostep::Instruction& instruction);
  void PerformWord(const prostep::Instruction& instruction);
  void PerformIndirect(const prostep::Instruction& instruction);
  void PerformNc(const prostep::Instruction& instruction);
  void PerformLong(const prostep::Instruction& instruction);

  struct Cell {
    AddressSpace* memory;
    uint32_t offset;
  };
  Cell At(prostep::Space space, uint32_t number);
  uint8_t Byte(prostep::Space space, uint32_t number);
  void PutByte(prostep::Space space, uint32_t number, uint8_t value);
  uint8_t ReadByte(prostep::Space space, uint32_t number);
  void WriteByte(prostep::Space space, uint32_t number, uint8_t value);
  uint16_t ReadData(const prostep::Operand& operand);  // zero-extended; K: its bits
  void WriteData(const prostep::Operand& operand, uint16_t value);
  int32_t Val(const prostep::Operand& operand);
  uint64_t ReadField(const prostep::Operand& operand, uint32_t bytes);
  void WriteField(const prostep::Operand& operand, uint32_t offset, uint32_t bytes, uint64_t value);
  void RefreshInputs();
  void RefreshOutputs();
  void Advance(uint32_t ms);
  void Fault(ProstepFault code);

  prostep::Program program_;
  prostep::Settings settings_;
  std::array<ProstepTimer, prostep::kTimers> timers_;
  std::array<ProstepCounter, prostep::kCounters> counters_;
  std::optional<std::vector<uint8_t>> retained_;
  SequenceNotes notes_;
  uint32_t t_ = 0;
  // 5.3
  bool s_ = false;
  uint16_t ax_ = 0;
  bool orm_ = false;
  bool first_flag_ = true;
  struct Bracket {
    bool is_and, s, orm, first;
  };
  std::vector<Bracket> brackets_;
  uint32_t module_ = 0;        // PM that is being executed
  uint32_t jumps_ = 0;         // backward jumps of this partition run (6.5)
  prostep::InstructionId go_;  // where a jump goes
};

/// For the table of dialects.
std::unique_ptr<Reference> MakeProstepReference(dialects::Request& request, HostCalls host);
RandomProgram MakeRandomProstep(Random& random, ProgramSize size, Spelling spelling);

}  // namespace plcxx::reference
