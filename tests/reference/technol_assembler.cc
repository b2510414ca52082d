// The inline assembler of dialect technol (6.9).
#include <cstdint>

#include "tests/reference/technol.h"

namespace plcxx::reference {

using technol::Op;
using technol::OperandKind;
using Reg = technol::Register;

namespace {

uint32_t MaskOf(uint32_t width) { return width == 32 ? 0xFFFFFFFFU : (1U << width) - 1; }
bool Msb(uint32_t value, uint32_t width) { return (value >> (width - 1) & 1) != 0; }
int64_t SignedOf(uint64_t value, uint32_t width) {
  const uint64_t sign = uint64_t{1} << (width - 1);
  const uint64_t low = width == 64 ? value : value & ((uint64_t{1} << width) - 1);
  return static_cast<int64_t>((low ^ sign) - sign);
}

}  // namespace

bool TechnolReference::Holds(Op jump) const {
  const TechnolFlags& f = flags_;
  switch (jump) {
    case Op::kJe:
      return f.zf;
    case Op::kJne:
      return !f.zf;
    case Op::kJc:
      return f.cf;
    case Op::kJnc:
      return !f.cf;
    case Op::kJa:
      return !f.cf && !f.zf;
    case Op::kJbe:
      return f.cf || f.zf;
    case Op::kJg:
      return !f.zf && f.sf == f.of;
    case Op::kJge:
      return f.sf == f.of;
    case Op::kJl:
      return f.sf != f.of;
    case Op::kJle:
      return f.zf || f.sf != f.of;
    case Op::kJs:
      return f.sf;
    case Op::kJns:
      return !f.sf;
    case Op::kJo:
      return f.of;
    case Op::kJno:
      return !f.of;
    case Op::kJcxz:
      return Register(Reg::kCx) == 0;
    default:  // JMP
      return true;
  }
}

TechnolReference::Next TechnolReference::ExecuteAssembler(const Instruction& instruction, uint32_t at) {
  const auto operand = [&](uint32_t k) -> const Operand& { return Of(instruction, k); };
  switch (technol::Info(instruction.op).form) {
    case technol::Form::kJump:
      if (instruction.op == Op::kLoop) {
        SetRegister(Reg::kCx, Register(Reg::kCx) - 1);
        return Register(Reg::kCx) != 0 ? Jump(operand(0).label, at) : Next::kOn;
      }
      return Holds(instruction.op) ? Jump(operand(0).label, at) : Next::kOn;
    case technol::Form::kTwo:
      if (instruction.op == Op::kMov) {
        const uint32_t value = Read(operand(1));
        Write(operand(0), operand(0).kind == OperandKind::kMemory ? Find(operand(0)) : Reach{}, value);
      } else {
        Arithmetic(instruction);
      }
      return Next::kOn;
    case technol::Form::kOne:
      Unary(instruction);
      return Next::kOn;
    case technol::Form::kShift:
      Shift(instruction);
      return Next::kOn;
    case technol::Form::kMultiply:
      if (instruction.op == Op::kMul || instruction.op == Op::kImul) {
        Multiply(instruction);
      } else {
        Divide(instruction);
      }
      return Next::kOn;
    case technol::Form::kExchange: {
      const auto find = [&](const Operand& o) { return o.kind == OperandKind::kMemory ? Find(o) : Reach{}; };
      const auto get = [&](const Operand& o, Reach reach) {
        return o.kind == OperandKind::kMemory ? Get(reach, o.width) : Register(o.reg);
      };
      const Reach first = find(operand(0)), second = find(operand(1));
      const uint32_t a = get(operand(0), first), b = get(operand(1), second);
      Write(operand(0), first, b);
      Write(operand(1), second, a);
      return Next::kOn;
    }
    case technol::Form::kExtend: {
      const uint32_t value = Read(operand(1));
      const bool sign = instruction.op == Op::kMovsx;
      SetRegister(operand(0).reg, sign ? static_cast<uint32_t>(SignedOf(value, operand(1).width)) : value);
      return Next::kOn;
    }
    case technol::Form::kStack:
      if (instruction.op == Op::kPush) {
        stack_.push_back(Register(operand(0).reg));
      } else {
        SetRegister(operand(0).reg, stack_.back());
        stack_.pop_back();
      }
      return Next::kOn;
    default:
      Adjust(instruction);
      return Next::kOn;
  }
}

/// ADD ADC SUB SBB CMP AND OR XOR TEST
void TechnolReference::Arithmetic(const Instruction& instruction) {
  const Operand& d = Of(instruction, 0);
  const uint32_t n = d.width, mask = MaskOf(n);
  const Reach reach = d.kind == OperandKind::kMemory ? Find(d) : Reach{};
  const uint32_t a = d.kind == OperandKind::kMemory ? Get(reach, d.width) : Register(d.reg);
  const uint32_t b = Read(Of(instruction, 1)) & mask;
  uint32_t r = 0;
  const Op op = instruction.op;
  if (op == Op::kAsmAnd || op == Op::kTest || op == Op::kAsmOr || op == Op::kAsmXor) {
    r = op == Op::kAsmOr ? a | b : op == Op::kAsmXor ? a ^ b : a & b;
    flags_ = {};
  } else if (op == Op::kAdd || op == Op::kAdc) {
    const uint32_t carry = op == Op::kAdc && flags_.cf ? 1 : 0;
    r = static_cast<uint32_t>(uint64_t{a} + b + carry) & mask;
    flags_.cf = uint64_t{a} + b + carry > mask;
    flags_.of = SignedOf(a, n) + SignedOf(b, n) + carry != SignedOf(r, n);
    flags_.af = (a & 15) + (b & 15) + carry > 15;
  } else {
    const uint32_t borrow = op == Op::kSbb && flags_.cf ? 1 : 0;
    r = (a - b - borrow) & mask;
    flags_.cf = uint64_t{a} < uint64_t{b} + borrow;
    flags_.of = SignedOf(a, n) - SignedOf(b, n) - borrow != SignedOf(r, n);
    flags_.af = (a & 15) < (b & 15) + borrow;
  }
  flags_.zf = r == 0;
  flags_.sf = Msb(r, n);
  if (op != Op::kCmp && op != Op::kTest) Write(d, reach, r);
}

/// INC DEC NEG NOT
void TechnolReference::Unary(const Instruction& instruction) {
  const Operand& d = Of(instruction, 0);
  const uint32_t n = d.width, mask = MaskOf(n);
  const Reach reach = d.kind == OperandKind::kMemory ? Find(d) : Reach{};
  const uint32_t a = d.kind == OperandKind::kMemory ? Get(reach, d.width) : Register(d.reg);
  if (instruction.op == Op::kNot) {
    Write(d, reach, ~a & mask);
    return;
  }
  uint32_t r = 0;
  if (instruction.op == Op::kInc) {
    r = (a + 1) & mask;
    flags_.of = Msb(r, n) && !Msb(a, n);
    flags_.af = (a & 15) == 15;
  } else if (instruction.op == Op::kDec) {
    r = (a - 1) & mask;
    flags_.of = Msb(a, n) && !Msb(r, n);
    flags_.af = (a & 15) == 0;
  } else {
    r = (0 - a) & mask;
    flags_.cf = a != 0;
    flags_.of = a == 1U << (n - 1);
    flags_.af = (a & 15) != 0;
  }
  flags_.zf = r == 0;
  flags_.sf = Msb(r, n);
  Write(d, reach, r);
}

void TechnolReference::Shift(const Instruction& instruction) {
  const Operand& d = Of(instruction, 0);
  const Operand& count = Of(instruction, 1);
  const bool in_cl = count.kind == OperandKind::kRegister;
  const uint32_t n = d.width, mask = MaskOf(n), k = Read(count) & 31;
  if (!in_cl && k == 0) return;
  const Reach reach = d.kind == OperandKind::kMemory ? Find(d) : Reach{};
  const uint32_t before = d.kind == OperandKind::kMemory ? Get(reach, d.width) : Register(d.reg);
  if (in_cl) flags_.of = false;
  const Op op = instruction.op;
  const bool rotates = op == Op::kRol || op == Op::kRor || op == Op::kRcl || op == Op::kRcr;
  if (!rotates) flags_.af = false;  // undefined
  if (k == 0) return;
  const uint32_t times = op == Op::kRol || op == Op::kRor ? k % n : op == Op::kRcl || op == Op::kRcr ? k % (n + 1) : k;
  uint32_t r = before;
  for (uint32_t i = 0; i < times; ++i) {
    const bool top = Msb(r, n), low = (r & 1) != 0;
    const auto left = [&](bool in) { r = (r << 1 & mask) | (in ? 1 : 0); };
    const auto right = [&](bool in) { r = r >> 1 | (in ? 1U << (n - 1) : 0); };
    if (op == Op::kShl || op == Op::kRol || op == Op::kRcl) {
      left(op == Op::kRol ? top : op == Op::kRcl && flags_.cf);
      flags_.cf = top;
    } else {
      right(op == Op::kSar ? top : op == Op::kRor ? low : op == Op::kRcr && flags_.cf);
      flags_.cf = low;
    }
  }
  if (op == Op::kRol) flags_.cf = (r & 1) != 0;
  if (op == Op::kRor) flags_.cf = Msb(r, n);
  if (!rotates) {
    flags_.zf = r == 0;
    flags_.sf = Msb(r, n);
  }
  flags_.of = false;  // undefined unless the count is the constant 1
  if (!in_cl && k == 1) {
    if (op == Op::kShl || op == Op::kRol || op == Op::kRcl) {
      flags_.of = Msb(r, n) != flags_.cf;
    } else if (op == Op::kShr) {
      flags_.of = Msb(before, n);
    } else if (op == Op::kRor || op == Op::kRcr) {
      flags_.of = Msb(r, n) != ((r >> (n - 2) & 1) != 0);
    }
  }
  Write(d, reach, r);
}

void TechnolReference::Multiply(const Instruction& instruction) {
  const Operand& s = Of(instruction, 0);
  const uint32_t n = s.width;
  const uint32_t v = Read(s);
  const uint32_t a = Register(n == 8 ? Reg::kAl : n == 16 ? Reg::kAx : Reg::kEax);
  const bool has_sign = instruction.op == Op::kImul;
  const uint64_t product = has_sign ? static_cast<uint64_t>(SignedOf(a, n) * SignedOf(v, n)) : uint64_t{a} * v;
  const auto low = static_cast<uint32_t>(product), high = static_cast<uint32_t>(product >> n);
  if (n == 8) {
    SetRegister(Reg::kAx, low);
  } else {
    SetRegister(n == 16 ? Reg::kAx : Reg::kEax, low);
    SetRegister(n == 16 ? Reg::kDx : Reg::kEdx, high);
  }
  flags_ = {};
  flags_.cf = has_sign ? SignedOf(product, n) != static_cast<int64_t>(product) : (high & MaskOf(n)) != 0;
  flags_.of = flags_.cf;
}

void TechnolReference::Divide(const Instruction& instruction) {
  const Operand& s = Of(instruction, 0);
  const uint32_t n = s.width, mask = MaskOf(n);
  const uint32_t v = Read(s);
  const Reg quotient = n == 8 ? Reg::kAl : n == 16 ? Reg::kAx : Reg::kEax;
  const Reg remainder = n == 8 ? Reg::kAh : n == 16 ? Reg::kDx : Reg::kEdx;
  const uint64_t a = uint64_t{Register(remainder)} << n | Register(quotient);
  const bool has_sign = instruction.op == Op::kIdiv;
  uint64_t q = 0, r = 0;
  bool fits = v != 0;
  if (fits && !has_sign) {
    q = a / v;
    r = a % v;
    fits = q <= mask;
  } else if (fits) {
    const int64_t x = SignedOf(a, 2 * n), y = SignedOf(v, n);
    fits = !(x == INT64_MIN && y == -1);
    if (fits) {
      q = static_cast<uint64_t>(x / y);
      r = static_cast<uint64_t>(x % y);
      fits = SignedOf(q, n) == static_cast<int64_t>(q);
    }
  }
  if (!fits) {
    q = has_sign ? 1U << (n - 1) : mask;
    r = 0;
    Fault(TechnolFault::kDivide);
  }
  SetRegister(quotient, static_cast<uint32_t>(q));
  SetRegister(remainder, static_cast<uint32_t>(r));
  flags_ = {};
}

/// CBW ... AAD, CLC STC CMC, NOP
void TechnolReference::Adjust(const Instruction& instruction) {
  const uint32_t al = Register(Reg::kAl);
  const bool c = flags_.cf;
  const bool low_wrong = (al & 15) > 9 || flags_.af;
  switch (instruction.op) {
    case Op::kCbw:
      SetRegister(Reg::kAx, static_cast<uint32_t>(SignedOf(al, 8)));
      return;
    case Op::kCwd:
      SetRegister(Reg::kDx, Msb(Register(Reg::kAx), 16) ? 0xFFFF : 0);
      return;
    case Op::kCwde:
      SetRegister(Reg::kEax, static_cast<uint32_t>(SignedOf(Register(Reg::kAx), 16)));
      return;
    case Op::kCdq:
      SetRegister(Reg::kEdx, Msb(Register(Reg::kEax), 32) ? 0xFFFFFFFF : 0);
      return;
    case Op::kDaa: {
      uint32_t r = al + (low_wrong ? 6 : 0);
      flags_.af = low_wrong;
      flags_.cf = al > 0x99 || c;
      if (flags_.cf) r += 0x60;
      SetRegister(Reg::kAl, r);
      break;
    }
    case Op::kDas: {
      uint32_t r = al - (low_wrong ? 6 : 0);
      flags_.cf = low_wrong && (c || al < 6);
      flags_.af = low_wrong;
      if (al > 0x99 || c) {
        r -= 0x60;
        flags_.cf = true;
      }
      SetRegister(Reg::kAl, r);
      break;
    }
    case Op::kAam:
      SetRegister(Reg::kAh, al / 10);
      SetRegister(Reg::kAl, al % 10);
      flags_.cf = flags_.af = false;
      break;
    case Op::kAad:
      SetRegister(Reg::kAx, (al + 10 * Register(Reg::kAh)) & 0xFF);
      flags_.cf = flags_.af = false;
      break;
    case Op::kClc:
      flags_.cf = false;
      return;
    case Op::kStc:
      flags_.cf = true;
      return;
    case Op::kCmc:
      flags_.cf = !c;
      return;
    default:  // NOP
      return;
  }
  flags_.of = false;
  flags_.zf = Register(Reg::kAl) == 0;
  flags_.sf = Msb(Register(Reg::kAl), 8);
}

}  // namespace plcxx::reference
