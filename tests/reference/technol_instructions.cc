// TECHNOL's own instructions (6.2 to 6.8).
#include <algorithm>

#include "tests/reference/technol.h"

namespace plcxx::reference {

using technol::InstructionId;
using technol::Op;
using technol::OperandKind;

namespace {

constexpr uint32_t kBzh11 = 1, kBzh22 = 3;  // system cells (5.2)

}  // namespace

// --- one instruction (6) -------------------------------------------------------------------------------------------

TechnolReference::Next TechnolReference::Execute(uint32_t at) {
  const Instruction& instruction = program_.instructions[InstructionId(at)];
  at_ = at;
  pc_ = at + 1;
  trapped_ = false;
  Next next = Next::kOn;
  if (technol::Info(instruction.op).assembler) {
    next = ExecuteAssembler(instruction, at);
  } else {
    next = ExecuteTechnol(instruction, at);
    // Undefined behind any TECHNOL instruction (5.6), but they pass through CALL and RET (6.4).
    if (instruction.op != Op::kCall && instruction.op != Op::kRet) flags_ = {};
  }
  return trapped_ ? Next::kLeaves : next;
}

TechnolReference::Next TechnolReference::Jump(technol::LabelId label, uint32_t at) {  // 6.4
  const uint32_t target = program_.labels[label].at.index;
  if (target <= at) {
    if (jumps_ == settings_.loop_limit) {
      Fault(TechnolFault::kLoop);
      return Next::kLeaves;
    }
    ++jumps_;
  }
  pc_ = target;
  return Next::kOn;
}

TechnolReference::Next TechnolReference::ExecuteTechnol(const Instruction& instruction, uint32_t at) {
  const auto bit = [&](uint32_t k) { return ReadBit(Of(instruction, k)) != Of(instruction, k).negated; };
  switch (instruction.op) {
    case Op::kLdr:
      rlo_ = bit(0);
      return Next::kOn;
    case Op::kLa:
      rlo_ = bit(0) && rlo_;
      return Next::kOn;
    case Op::kLo:
      rlo_ = bit(0) || rlo_;
      return Next::kOn;
    case Op::kLx:
      rlo_ = bit(0) != rlo_;
      return Next::kOn;
    case Op::kWr:
      return WriteBit(Of(instruction, 0), rlo_);
    case Op::kFl:
      return WriteBit(Of(instruction, 1), Of(instruction, 0).value != 0);
    case Op::kFl1:
    case Op::kFl0:
      return rlo_ == (instruction.op == Op::kFl1) ? WriteBit(Of(instruction, 1), Of(instruction, 0).value != 0)
                                                  : Next::kOn;
    case Op::kJum:
      return Jump(Of(instruction, 0).label, at);
    case Op::kJl1:
    case Op::kJl0:
      return rlo_ == (instruction.op == Op::kJl1) ? Jump(Of(instruction, 0).label, at) : Next::kOn;
    case Op::kCall:
      calls_.push_back(pc_);
      pc_ = program_.labels[Of(instruction, 0).label].at.index;
      return Next::kOn;
    case Op::kRet:
      pc_ = calls_.back();
      calls_.pop_back();
      return stopped_ && calls_.empty() ? Next::kLeaves : Next::kOn;
    case Op::kMechInit: {
      const technol::UnitId mechanism = Of(instruction, 0).mechanism;
      memories_.back().Write(mechanisms_[mechanism.index], 1, 0);
      return Stop(mechanism);
    }
    case Op::kEset: {  // 6.8
      const auto main = static_cast<uint32_t>(Of(instruction, 0).value);
      const auto sub = instruction.operands.count > 1 ? static_cast<uint32_t>(Of(instruction, 1).value) : 0;
      const auto coded = [&](uint32_t n) {
        return static_cast<uint8_t>(settings_.eset == technol::EsetForm::kBcd ? n / 10 * 16 + n % 10 : n);
      };
      Area(technol::Area::kSys).Write(kBzh11, 0xFF, coded(main));
      Area(technol::Area::kSys).Write(kBzh22, 0xFF, coded(sub));
      Call("error_raised", {main, sub});
      return Next::kOn;
    }
    case Op::kMechanismBegin: {
      RunMechanism(instruction.mechanism);
      trapped_ = false;
      pc_ = program_.units[instruction.mechanism].end.index + 1;
      return Next::kOn;
    }
    case Op::kMechanismEnd:
    case Op::kModuleEnd:
    case Op::kAreaEnd:
      return Next::kEnd;
    default:
      break;
  }
  return technol::Info(instruction.op).purity == technol::Purity::kPure ? ExecuteData(instruction, at)
                                                                        : ExecuteWait(instruction, at);
}

TechnolReference::Next TechnolReference::ExecuteWait(const Instruction& instruction, uint32_t at) {  // 6.7
  if (instruction.op == Op::kSto) return ExecuteData(instruction, at);
  const auto wait = [&] {
    progress_[unit_.index].step = flow_.resume_point[at];
    return Next::kWaits;
  };
  if (instruction.op == Op::kEx) return wait();
  if (instruction.op == Op::kEx0) return rlo_ ? Next::kOn : wait();
  if (instruction.op == Op::kEx1) return rlo_ ? wait() : Next::kOn;
  const Operand& cell = Of(instruction, 0);
  const Reach reach = cell.kind == OperandKind::kMemory ? Find(cell) : Reach{};
  const auto set = [&](uint32_t c) {
    if (cell.kind == OperandKind::kAutomaticTimer) {
      TimerOf(cell) = static_cast<uint16_t>(c);
    } else {
      Put(reach, 16, c);
    }
  };
  const bool succeeds = instruction.op == Op::kTex0 ? rlo_ : instruction.op == Op::kTex1 && !rlo_;
  if (succeeds) {
    set(0);
    return Next::kOn;
  }
  const uint32_t c = cell.kind == OperandKind::kAutomaticTimer ? TimerOf(cell) : Get(reach, 16);
  if (c >= Read(Of(instruction, 1))) {
    set(0);
    return instruction.op == Op::kTim ? Next::kOn : Jump(Of(instruction, 2).label, at);
  }
  set(c + 1);
  return wait();
}

// --- data instructions (6.5, 6.6) ----------------------------------------------------------------------------------

TechnolReference::Next TechnolReference::ExecuteData(const Instruction& instruction, uint32_t at) {
  using technol::Register;
  const uint8_t drw = flow_.width_of_dr[at] == 32 ? 32 : 16;
  const uint32_t full = this->Register(Register::kEcx);
  const uint32_t dr = drw == 32 ? full : full & 0xFFFFU;
  const auto set = [&](uint32_t value) { SetRegister(Register::kEcx, value); };
  if (instruction.op == Op::kBcd || instruction.op == Op::kBin) {
    instruction.op == Op::kBcd ? Bcd(drw) : Bin(drw);
    return Next::kOn;
  }
  const Operand& x = Of(instruction, 0);
  if (instruction.op == Op::kSto) {
    Put(Find(x), x.width, dr);
    return Next::kOn;
  }
  const uint8_t width = std::max({uint8_t{16}, instruction.op == Op::kLod ? uint8_t{16} : drw, x.width});
  const uint32_t mask = width == 32 ? 0xFFFFFFFFU : 0xFFFFU;
  const uint32_t v = Read(x) & mask;
  switch (instruction.op) {
    case Op::kLod:
      set(v);
      break;
    case Op::kAd:
      set((dr + v) & mask);
      break;
    case Op::kSu:
      set((dr - v) & mask);
      break;
    case Op::kAnd:
      set(dr & v);
      break;
    case Op::kOr:
      set(dr | v);
      break;
    case Op::kXor:
      set(dr ^ v);
      break;
    case Op::kMulb:
      set((dr & 0xFF) * v);
      break;
    case Op::kMulw:
      set((dr & 0xFFFF) * v);
      break;
    case Op::kDivb:
    case Op::kDivw: {
      const uint32_t a = instruction.op == Op::kDivb ? dr & 0xFFFF : dr;
      if (v == 0) {
        set(instruction.op == Op::kDivb ? 0xFFFF : 0xFFFFFFFF);
        SetRegister(Register::kDx, 0);
        Fault(TechnolFault::kDivide);
      } else {
        set(a / v);
        SetRegister(Register::kDx, a % v);
      }
      break;
    }
    case Op::kRl:
    case Op::kRr: {
      const uint32_t n = v;
      const bool left = instruction.op == Op::kRl;
      if (settings_.rotation == technol::Rotation::kShift) {
        set(n >= drw ? 0 : left ? dr << n & (drw == 32 ? 0xFFFFFFFFU : 0xFFFFU) : dr >> n);
      } else {
        const uint64_t twice = uint64_t{dr} << drw | dr;
        const uint32_t right = left ? (drw - n % drw) % drw : n % drw;
        set(static_cast<uint32_t>(twice >> right & (drw == 32 ? 0xFFFFFFFFU : 0xFFFFU)));
      }
      break;
    }
    case Op::kEq:
      rlo_ = dr == v;
      break;
    case Op::kNe:
      rlo_ = dr != v;
      break;
    case Op::kLt:
      rlo_ = dr < v;
      break;
    case Op::kLe:
      rlo_ = dr <= v;
      break;
    case Op::kGt:
      rlo_ = dr > v;
      break;
    default:
      rlo_ = dr >= v;
      break;
  }
  return Next::kOn;
}

void TechnolReference::Bcd(uint8_t width) {
  const uint32_t dr = registers_[static_cast<size_t>(technol::Register::kEcx)];
  const auto n = static_cast<int32_t>(dr);
  const bool minus = width == 32 && n < 0;
  const uint32_t limit = width == 32 ? 80'000'000 : 10'000;
  const uint32_t magnitude = width == 16 ? dr & 0xFFFF : minus ? 0 - dr : dr;
  if (magnitude >= limit) Fault(TechnolFault::kBcdRange);
  uint32_t a = magnitude % limit;
  uint32_t digits = minus && a != 0 ? 0x80000000U : 0;
  for (uint32_t k = 0; k < 8; ++k, a /= 10) digits |= a % 10 << 4 * k;
  SetRegister(technol::Register::kEcx, digits);
}

void TechnolReference::Bin(uint8_t width) {
  uint32_t dr = registers_[static_cast<size_t>(technol::Register::kEcx)];
  const bool minus = width == 32 && (dr & 0x80000000U) != 0;
  dr &= width == 32 ? 0x7FFFFFFFU : 0xFFFFU;
  bool wrong = false;
  uint32_t value = 0, weight = 1;
  for (uint32_t k = 0; k < width / 4U; ++k, weight *= 10) {
    const uint32_t nibble = dr >> 4 * k & 15;
    wrong = wrong || nibble > 9;
    value += nibble * weight;
  }
  if (wrong) Fault(TechnolFault::kBcdDigit);
  SetRegister(technol::Register::kEcx, width == 16 ? value & 0xFFFF : minus ? 0 - value : value);
}

}  // namespace plcxx::reference
