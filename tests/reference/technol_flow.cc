// What the text of a technol program decides: widths of DR (6.1), resume points (6.7), requests (8.1).
#include <algorithm>

#include "tests/reference/technol.h"

namespace plcxx::reference {
namespace {

using technol::Instruction;
using technol::InstructionId;
using technol::Op;
using technol::Operand;
using technol::OperandKind;
using technol::Program;
using technol::Register;

bool WritesMemory(const Program& program, const Instruction& instruction) {
  const technol::InstructionInfo& info = technol::Info(instruction.op);
  const bool writes = info.first == technol::Access::kWrite || info.first == technol::Access::kReadWrite;
  for (uint32_t k = 0; k < instruction.operands.count; ++k) {
    const bool changed = k == 0 ? writes : instruction.op == Op::kXchg;
    if (changed && program.OperandOf(instruction, k).kind == OperandKind::kMemory) return true;
  }
  return false;
}

bool IsPure(const Program& program, const Instruction& instruction) {  // 6.7
  switch (instruction.op) {
    case Op::kLdr:
    case Op::kLa:
    case Op::kLo:
    case Op::kLx:
    case Op::kLod:
    case Op::kAd:
    case Op::kSu:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kMulb:
    case Op::kMulw:
    case Op::kDivb:
    case Op::kDivw:
    case Op::kRl:
    case Op::kRr:
    case Op::kBcd:
    case Op::kBin:
    case Op::kEq:
    case Op::kNe:
    case Op::kLt:
    case Op::kLe:
    case Op::kGt:
    case Op::kGe:
      return true;
    default: {
      const technol::InstructionInfo& info = technol::Info(instruction.op);
      const bool jumps = info.form == technol::Form::kJump;
      return info.assembler && !jumps && instruction.op != Op::kPush && instruction.op != Op::kPop &&
             !WritesMemory(program, instruction);
    }
  }
}

bool HasLabel(const Program& program, uint32_t at) { return program.instructions[InstructionId(at)].labels.count != 0; }

uint32_t ResumePoint(const Program& program, uint32_t wait) {
  uint32_t at = wait;
  while (at > 0 && !HasLabel(program, at) && IsPure(program, program.instructions[InstructionId(at - 1)])) --at;
  return at;
}

/// Who calls, who returns: the widths at a CALL go to its target, those at the RETs that are reached from there go
/// behind the CALL.
class Widths {
 public:
  explicit Widths(const Program& program) : program_(program), in_(program.instructions.size()) {}

  std::vector<uint8_t> Run() {
    do {
      changed_ = false;
      for (uint32_t i = 0; i < in_.size(); ++i) Step(i);
    } while (changed_);
    return std::move(in_);
  }

 private:
  void Into(uint32_t at, uint8_t width) {
    if (at >= in_.size() || in_[at] >= width) return;
    in_[at] = width;  // a join of different widths is 32
    changed_ = true;
  }
  uint32_t Target(const Instruction& instruction) const {
    for (uint32_t k = 0; k < instruction.operands.count; ++k) {
      const Operand& operand = program_.OperandOf(instruction, k);
      if (operand.kind == OperandKind::kLabel) return program_.labels[operand.label].at.index;
    }
    return UINT32_MAX;
  }
  static bool Always(Op op) { return op == Op::kJum || op == Op::kJmp; }

  uint8_t After(const Instruction& instruction, uint8_t width) const {
    const auto operand = [&](uint32_t k) -> const Operand& { return program_.OperandOf(instruction, k); };
    const technol::InstructionInfo& info = technol::Info(instruction.op);
    switch (instruction.op) {
      case Op::kLod:
        return std::max<uint8_t>(16, operand(0).width);
      case Op::kAd:
      case Op::kSu:
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
        return std::max({uint8_t{16}, width, operand(0).width});
      case Op::kMulb:
      case Op::kDivb:
        return 16;
      case Op::kMulw:
      case Op::kDivw:
        return 32;
      case Op::kRl:
      case Op::kRr:
        return std::max<uint8_t>(16, width);
      case Op::kLoop:
        return 16;
      default:
        break;
    }
    if (!info.assembler) return width;
    // A shift by the constant 0 (of 5 bits) changes nothing (6.9), so that it is no write.
    if (info.form == technol::Form::kShift && operand(1).kind == OperandKind::kConstant &&
        (operand(1).value & 31) == 0) {
      return width;
    }
    for (uint32_t k = 0; k < instruction.operands.count; ++k) {
      const bool writes = k == 0 ? info.first == technol::Access::kWrite || info.first == technol::Access::kReadWrite
                                 : instruction.op == Op::kXchg;
      if (!writes || operand(k).kind != OperandKind::kRegister) continue;
      if (technol::Info(operand(k).reg).whole == Register::kEcx) width = operand(k).reg == Register::kEcx ? 32 : 16;
    }
    return width;
  }

  void Step(uint32_t at) {
    const Instruction& instruction = program_.instructions[InstructionId(at)];
    const uint8_t out = After(instruction, in_[at]);
    const technol::InstructionInfo& info = technol::Info(instruction.op);
    const uint32_t target = Target(instruction);
    if (instruction.op == Op::kCall) {
      Into(target, out);
      Into(at + 1, Returned(target));
      return;
    }
    if (target != UINT32_MAX) Into(target, out);
    const bool ends = instruction.op == Op::kRet || instruction.op == Op::kModuleEnd ||
                      instruction.op == Op::kAreaEnd || instruction.op == Op::kMechanismEnd ||
                      instruction.op == Op::kEx || (info.form == technol::Form::kJump && Always(instruction.op));
    if (!ends) Into(at + 1, out);
  }

  /// The join over the RETs that are reached from `entry`.
  uint8_t Returned(uint32_t entry) const {
    std::vector<bool> seen(in_.size());
    std::vector<uint32_t> open = {entry};
    uint8_t width = 0;
    while (!open.empty()) {
      const uint32_t at = open.back();
      open.pop_back();
      if (at >= in_.size() || seen[at]) continue;
      seen[at] = true;
      const Instruction& instruction = program_.instructions[InstructionId(at)];
      if (instruction.op == Op::kRet) {
        width = std::max(width, in_[at]);
        continue;
      }
      if (instruction.op != Op::kCall && Target(instruction) != UINT32_MAX) open.push_back(Target(instruction));
      if (instruction.op != Op::kAreaEnd && !Always(instruction.op)) open.push_back(at + 1);
    }
    return width;
  }

  const Program& program_;
  std::vector<uint8_t> in_;
  bool changed_ = false;
};

uint8_t RequestsOf(const Program& program) {
  uint8_t bits = 0;
  for (const Instruction& instruction : program.instructions) {
    for (uint32_t k = 0; k < instruction.operands.count; ++k) {
      const Operand& operand = program.OperandOf(instruction, k);
      if (operand.address.area != technol::Area::kSys) continue;
      const bool flag = technol::Info(instruction.op).form == technol::Form::kFlag || instruction.op == Op::kWr;
      if (flag && operand.kind == OperandKind::kBit && operand.address.offset == kSysReq) {
        bits = static_cast<uint8_t>(bits | 1U << operand.bit);
      }
      const technol::Access access = technol::Info(instruction.op).first;
      const bool writes = access == technol::Access::kWrite || access == technol::Access::kReadWrite;
      if (!writes || operand.kind != OperandKind::kMemory) continue;
      const bool covers = operand.address.offset <= kSysReq && operand.address.offset + operand.width / 8 > kSysReq;
      if (covers || operand.address.index != Register::kNone) bits = 0xFF;
    }
  }
  return bits;
}

bool NamesMachineConstants(const Program& program) {
  return std::ranges::any_of(program.operands,
                             [](const Operand& operand) { return operand.address.area == technol::Area::kBukon; });
}

}  // namespace

TechnolFlow ReadFlow(const Program& program) {
  TechnolFlow flow{.width_of_dr = Widths(program).Run(),
                   .resume_point = std::vector<uint32_t>(program.instructions.size()),
                   .requests = RequestsOf(program),
                   .machine_constants = NamesMachineConstants(program)};
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const Op op = program.instructions[InstructionId(i)].op;
    const bool condition = op == Op::kEx0 || op == Op::kEx1 || op == Op::kTex0 || op == Op::kTex1;
    flow.resume_point[i] = condition ? ResumePoint(program, i) : op == Op::kTim ? i : i + 1;
  }
  return flow;
}

}  // namespace plcxx::reference
