#include "tests/reference/technol.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::reference {

using technol::InstructionId;
using technol::ModuleKind;
using technol::OperandKind;
using technol::UnitId;

namespace {

// Their bits.
constexpr uint32_t kHaltBit = 6;
constexpr uint32_t kPripravneBit = 0, kZaverecneBit = 1, kClearBit = 2;

/// 9.8.3
std::vector<uint8_t> TableImage(const technol::TechnologyTable& table) {
  std::vector<uint8_t> image(1632);
  const auto word = [&](uint32_t at, uint32_t value) {
    image[at] = static_cast<uint8_t>(value);
    image[at + 1] = static_cast<uint8_t>(value >> 8);
  };
  word(0, table.version);
  word(2, table.columns);
  word(4, table.rows);
  word(6, 0xFFFF);
  image[8] = 1;
  std::ranges::copy(table.name, image.begin() + 16);
  for (uint32_t k = 0; k < table.items.size(); ++k) {
    word(32 + 4 * k, table.items[k]);
    word(34 + 4 * k, table.items[k] >> 16);
  }
  return image;
}

}  // namespace

std::unique_ptr<Reference> MakeTechnolReference(dialects::Request& request, HostCalls host) {
  const technol::Settings settings = technol::ReadSettings(request.options);
  return std::make_unique<TechnolReference>(technol::Parse(request, settings), settings, std::move(host));
}

TechnolReference::TechnolReference(technol::Program program, const technol::Settings& settings, HostCalls host)
    : Reference(std::move(host)), program_(std::move(program)), settings_(settings), flow_(ReadFlow(program_)) {
  uint32_t mechanisms = 0;
  for (const technol::Unit& unit : program_.units) {
    progress_.push_back({.step = std::nullopt, .timers = std::vector<uint16_t>(unit.timers)});
    mechanisms_.push_back(unit.kind == technol::UnitKind::kMechanism ? mechanisms++ : 0);
  }
  memories_ = {{"IN", 64},          {"OUT", 64},           {"SYS", 9},      {"BUKON", 400},
               {"LABEL_MEM", 1000}, {"TAB_TECHNOL", 1632}, {"SET_NCTAB", 9}};
  memories_.emplace_back("DATA", static_cast<uint32_t>(program_.user_data.size()));
  memories_.emplace_back("mechanisms", mechanisms);
}

AddressSpace& TechnolReference::Area(technol::Area area) { return memories_[static_cast<size_t>(area)]; }
const AddressSpace& TechnolReference::Area(technol::Area area) const { return memories_[static_cast<size_t>(area)]; }

// --- schedule (4.3, 4.4) -------------------------------------------------------------------------------------------

void TechnolReference::PowerOn() {
  const auto fill = [](AddressSpace& memory, const auto& bytes) {
    for (uint32_t i = 0; i < bytes.size(); ++i) memory.Write(i, 0xFF, bytes[i]);
  };
  for (AddressSpace& memory : memories_) memory.Clear();
  for (Progress& progress : progress_) {
    progress.step.reset();
    std::ranges::fill(progress.timers, 0);
  }
  fill(Area(technol::Area::kUser), program_.user_data);
  AddressSpace& table = Area(technol::Area::kTabTechnol);
  if (program_.table) {
    fill(table, TableImage(*program_.table));
  } else {
    table.Write(6, 0xFF, 0xFF);  // TCH_VOLBA (D11)
    table.Write(7, 0xFF, 0xFF);
  }
  if (stored_table_) {
    fill(Area(technol::Area::kLabelMem), *stored_label_mem_);
    fill(table, *stored_table_);
  }
  if (flow_.machine_constants) Call("machine_constants");
  RunModule(ModuleKind::kInit);
}

void TechnolReference::StoreRetentive() {
  stored_label_mem_ = Area(technol::Area::kLabelMem).bytes();
  stored_table_ = Area(technol::Area::kTabTechnol).bytes();
}

void TechnolReference::RunFastOnly(uint32_t /*now_ms*/) {
  if (FindModule(program_, ModuleKind::kFast).valid()) ResetCleared();
  RunModule(ModuleKind::kFast);
}

/// What the host has cleared is as after MECH_INIT with mech-clear=abort (7.1): any part that runs sees it.
void TechnolReference::ResetCleared() {
  for (uint32_t i = 0; i < program_.units.size() && settings_.mech_clear == technol::MechClear::kAbort; ++i) {
    const bool mechanism = program_.units[UnitId(i)].kind == technol::UnitKind::kMechanism;
    if (mechanism && (memories_.back()[mechanisms_[i]] & 1) == 0) Reset(UnitId(i));
  }
}

void TechnolReference::RunPeriod(uint32_t /*now_ms*/) {
  Call("read_inputs");
  ResetCleared();
  if (SystemBit(kSysNc, kClearBit)) {
    RunModule(ModuleKind::kClear);
    ClearSystemBit(kSysNc, kClearBit);
  }
  RunFunctions(ModuleKind::kPripravne, kPripravneBit);
  RunModule(ModuleKind::kMain);
  for (uint32_t i = 0; i < program_.units.size(); ++i) {
    const technol::Unit& unit = program_.units[UnitId(i)];
    if (unit.kind == technol::UnitKind::kMechanism && !unit.parent.valid()) RunMechanism(UnitId(i));
  }
  RunFunctions(ModuleKind::kZaverecne, kZaverecneBit);
  if (SystemBit(kSysReq, kHaltBit) && FindModule(program_, ModuleKind::kHalt).valid()) {
    RunModule(ModuleKind::kHalt);
    Call("halt_pass");
  }
  Call("write_outputs");
  Requests();
}

bool TechnolReference::SystemBit(uint32_t byte, uint32_t bit) const {
  return (Area(technol::Area::kSys)[byte] >> bit & 1) != 0;
}

void TechnolReference::ClearSystemBit(uint32_t byte, uint32_t bit) {
  Area(technol::Area::kSys).Write(byte, static_cast<uint8_t>(1U << bit), 0);
}

void TechnolReference::RunModule(ModuleKind kind) {
  const UnitId unit = FindModule(program_, kind);
  if (!unit.valid()) return;
  ClearRegisters();
  RunUnit(unit, program_.units[unit].first.index);
}

void TechnolReference::RunFunctions(ModuleKind kind, uint32_t bit) {  // 7.4
  const UnitId unit = FindModule(program_, kind);
  if (!unit.valid()) {
    ClearSystemBit(kSysNc, bit);  // as an empty one
    return;
  }
  if (!SystemBit(kSysNc, bit)) {
    Reset(unit);
    return;
  }
  ClearRegisters();
  if (RunUnit(unit, progress_[unit.index].step.value_or(program_.units[unit].first.index)) != Next::kEnd) return;
  ClearSystemBit(kSysNc, bit);
  Reset(unit);
}

/// Step and automatic timers := 0.
void TechnolReference::Reset(UnitId unit) {
  progress_[unit.index].step.reset();
  std::ranges::fill(progress_[unit.index].timers, 0);
}

/// Inside the mechanism itself it leaves at once (6.7). A subprogram that it has called runs to its end: what stops
/// everything has to do all of it; but the mechanism is stopped, and its next start is from the beginning (7.1).
TechnolReference::Next TechnolReference::Stop(UnitId mechanism) {
  Reset(mechanism);
  if (mechanism != unit_) return Next::kOn;
  stopped_ = true;
  return calls_.empty() ? Next::kLeaves : Next::kOn;
}

void TechnolReference::RunMechanism(UnitId unit) {  // 6.7, 7.1
  const uint32_t bit = mechanisms_[unit.index];
  AddressSpace& bits = memories_.back();
  if ((bits[bit] & 1) != 0) {
    const std::optional<uint32_t> step = progress_[unit.index].step;
    if (step || !program_.units[unit].parent.valid()) ClearRegisters();
    const Next next = RunUnit(unit, step.value_or(program_.units[unit].first.index + 1));
    if (next == Next::kEnd) {
      bits.Write(bit, 1, 0);
      Reset(unit);
    }
  }
  ClearRegisters();  // nothing is usable behind MECH_END
}

TechnolReference::Next TechnolReference::RunUnit(UnitId unit, uint32_t from) {
  const UnitId outer_unit = std::exchange(unit_, unit);
  const uint32_t outer_jumps = std::exchange(jumps_, 0);
  const std::vector<uint32_t> outer_stack = std::exchange(stack_, {});
  pc_ = from;
  calls_.clear();
  Next next = Next::kOn;
  while (next == Next::kOn) next = Execute(pc_);
  calls_.clear();
  stopped_ = false;
  stack_ = outer_stack;
  unit_ = outer_unit;
  jumps_ = outer_jumps;
  return next;
}

void TechnolReference::ClearRegisters() {
  rlo_ = false;
  registers_ = {};
  flags_ = {};
}

void TechnolReference::Requests() {  // 8.1, 8.2
  constexpr const char* kCalls[] = {"send_plcmem", "send_tabtech", "set_nc_table",
                                    "backup_pos",  "backup_mem",   "close_all"};
  for (uint32_t bit = 0; bit < kHaltBit; ++bit) {
    if ((flow_.requests >> bit & 1) == 0 || !SystemBit(kSysReq, bit)) continue;
    if (bit == 2) {
      if (!TransferIsValid()) continue;
    } else {
      Call(kCalls[bit]);
    }
    if (Call("request", {bit}).result == 1) ClearSystemBit(kSysReq, bit);
  }
}

/// 8.4: the first field that is not valid is refused; valid ones are sent.
bool TechnolReference::TransferIsValid() {
  const AddressSpace& item = Area(technol::Area::kSetNctab);
  const auto between = [](uint32_t value, uint32_t least, uint32_t most) { return value >= least && value <= most; };
  const uint32_t table = item[2], column = item[3], row = item[4];
  const uint32_t data = item[5] | item[6] << 8 | item[7] << 16 | static_cast<uint32_t>(item[8]) << 24;
  bool digits = true;
  for (uint32_t k = 0; k < 8; ++k) digits = digits && ((data & 0x7FFFFFFFU) >> 4 * k & 15) <= 9;
  const bool valid[] = {
      item[0] == 1,
      item[1] <= 1,
      table == 1 || table == 2 || table == 6,
      between(column, 1,
              table == 1   ? 5
              : table == 2 ? 6
                           : 1),
      table == 1   ? between(row, 1, 99)
      : table == 2 ? between(row, 53, 59)
                   : row <= 95,
      digits,
  };
  for (uint32_t field = 0; field < std::size(valid); ++field) {
    if (valid[field]) continue;
    Call("nc_table_refused", {field});
    return false;
  }
  Call("set_nc_table", {item[0], item[1], table, column, row, data});
  return true;
}

void TechnolReference::Fault(TechnolFault kind) {
  if (trapped_) return;  // already left
  // A statement is a load with what is done to it: it begins at or before the instruction.
  auto id = statement_ids_.upper_bound(program_.instructions[InstructionId(at_)].range.begin);
  const bool known = id != statement_ids_.begin();
  Call("fault", {static_cast<uint64_t>(kind), known ? (--id)->second : 0});
}

// --- operands (6.1) ------------------------------------------------------------------------------------------------

bool TechnolReference::ReadBit(const Operand& operand) const {
  if (operand.is_activation_bit()) {
    return (memories_.back()[mechanisms_[operand.mechanism.index]] & 1) != 0;
  }
  return (Area(operand.address.area)[static_cast<uint32_t>(operand.address.offset)] >> operand.bit & 1) != 0;
}

TechnolReference::Next TechnolReference::WriteBit(const Operand& operand, bool value) {
  if (!operand.is_activation_bit()) {
    Area(operand.address.area)
        .Write(static_cast<uint32_t>(operand.address.offset), static_cast<uint8_t>(1U << operand.bit),
               value ? 0xFF : 0);
    return Next::kOn;
  }
  memories_.back().Write(mechanisms_[operand.mechanism.index], 1, value ? 1 : 0);
  if (value || settings_.mech_clear == technol::MechClear::kSuspend) return Next::kOn;
  return Stop(operand.mechanism);  // equal to MECH_INIT
}

TechnolReference::Reach TechnolReference::Find(const Operand& operand) {
  int64_t offset = operand.address.offset;
  if (operand.address.index != technol::Register::kNone) {
    const uint32_t index = Register(operand.address.index);
    offset += technol::Info(operand.address.index).width == 16 ? int64_t{static_cast<int16_t>(index)}
                                                               : int64_t{static_cast<int32_t>(index)};
  }
  AddressSpace& memory = Area(operand.address.area);
  if (offset >= 0 && offset + operand.width / 8 <= memory.size()) {
    return {.memory = &memory, .offset = static_cast<uint32_t>(offset)};
  }
  Fault(TechnolFault::kBounds);
  trapped_ = settings_.bounds == technol::Bounds::kTrap;
  return {};
}

uint32_t TechnolReference::Get(Reach reach, uint8_t width) {
  uint32_t value = 0;
  for (uint32_t i = 0; reach.memory != nullptr && i < width / 8U; ++i) {
    value |= static_cast<uint32_t>((*reach.memory)[reach.offset + i]) << (8 * i);
  }
  return value;
}

void TechnolReference::Put(Reach reach, uint8_t width, uint32_t value) {
  for (uint32_t i = 0; reach.memory != nullptr && i < width / 8U; ++i) {
    reach.memory->Write(reach.offset + i, 0xFF, static_cast<uint8_t>(value >> (8 * i)));
  }
}

/// Zero-extended; a constant modulo 2^32.
uint32_t TechnolReference::Read(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::kMemory:
      return Get(Find(operand), operand.width);
    case OperandKind::kRegister:
      return Register(operand.reg);
    case OperandKind::kAutomaticTimer:
      return TimerOf(operand);
    case OperandKind::kConstant:
    case OperandKind::kBit:
    case OperandKind::kLabel:
    case OperandKind::kMechanism:
    case OperandKind::kError:
      return static_cast<uint32_t>(operand.value);
  }
  return 0;
}

/// `reach`: of a memory operand, found once.
void TechnolReference::Write(const Operand& operand, Reach reach, uint32_t value) {
  if (operand.kind == OperandKind::kRegister) {
    SetRegister(operand.reg, value);
  } else {
    Put(reach, operand.width, value);
  }
}

uint32_t TechnolReference::Register(technol::Register reg) const {
  const technol::RegisterInfo& info = technol::Info(reg);
  const uint32_t whole = registers_[static_cast<size_t>(info.whole)] >> info.shift;
  return info.width == 32 ? whole : whole & ((1U << info.width) - 1);
}

void TechnolReference::SetRegister(technol::Register reg, uint32_t value) {
  const technol::RegisterInfo& info = technol::Info(reg);
  const uint32_t mask = (info.width == 32 ? 0xFFFFFFFFU : (1U << info.width) - 1) << info.shift;
  uint32_t& whole = registers_[static_cast<size_t>(info.whole)];
  whole = (whole & ~mask) | (value << info.shift & mask);
}

uint16_t& TechnolReference::TimerOf(const Operand& operand) { return progress_[unit_.index].timers[operand.timer]; }

}  // namespace plcxx::reference
