// What the linker does to instructions: it writes into them, and on RISC-V it takes some away.
#include <llvm/BinaryFormat/ELF.h>

#include <algorithm>
#include <span>

#include "transpiler/prove/verify/machine_code/lifter.h"

namespace plcxx::prove::verify::machine_code {
namespace {

constexpr uint64_t kMostNoteBytes = 8;

/// Bytes that a note of a type is about.
struct NoteBytes {
  uint64_t type, bytes;
};

constexpr NoteBytes kRiscvNotes[] = {
    {llvm::ELF::R_RISCV_NONE, 0},         {llvm::ELF::R_RISCV_RELAX, 0},
    {llvm::ELF::R_RISCV_ALIGN, 0},  // of the section (Section::may_go)
    {llvm::ELF::R_RISCV_RVC_BRANCH, 2},   {llvm::ELF::R_RISCV_RVC_JUMP, 2},
    {llvm::ELF::R_RISCV_32, 4},           {llvm::ELF::R_RISCV_ADD32, 4},
    {llvm::ELF::R_RISCV_SUB32, 4},        {llvm::ELF::R_RISCV_BRANCH, 4},
    {llvm::ELF::R_RISCV_JAL, 4},          {llvm::ELF::R_RISCV_HI20, 4},
    {llvm::ELF::R_RISCV_LO12_I, 4},       {llvm::ELF::R_RISCV_LO12_S, 4},
    {llvm::ELF::R_RISCV_PCREL_HI20, 4},   {llvm::ELF::R_RISCV_PCREL_LO12_I, 4},
    {llvm::ELF::R_RISCV_PCREL_LO12_S, 4},
};

constexpr NoteBytes kArmNotes[] = {
    {llvm::ELF::R_ARM_NONE, 0},         {llvm::ELF::R_ARM_THM_JUMP8, 2},  {llvm::ELF::R_ARM_THM_JUMP11, 2},
    {llvm::ELF::R_ARM_ABS32, 4},        {llvm::ELF::R_ARM_REL32, 4},      {llvm::ELF::R_ARM_THM_CALL, 4},
    {llvm::ELF::R_ARM_THM_JUMP19, 4},   {llvm::ELF::R_ARM_THM_JUMP24, 4}, {llvm::ELF::R_ARM_THM_MOVW_ABS_NC, 4},
    {llvm::ELF::R_ARM_THM_MOVT_ABS, 4},
};

/// Of a type that has no row here, of which LLVM knows dozens, as many as any has.
uint64_t BytesIn(std::span<const NoteBytes> rows, uint64_t type) {
  const auto row = std::ranges::find(rows, type, &NoteBytes::type);
  return row == rows.end() ? kMostNoteBytes : row->bytes;
}

}  // namespace

uint64_t Program::BytesOf(const Link& link) const {
  return BytesIn(machine_.is_arm() ? std::span<const NoteBytes>(kArmNotes) : kRiscvNotes, link.type);
}

std::vector<std::pair<uint64_t, const Link*>> Program::NotesOn(const Section& section, uint64_t begin,
                                                               uint64_t bytes) const {
  std::vector<std::pair<uint64_t, const Link*>> notes;
  const auto last = section.links.lower_bound(begin + bytes);
  for (auto link = section.links.lower_bound(begin < kMostNoteBytes ? 0 : begin - kMostNoteBytes); link != last; ++link)
    if (link->first + BytesOf(link->second) > begin) notes.emplace_back(link->first, &link->second);
  return notes;
}

const Link* FunctionLifter::LinkAt(std::initializer_list<uint64_t> types) {
  const auto [first, last] = section().links.equal_range(current_->address);
  for (auto link = first; link != last; ++link) {
    if (std::find(types.begin(), types.end(), link->second.type) == types.end()) continue;
    // What it writes must be the instruction; of a far call it is the following one, too.
    const uint64_t bytes = program_.BytesOf(link->second);
    if (bytes != current_->bytes && (bytes != 8 || current_->bytes != 4)) continue;
    understood_.insert(&link->second);
    return &link->second;
  }
  return nullptr;
}

bool FunctionLifter::MayBeRelaxed() const {
  const auto [first, last] = section().links.equal_range(current_->address);
  return program_.machine().is_riscv() &&
         std::any_of(first, last, [](const auto& link) { return link.second.type == llvm::ELF::R_RISCV_RELAX; });
}

/// RISC-V's `addi x0, x0, 0`, whatever its length.
bool FunctionLifter::DoesNothing() const {
  const llvm::StringRef name = program_.machine().OpcodeName(current_->inst);
  if (name == "C_NOP") return true;
  const auto is_zero = [&](unsigned operand) {
    const llvm::MCOperand& one = current_->inst.getOperand(operand);
    return one.isReg() ? program_.machine().registers().getEncodingValue(one.getReg()) == 0
                       : one.isImm() && one.getImm() == 0;
  };
  return name == "ADDI" && is_zero(0) && is_zero(1) && is_zero(2);
}

bool FunctionLifter::HasOpenNote() const {
  const uint64_t begin = current_->address, end = begin + current_->bytes;
  for (const auto& [offset, link] : program_.NotesOn(section(), begin, current_->bytes)) {
    if (!understood_.contains(link)) return true;
  }
  // Of bytes that the linker takes away to align what follows any number may be left.
  for (const auto& [from, to] : section().may_go) {
    const bool inside = from <= begin && end <= to;
    if (from < end && begin < to && !(inside && DoesNothing())) return true;
  }
  return false;
}

bool FunctionLifter::MayMoveTo(uint64_t target) const {
  if (!program_.machine().is_riscv()) return false;
  const uint64_t begin = std::min(target, current_->address), end = std::max(target, current_->address);
  for (auto link = section().links.lower_bound(begin); link != section().links.lower_bound(end); ++link) {
    if (link->second.type == llvm::ELF::R_RISCV_RELAX) return true;
  }
  return std::ranges::any_of(section().may_go, [&](const auto& gap) { return gap.first < end && begin < gap.second; });
}

}  // namespace plcxx::prove::verify::machine_code
