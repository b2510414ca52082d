#include "tests/reference/prostep.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "transpiler/dialects/prostep/parser/parser.h"

namespace plcxx::reference {

using prostep::Op;
using prostep::OperandClass;
using prostep::Shape;
using prostep::Space;

std::unique_ptr<Reference> MakeProstepReference(dialects::Request& request, HostCalls host) {
  return std::make_unique<ProstepReference>(prostep::Parse(*request.sources, request.files, *request.diagnostics),
                                            prostep::ReadSettings(request.options), std::move(host));
}

ProstepReference::ProstepReference(prostep::Program program, const prostep::Settings& settings, HostCalls host)
    : Reference(std::move(host)), program_(std::move(program)), settings_(settings), notes_(ReadSequences(program_)) {
  memories_ = {{"I", 256}, {"O", 256}, {"F", 256}, {"P", 12}};
  // D is three stretches: before, in and behind the retentive block.
  memories_.emplace_back("D", settings.first_retentive);
  memories_.emplace_back("D_kept", settings.last_retentive + 1 - settings.first_retentive);
  memories_.emplace_back("D_behind", 999 - settings.last_retentive);
}

// --- schedule (4.2 to 4.5) -----------------------------------------------------------------------------------------

void ProstepReference::PowerOn() {
  for (AddressSpace& memory : memories_) memory.Clear();
  timers_ = {};
  counters_ = {};
  PutBackForced();
  for (const prostep::DataDeclaration& data : program_.data) {
    for (uint32_t k = 0; k < data.bytes; ++k) {
      PutByte(Space::kD, data.address + k, static_cast<uint8_t>(data.value >> (8 * k)));
    }
  }
  if (retained_) {
    for (uint32_t k = 0; k < retained_->size(); ++k) {
      PutByte(Space::kD, settings_.first_retentive + k, (*retained_)[k]);
    }
  }
  PutByte(Space::kI, 20, 2);
  t_ = 0;
  jumps_ = 0;
  RunFromScheduler(0);
}

void ProstepReference::StoreRetentive() {
  retained_.emplace();
  for (uint32_t k = settings_.first_retentive; k <= settings_.last_retentive; ++k) {
    retained_->push_back(Byte(Space::kD, k));
  }
}

void ProstepReference::RunPeriod(uint32_t now_ms) {
  Tick(now_ms);
  SlowPass();
}

void ProstepReference::RunFastOnly(uint32_t now_ms) { Tick(now_ms); }

void ProstepReference::Tick(uint32_t t) {
  Advance(t - t_);
  t_ = t;
  RefreshInputs();
  // 8.1: bit 0 = 0, bit 1 = 1, bit 7 = (t / 500 ms) odd, before nc_to_plc
  PutByte(Space::kI, 20, static_cast<uint8_t>((Byte(Space::kI, 20) & 0x7CU) | 2U | ((t / 500) % 2 != 0 ? 0x80U : 0U)));
  Call("nc_to_plc");
  jumps_ = 0;
  for (uint32_t k = 1; k <= 8; ++k) {
    if ((Byte(Space::kF, 250) >> (k - 1) & 1) != 0) RunFromScheduler(k);
  }
  RefreshOutputs();
  Call("plc_to_nc");
}

void ProstepReference::SlowPass() {
  jumps_ = 0;
  for (uint32_t k = 9; k <= 16; ++k) {
    if ((Byte(Space::kF, 251) >> (k - 9) & 1) != 0) RunFromScheduler(k);
  }
}

void ProstepReference::RunElapse(uint32_t now_ms) {
  Advance(now_ms - t_);
  t_ = now_ms;
  if (settings_.io_refresh == prostep::IoRefresh::kMillisecond) {
    RefreshInputs();
    RefreshOutputs();
  }
}

void ProstepReference::RefreshInputs() {
  const uint32_t count = std::min<uint32_t>(Byte(Space::kD, 496) | Byte(Space::kD, 497) << 8, 24);
  for (uint32_t k = 0; k < count; ++k) {
    PutByte(Space::kI, k < 20 ? k : 44 + (k - 20), static_cast<uint8_t>(Call("read_port", {k}).result));
  }
}

void ProstepReference::RefreshOutputs() {
  const uint32_t count = std::min<uint32_t>(Byte(Space::kD, 498) | Byte(Space::kD, 499) << 8, 12);
  for (uint32_t k = 0; k < count; ++k) WriteByte(Space::kP, k, Byte(Space::kO, k));
}

void ProstepReference::Advance(uint32_t ms) {
  for (ProstepTimer& timer : timers_) {
    if (!timer.run) continue;
    timer.rem -= ms;
    if (timer.rem > 0) continue;
    timer.rem = 0;
    timer.run = false;
    timer.out = timer.type == Op::kOnDelay || timer.type == Op::kLatchedOnDelay;
  }
  PutBackForced();
}

void ProstepReference::Fault(ProstepFault code) { Call("fault", {static_cast<uint64_t>(code), module_}); }

void ProstepReference::RunFromScheduler(uint32_t number) {
  s_ = false;
  ax_ = 0;
  RunModule(number);
}

void ProstepReference::RunModule(uint32_t number) {
  const prostep::ModuleId id = program_.module_of[number];
  if (!id.valid()) return;
  const uint32_t caller = std::exchange(module_, number);
  first_flag_ = true;
  const prostep::Module& module = program_.modules[id];
  prostep::InstructionId at = module.begin_of();
  while (at.index < module.end_of().index) {
    const Next next = Execute(at);
    if (next == Next::kLeaves) break;
    at = next == Next::kJumped ? go_ : prostep::InstructionId(at.index + 1);
  }
  if (at.index == module.end_of().index) Fold(notes_.of_end[id.index]);
  module_ = caller;
}

// --- memory (5.1, 5.2, 6.4) ----------------------------------------------------------------------------------------

ProstepReference::Cell ProstepReference::At(Space space, uint32_t number) {
  if (space == Space::kI) return {.memory = &memories_[0], .offset = number};
  if (space == Space::kO) return {.memory = &memories_[1], .offset = number};
  if (space == Space::kF) return {.memory = &memories_[2], .offset = number};
  if (number < settings_.first_retentive) return {.memory = &memories_[4], .offset = number};
  if (number <= settings_.last_retentive) {
    return {.memory = &memories_[5], .offset = number - settings_.first_retentive};
  }
  return {.memory = &memories_[6], .offset = number - settings_.last_retentive - 1};
}

uint8_t ProstepReference::Byte(Space space, uint32_t number) {
  const Cell cell = At(space, number);
  return (*cell.memory)[cell.offset];
}

void ProstepReference::PutByte(Space space, uint32_t number, uint8_t value) {
  const Cell cell = At(space, number);
  cell.memory->Write(cell.offset, 0xFF, value);
}

uint8_t ProstepReference::ReadByte(Space space, uint32_t number) {
  return space == Space::kP ? static_cast<uint8_t>(Call("read_port", {number}).result) : Byte(space, number);
}

void ProstepReference::WriteByte(Space space, uint32_t number, uint8_t value) {
  if (space != Space::kP) {
    PutByte(space, number, value);
    return;
  }
  AddressSpace& latch = memories_[3];
  if (number < latch.size()) {
    latch.Write(number, 0xFF, value);
    value = latch[number];
  }
  Call("write_port", {number, value});
}

uint16_t ProstepReference::ReadData(const prostep::Operand& operand) {
  if (operand.kind == OperandClass::kK) return operand.value;
  uint16_t value = ReadByte(operand.space(), operand.number);
  if (operand.shape() == Shape::kWord) {
    value = static_cast<uint16_t>(value | ReadByte(operand.space(), operand.number + 1U) << 8);
  }
  return value;
}

void ProstepReference::WriteData(const prostep::Operand& operand, uint16_t value) {
  WriteByte(operand.space(), operand.number, static_cast<uint8_t>(value));
  if (operand.shape() == Shape::kWord) {
    WriteByte(operand.space(), operand.number + 1U, static_cast<uint8_t>(value >> 8));
  }
}

bool ProstepReference::BitValue(const prostep::Operand& operand) {  // 6.1.1
  if (operand.kind == OperandClass::kC) return counters_[operand.number].v != 0;
  if (operand.kind == OperandClass::kT) return timers_[operand.number].out;
  return (ReadByte(operand.space(), operand.number) >> operand.bit & 1) != 0;
}

void ProstepReference::WriteBit(const prostep::Operand& operand, bool value) {  // 6.2
  const uint8_t mask = static_cast<uint8_t>(1U << operand.bit);
  const uint8_t old =
      operand.space() == Space::kP ? memories_[3][operand.number] : Byte(operand.space(), operand.number);
  WriteByte(operand.space(), operand.number, static_cast<uint8_t>(value ? old | mask : old & ~mask));
}

// --- logic (6.1) ---------------------------------------------------------------------------------------------------

void ProstepReference::Fold(const SequenceNote& note) {
  if (!note.folds) return;
  s_ = orm_ || (!note.empty && s_);
  first_flag_ = false;
}

bool ProstepReference::First(const SequenceNote& note) const {
  const bool dynamic = settings_.first_check == prostep::FirstCheck::kDynamic && note.asks_flag;
  return dynamic ? first_flag_ : note.first;
}

void ProstepReference::Combine(bool is_and, bool v, const SequenceNote& note) {
  if (First(note)) {
    s_ = v;
  } else {
    s_ = is_and ? s_ && v : s_ || v;
  }
  first_flag_ = false;
}

void ProstepReference::Compare(const prostep::Instruction& instruction) {  // 6.3
  const prostep::Operand& operand = instruction.operand;
  const uint16_t raw = ReadData(operand);
  const bool narrow = operand.shape() == Shape::kByte;
  const int right = narrow ? static_cast<int8_t>(raw) : static_cast<int16_t>(raw);
  const int left = narrow ? static_cast<int8_t>(ax_) : static_cast<int16_t>(ax_);
  s_ = instruction.op == Op::kEqual       ? left == right
       : instruction.op == Op::kNotEqual  ? left != right
       : instruction.op == Op::kLess      ? left < right
       : instruction.op == Op::kLessEqual ? left <= right
       : instruction.op == Op::kGreater   ? left > right
                                          : left >= right;
  first_flag_ = false;
}

void ProstepReference::Load(const prostep::Operand& operand) {  // 6.4
  const uint16_t value = ReadData(operand);
  ax_ = operand.shape() == Shape::kByte ? static_cast<uint16_t>((ax_ & 0xFF00U) | value) : value;
}

// --- jumps (6.5) ---------------------------------------------------------------------------------------------------

ProstepReference::Next ProstepReference::Jump(const prostep::Instruction& instruction, prostep::InstructionId id) {
  go_ = program_.labels[instruction.target].at;
  if (go_.index > id.index) return Next::kJumped;
  if (jumps_ == settings_.loop_budget) {
    Fault(ProstepFault::kLoopBudget);
    return Next::kLeaves;
  }
  ++jumps_;
  return Next::kJumped;
}

// --- one instruction (6) -------------------------------------------------------------------------------------------

ProstepReference::Next ProstepReference::Execute(prostep::InstructionId id) {
  const prostep::Instruction& instruction = program_.instructions[id];
  const prostep::Operand& operand = instruction.operand;
  const SequenceNote& note = notes_.of_instruction[id.index];
  if (instruction.op != Op::kClose && instruction.op != Op::kAnd && instruction.op != Op::kAndNot) Fold(note);
  switch (instruction.op) {
    case Op::kAnd:
    case Op::kAndNot:
      Combine(true, BitValue(operand) != (instruction.op == Op::kAndNot), note);
      return Next::kOn;
    case Op::kOr:
    case Op::kOrNot:
      Combine(false, BitValue(operand) != (instruction.op == Op::kOrNot), note);
      return Next::kOn;
    case Op::kOrString:
      orm_ = !First(note) && s_;
      return Next::kOn;
    case Op::kOpenAnd:
    case Op::kOpenOr:
      brackets_.push_back({.is_and = instruction.op == Op::kOpenAnd, .s = s_, .orm = orm_, .first = first_flag_});
      return Next::kOn;
    case Op::kClose: {
      Fold(note);
      const bool v = s_;
      const Bracket bracket = brackets_.back();
      brackets_.pop_back();
      s_ = bracket.s;
      orm_ = bracket.orm;
      first_flag_ = bracket.first;
      Combine(bracket.is_and, v, note);
      return Next::kOn;
    }
    case Op::kAssign:
      WriteBit(operand, s_);
      break;
    case Op::kSet:
    case Op::kReset:
      if (s_) WriteBit(operand, instruction.op == Op::kSet);
      break;
    case Op::kCountUp:
    case Op::kCountDown:
    case Op::kSetCounter:
    case Op::kResetCounter:
      Count(instruction);
      break;
    case Op::kPulse:
    case Op::kExtendedPulse:
    case Op::kOnDelay:
    case Op::kLatchedOnDelay:
    case Op::kOffDelay:
      StartTimer(instruction);
      break;
    case Op::kResetTimer:
      if (s_) {
        ProstepTimer& timer = timers_[operand.number];
        timer.out = timer.run = false;
        timer.rem = 0;
        PutBackForced();
      }
      break;
    case Op::kEqual:
    case Op::kNotEqual:
    case Op::kLess:
    case Op::kLessEqual:
    case Op::kGreater:
    case Op::kGreaterEqual:
      Compare(instruction);
      return Next::kOn;
    case Op::kLoad:
      Load(operand);
      return Next::kOn;
    case Op::kLoadCounter:
      ax_ = static_cast<uint16_t>(counters_[operand.number].v);
      return Next::kOn;
    case Op::kLoadTimer:
      ax_ = static_cast<uint16_t>(TimeLeft(timers_[operand.number]));
      return Next::kOn;
    case Op::kLoadCounterBcd:
    case Op::kLoadTimerBcd: {
      // Time words with nibbles above 9 (D21) may leave more than 999 units: three digits of them.
      const bool timer = instruction.op == Op::kLoadTimerBcd;
      const uint32_t n = timer ? TimeLeft(timers_[operand.number]) : counters_[operand.number].v;
      const uint32_t digits = n / 100 % 10 << 8 | n / 10 % 10 << 4 | n % 10;
      ax_ = static_cast<uint16_t>(digits | (timer ? timers_[operand.number].sc << 12 : 0));
      return Next::kOn;
    }
    case Op::kTransfer:
      WriteData(operand, ax_);
      break;
    case Op::kJump:
      return Jump(instruction, id);
    case Op::kJumpIf:
      return s_ ? Jump(instruction, id) : Next::kOn;
    case Op::kCall:
    case Op::kCallIf:
      if (instruction.op == Op::kCall || s_) RunModule(operand.number);
      break;
    case Op::kPerform:
    case Op::kPerformIf:
      if (instruction.op == Op::kPerform || s_) Perform(instruction);
      break;
    case Op::kEndModule:
      first_flag_ = true;
      return Next::kLeaves;
    case Op::kEndModuleIf:
      if (s_) return Next::kLeaves;
      break;
    case Op::kNop:
    case Op::kUnknown:
      return Next::kOn;
  }
  first_flag_ = true;  // what gets here ends the sequence
  return Next::kOn;
}

// --- timers (7.1), counters (7.2) ----------------------------------------------------------------------------------

void ProstepReference::StartTimer(const prostep::Instruction& instruction) {
  ProstepTimer& timer = timers_[instruction.operand.number];
  const bool rise = s_ && !timer.edge;
  const bool fall = timer.edge && !s_;
  timer.edge = s_;
  timer.type = instruction.op;
  const auto load = [&] {
    const uint16_t word = ReadData(program_.Argument(instruction, 0));
    timer.sc = word >> 12 & 3;
    timer.scale = timer.sc == 0 ? 1 : timer.sc == 1 ? 10 : timer.sc == 2 ? 100 : 1000;
    timer.rem = static_cast<int64_t>((word >> 8 & 15) * 100 + (word >> 4 & 15) * 10 + (word & 15)) * timer.scale;
    return timer.rem > 0;
  };
  const bool restarts = instruction.op == Op::kExtendedPulse || (instruction.op == Op::kLatchedOnDelay && !timer.out);
  if (instruction.op == Op::kOffDelay) {
    if (rise) {
      timer.out = true;
      timer.run = false;
      timer.rem = 0;
    } else if (fall && timer.out) {
      timer.run = timer.out = load();
    }
  } else if (!s_ && (instruction.op == Op::kPulse || instruction.op == Op::kOnDelay)) {
    timer.out = timer.run = false;
    timer.rem = 0;
  } else if (rise && (restarts || instruction.op == Op::kPulse || instruction.op == Op::kOnDelay)) {
    timer.run = load();
    const bool pulse = instruction.op == Op::kPulse || instruction.op == Op::kExtendedPulse;
    timer.out = pulse ? timer.run : !timer.run;
  }
  PutBackForced();
  s_ = timer.out;
}

uint32_t ProstepReference::TimeLeft(const ProstepTimer& timer) const {
  return timer.rem == 0 ? 0 : static_cast<uint32_t>((timer.rem + timer.scale - 1) / timer.scale);
}

void ProstepReference::Count(const prostep::Instruction& instruction) {
  ProstepCounter& counter = counters_[instruction.operand.number];
  const bool s = s_;
  if (instruction.op == Op::kCountUp) {
    if (s && !counter.eu && counter.v < 999) ++counter.v;
    counter.eu = s;
  } else if (instruction.op == Op::kCountDown) {
    if (s && !counter.ed && counter.v > 0) --counter.v;
    counter.ed = s;
  } else if (instruction.op == Op::kResetCounter) {
    if (s) counter.v = 0;
  } else {
    const bool sets = s && (settings_.counter_set == prostep::CounterSet::kLevel || !counter.es);
    counter.es = s;
    if (sets) {
      const uint32_t w = ReadData(program_.Argument(instruction, 0));
      counter.v = std::min<uint32_t>(999, (w >> 8 & 15) * 100 + (w >> 4 & 15) * 10 + (w & 15));
    }
  }
  PutBackForced();
  if (instruction.op == Op::kCountUp || instruction.op == Op::kCountDown) s_ = counter.v != 0;
}

std::optional<Element> ProstepReference::FindElement(std::string_view instance, std::string_view field) {
  uint32_t number = 0;
  std::from_chars(instance.data() + 1, instance.data() + instance.size(), number);
  if (instance.front() == 'T' && number < timers_.size()) {
    ProstepTimer& timer = timers_[number];
    bool& bit = field == "edge" ? timer.edge : timer.out;
    if (field != "edge" && field != "output") return std::nullopt;
    return Element{.read = [&bit] { return uint64_t{bit}; }, .write = [&bit](uint64_t value) { bit = value != 0; }};
  }
  if (instance.front() == 'C' && number < counters_.size() && field == "value") {
    uint32_t& v = counters_[number].v;
    return Element{.read = [&v] { return uint64_t{v}; },
                   .write = [&v](uint64_t value) { v = static_cast<uint32_t>(value); }};
  }
  return std::nullopt;
}

}  // namespace plcxx::reference
