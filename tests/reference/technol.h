// A second reading of dialect technol: an interpreter of the syntax tree, written from the tables of the specification.
//
// In: the parsed program and its settings. Out: memory, activation bits and the calls of the host, as section 4.3
// schedules them. Numbers in parentheses are sections of the specification. It shares nothing with lowering, IR and
// runtime support, and it is not meant to be fast.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "tests/reference/random_program.h"
#include "tests/reference/reference.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::reference {

// 5.1 and 5.2: system cells, in their order.
inline constexpr uint32_t kSysReq = 7, kSysNc = 8;

/// What is decided before anything runs.
struct TechnolFlow {
  /// Of each instruction: the static width of DR in front of it (6.1): 16, 32; 0: nothing has loaded it.
  std::vector<uint8_t> width_of_dr;
  /// Of each EX0, EX1, TEX0, TEX1, TIM, EX: where it resumes (6.7).
  std::vector<uint32_t> resume_point;
  /// Bits of SYSREQ that the program writes, or reaches as a byte: host functions are only those that it can need
  /// (8.1).
  uint8_t requests = 0;
  bool machine_constants = false;  // the program names one
};
TechnolFlow ReadFlow(const technol::Program& program);

/// 8.1, in the order written there.
enum class TechnolFault : uint8_t { kBounds, kLoop, kDivide, kBcdRange, kBcdDigit };

struct TechnolFlags {
  bool cf = false, zf = false, sf = false, of = false, af = false;
};

class TechnolReference : public Reference {
 public:
  TechnolReference(technol::Program program, const technol::Settings& settings, HostCalls host);

  void Take(const Choices& choices) override { statement_ids_ = choices.statement_ids; }
  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void StoreRetentive() override;

 private:
  using Operand = technol::Operand;
  using Instruction = technol::Instruction;

  /// How the execution of a module or mechanism goes on behind an instruction.
  enum class Next : uint8_t {
    kOn,      // at pc_
    kEnd,     // its end is reached
    kWaits,   // left for this pass
    kLeaves,  // left by the loop guard, a trap, or MECH_INIT of itself
  };
  /// Of a mechanism or a function module (7.1, 7.4).
  struct Progress {
    std::optional<uint32_t> step;  // none: the beginning
    std::vector<uint16_t> timers;
  };
  /// What a memory operand reaches: nothing when it is out of bounds (6.1).
  struct Reach {
    AddressSpace* memory = nullptr;
    uint32_t offset = 0;
  };

  // schedule
  void RunModule(technol::ModuleKind kind);
  void RunFunctions(technol::ModuleKind kind, uint32_t bit);
  void RunMechanism(technol::UnitId unit);
  Next RunUnit(technol::UnitId unit, uint32_t from);
  void Reset(technol::UnitId unit);
  void ResetCleared();
  Next Stop(technol::UnitId mechanism);
  void ClearRegisters();
  bool SystemBit(uint32_t byte, uint32_t bit) const;
  void ClearSystemBit(uint32_t byte, uint32_t bit);
  void Requests();
  bool TransferIsValid();

  // one instruction
  Next Execute(uint32_t at);
  Next ExecuteTechnol(const Instruction& instruction, uint32_t at);
  Next ExecuteWait(const Instruction& instruction, uint32_t at);
  Next ExecuteData(const Instruction& instruction, uint32_t at);
  Next ExecuteAssembler(const Instruction& instruction, uint32_t at);
  void Arithmetic(const Instruction& instruction);
  void Unary(const Instruction& instruction);
  void Shift(const Instruction& instruction);
  void Multiply(const Instruction& instruction);
  void Divide(const Instruction& instruction);
  void Adjust(const Instruction& instruction);
  void Bcd(uint8_t width);
  void Bin(uint8_t width);
  bool Holds(technol::Op jump) const;
  Next Jump(technol::LabelId label, uint32_t at);

  // operands
  const Operand& Of(const Instruction& instruction, uint32_t index) const {
    return program_.OperandOf(instruction, index);
  }
  bool ReadBit(const Operand& operand) const;
  Next WriteBit(const Operand& operand, bool value);
  Reach Find(const Operand& operand);
  static uint32_t Get(Reach reach, uint8_t width);
  static void Put(Reach reach, uint8_t width, uint32_t value);
  uint32_t Read(const Operand& operand);
  void Write(const Operand& operand, Reach reach, uint32_t value);
  uint32_t Register(technol::Register reg) const;
  void SetRegister(technol::Register reg, uint32_t value);
  uint16_t& TimerOf(const Operand& operand);
  AddressSpace& Area(technol::Area area);
  const AddressSpace& Area(technol::Area area) const;
  void Fault(TechnolFault kind);

  technol::Program program_;
  technol::Settings settings_;
  TechnolFlow flow_;
  std::map<uint32_t, uint32_t> statement_ids_;  // 8.1
  std::vector<Progress> progress_;              // by unit
  std::vector<uint32_t> mechanisms_;            // by unit: where its activation bit is
  std::optional<std::vector<uint8_t>> stored_label_mem_, stored_table_;

  // 5.6
  bool rlo_ = false;
  std::array<uint32_t, 6> registers_{};  // EAX EBX ECX EDX ESI EDI; ECX is DR
  TechnolFlags flags_;
  std::vector<uint32_t> stack_;

  // what is being executed
  technol::UnitId unit_;  // module or mechanism
  uint32_t pc_ = 0;
  uint32_t at_ = 0;              // the instruction
  std::vector<uint32_t> calls_;  // where RET goes
  uint32_t jumps_ = 0;           // backward jumps of this execution (6.4)
  bool stopped_ = false;         // by MECH_INIT of itself in a subprogram: left when that returns
  bool trapped_ = false;         // bounds=trap: leave behind this instruction
};

std::unique_ptr<Reference> MakeTechnolReference(dialects::Request& request, HostCalls host);
RandomProgram MakeRandomTechnol(Random& random, ProgramSize size, Spelling spelling);

}  // namespace plcxx::reference
