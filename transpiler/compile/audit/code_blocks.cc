// A function's instructions as blocks with the ways between them.
#include <algorithm>
#include <set>

#include "transpiler/compile/audit/object_reader.h"

namespace plcxx::compile::audit {

const Reference* ObjectReader::ReferenceIn(uint64_t section, uint64_t begin, uint64_t end) const {
  const auto all = references_.find(section);
  if (all == references_.end()) return nullptr;
  const auto found = all->second.lower_bound(begin);
  return found == all->second.end() || found->first >= end ? nullptr : &found->second;
}

uint32_t ObjectReader::FileIndex(const std::string& path) {
  const std::string name = path.starts_with("./") ? path.substr(2) : path;
  const auto [at, added] = file_index_.try_emplace(name, static_cast<uint32_t>(facts_.files.size()));
  if (added) facts_.files.push_back(name);
  return at->second;
}

std::map<uint64_t, CodeLine> ObjectReader::LinesOf(const Place& place) {
  std::map<uint64_t, CodeLine> lines;
  for (const std::unique_ptr<llvm::DWARFUnit>& unit : context_->compile_units()) {
    const llvm::DWARFDebugLine::LineTable* table = context_->getLineTableForUnit(unit.get());
    std::vector<uint32_t> rows;
    if (table == nullptr || !table->lookupAddressRange({place.begin, place.section}, place.end - place.begin, rows)) {
      continue;
    }
    for (const uint32_t row : rows) {
      const llvm::DWARFDebugLine::Row& known = table->Rows[row];
      if (known.Address.SectionIndex != place.section || known.EndSequence)
        continue;  // LLVM goes on with the next ones
      std::string name;
      table->getFileNameByIndex(known.File, "", llvm::DILineInfoSpecifier::FileLineInfoKind::RelativeFilePath, name);
      lines[known.Address.Address] = {FileIndex(name), known.Line};
    }
    if (!lines.empty()) break;
  }
  return lines;
}

bool ObjectReader::Disassemble(const Place& place, std::vector<Instruction>& out) {
  const auto islands = islands_.find(place.section);
  const auto data_until = [&](uint64_t address) -> uint64_t {
    if (islands == islands_.end()) return 0;
    const std::vector<Island>& all = islands->second;
    auto next = std::ranges::upper_bound(all, address, {}, &Island::begin);
    if (next == all.begin() || !std::prev(next)->data) return 0;
    return next == all.end() ? place.end : next->begin;
  };
  for (uint64_t at = place.begin; at < place.end;) {
    if (const uint64_t behind = data_until(at); behind > at) {
      at = behind;
      continue;
    }
    const auto* bytes = reinterpret_cast<const uint8_t*>(place.bytes.data());
    Instruction instruction;
    if (!machine_.Decode({bytes + at, place.end - at}, at, instruction)) return false;
    at += instruction.bytes;
    out.push_back(std::move(instruction));
  }
  return !out.empty();
}

/// Where the linker's notes say more than the instruction itself: targets in other sections, and on RISC-V all.
void ObjectReader::Resolve(const Place& place, std::vector<Instruction>& code, std::vector<CodeCall>& calls,
                           std::vector<bool>& has_call, CodeFunction& function) const {
  for (size_t i = 0; i < code.size(); ++i) {
    Instruction& instruction = code[i];
    const bool jumps = instruction.flow != Flow::kNext && instruction.flow != Flow::kReturn &&
                       instruction.flow != Flow::kMaybeReturn && instruction.flow != Flow::kStop;
    if (!jumps) continue;
    const Reference* reference =
        ReferenceIn(place.section, instruction.address, instruction.address + instruction.bytes);
    // RISC-V's far call: the note is at the auipc in front.
    const bool indirect = instruction.flow == Flow::kIndirectJump || instruction.flow == Flow::kIndirectCall;
    if (machine_.is_riscv() && indirect && i > 0 && machine_.OpcodeName(code[i - 1].inst) == "AUIPC") {
      reference = ReferenceIn(place.section, code[i - 1].address, code[i - 1].address + code[i - 1].bytes);
      if (reference != nullptr) {
        instruction.flow = instruction.flow == Flow::kIndirectCall ? Flow::kCall : Flow::kJump;
      }
    }
    if (instruction.flow == Flow::kIndirectCall) ++function.indirect_calls;
    if (instruction.flow == Flow::kIndirectJump) ++function.indirect_jumps;
    if (instruction.flow == Flow::kIndirectCall || instruction.flow == Flow::kIndirectJump) continue;

    uint64_t section = place.section;
    uint32_t symbol = kNoFunction;
    if (reference != nullptr) {
      const bool defined = facts_.symbols[reference->symbol].defined;
      symbol = reference->symbol;
      section = defined ? reference->section : 0;
      instruction.target = defined ? std::optional<uint64_t>(reference->address) : std::nullopt;
      const auto at = function_at_.find({reference->section, reference->address});
      if (defined && at != function_at_.end()) symbol = at->second;
    } else if (instruction.target) {
      const auto at = function_at_.find({section, *instruction.target});
      if (at != function_at_.end()) symbol = at->second;
    }
    const bool inside = instruction.target && section == place.section && *instruction.target >= place.begin &&
                        *instruction.target < place.end;
    // Where a branch of Thumb-1 does not reach, GCC jumps within the function by a call that nobody returns from.
    const bool far_jump = instruction.flow == Flow::kCall && inside && *instruction.target != place.begin;
    if (far_jump) instruction.flow = Flow::kJump;
    const bool tail = instruction.flow != Flow::kCall;
    if (tail && inside) continue;
    instruction.target.reset();
    if (symbol == kNoFunction) {
      ++function.indirect_jumps;  // into the middle of something: nothing is known of it
      continue;
    }
    calls[i] = {symbol, tail};
    has_call[i] = true;
    if (instruction.flow == Flow::kJump) instruction.flow = Flow::kReturn;
    if (instruction.flow == Flow::kBranch) instruction.flow = Flow::kMaybeReturn;
  }
}

void ObjectReader::MakeBlocks(const Place& place, CodeFunction& function) {
  std::vector<Instruction> code;
  function.decoded = Disassemble(place, code);
  if (!function.decoded) return;
  std::vector<CodeCall> calls(code.size());
  std::vector<bool> has_call(code.size());
  Resolve(place, code, calls, has_call, function);

  std::set<uint64_t> begins = {code.front().address};
  for (const Instruction& instruction : code) {
    if (instruction.flow == Flow::kNext || instruction.flow == Flow::kCall || instruction.flow == Flow::kIndirectCall) {
      continue;
    }
    begins.insert(instruction.address + instruction.bytes);
    if (instruction.target) begins.insert(*instruction.target);
  }
  std::map<uint64_t, uint32_t> block_at;
  for (const Instruction& instruction : code) {
    if (begins.contains(instruction.address)) {
      const auto next = static_cast<uint32_t>(block_at.size());
      block_at.emplace(instruction.address, next);
    }
  }
  const std::map<uint64_t, CodeLine> lines = LinesOf(place);
  const auto line_of = [&](uint64_t address) {
    auto found = lines.upper_bound(address);
    return found == lines.begin() ? CodeLine() : std::prev(found)->second;
  };

  function.blocks.resize(block_at.size());
  for (size_t begin = 0, number = 0; begin < code.size(); ++number) {
    size_t end = begin + 1;
    while (end < code.size() && !block_at.contains(code[end].address)) ++end;
    CodeBlock& block = function.blocks[number];
    block.instructions = static_cast<uint32_t>(end - begin);
    block.cycles_k = timing_.Cycles(llvm::ArrayRef(code).slice(begin, end - begin));
    for (size_t i = begin; i < end; ++i) {
      if (has_call[i]) block.calls.push_back(calls[i]);
      if (has_call[i] && !calls[i].tail) block.cycles_k += timing_.CallCycles();
      const CodeLine line = line_of(code[i].address);
      if (std::ranges::find(block.lines, line) == block.lines.end()) block.lines.push_back(line);
    }
    const Instruction& last = code[end - 1];
    block.last = line_of(last.address);
    const bool returns = last.flow == Flow::kReturn || last.flow == Flow::kMaybeReturn;
    if (returns) block.cycles_k += timing_.CallCycles();
    if (last.target && (last.flow == Flow::kBranch || last.flow == Flow::kJump)) {
      const auto target = block_at.find(*last.target);
      if (target == block_at.end()) {
        ++function.indirect_jumps;
      } else {
        block.successors.push_back({target->second, timing_.TakenCycles()});
      }
    }
    const bool goes_on = last.flow != Flow::kReturn && last.flow != Flow::kJump && last.flow != Flow::kIndirectJump &&
                         last.flow != Flow::kStop && number + 1 < function.blocks.size();
    if (goes_on) block.successors.push_back({static_cast<uint32_t>(number + 1), 0});
    block.leaves = returns || block.successors.empty();
    begin = end;
  }
}

}  // namespace plcxx::compile::audit
