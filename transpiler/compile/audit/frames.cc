#include "transpiler/compile/audit/frames.h"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/DebugInfo/DWARF/DWARFDebugFrame.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace plcxx::compile::audit {
namespace {

using llvm::dwarf::CFIProgram;

/// Where an entry of 32-bit DWARF has the address of its function: after its length and the link to what it shares.
constexpr uint64_t kAddressInEntry = 8;

/// By offset in .debug_frame: the section and address of the function that is meant.
std::map<uint64_t, std::pair<uint64_t, uint64_t>> FunctionsOfEntries(const llvm::object::ELFObjectFileBase& object) {
  std::map<uint64_t, std::pair<uint64_t, uint64_t>> functions;
  for (const llvm::object::SectionRef& section : object.sections()) {
    llvm::Expected<llvm::object::section_iterator> relocated = section.getRelocatedSection();
    if (!relocated) {
      llvm::consumeError(relocated.takeError());
      continue;
    }
    if (*relocated == object.section_end()) continue;
    llvm::Expected<llvm::StringRef> name = (*relocated)->getName();
    if (!name || *name != ".debug_frame") {
      if (!name) llvm::consumeError(name.takeError());
      continue;
    }
    for (const llvm::object::RelocationRef& relocation : section.relocations()) {
      const llvm::object::symbol_iterator symbol = relocation.getSymbol();
      if (symbol == object.symbol_end()) continue;
      llvm::Expected<llvm::object::section_iterator> target = symbol->getSection();
      llvm::Expected<uint64_t> address = symbol->getValue();
      if (!target || !address || *target == object.section_end()) {
        if (!target) llvm::consumeError(target.takeError());
        if (!address) llvm::consumeError(address.takeError());
        continue;
      }
      uint64_t at = *address & ~uint64_t{object.getArch() == llvm::Triple::arm ? 1u : 0u};
      llvm::Expected<int64_t> addend = llvm::object::ELFRelocationRef(relocation).getAddend();
      if (addend) {
        at += static_cast<uint64_t>(*addend);
      } else {
        llvm::consumeError(addend.takeError());  // of REL sections: the address of the section itself, or of a symbol
      }
      functions.try_emplace(relocation.getOffset(), (*target)->getIndex(), at);
    }
  }
  return functions;
}

/// The greatest distance between the stack pointer and where it stood before the call.
class FrameReader {
 public:
  explicit FrameReader(uint64_t stack_pointer) : stack_pointer_(stack_pointer) {}

  void Execute(const CFIProgram& program) {
    for (const CFIProgram::Instruction& instruction : program) Execute(instruction);
  }
  Frame frame() const { return frame_; }

 private:
  struct Rule {
    uint64_t reg = 0;
    uint64_t offset = 0;
  };

  void Execute(const CFIProgram::Instruction& instruction) {
    using namespace llvm::dwarf;
    switch (instruction.Opcode) {
      case DW_CFA_def_cfa:
        rule_ = {instruction.Ops[0], instruction.Ops[1]};
        break;
      case DW_CFA_def_cfa_offset:
        rule_.offset = instruction.Ops[0];
        break;
      case DW_CFA_def_cfa_register:
        rule_.reg = instruction.Ops[0];
        break;
      case DW_CFA_def_cfa_expression:
        frame_.known = false;
        return;
      case DW_CFA_remember_state:
        remembered_.push_back(rule_);
        return;
      case DW_CFA_restore_state:
        if (!remembered_.empty()) {
          rule_ = remembered_.back();
          remembered_.pop_back();
        }
        break;
      default:  // of DWARF's numbers: places of registers, and steps of the address
        return;
    }
    if (rule_.reg != stack_pointer_) frame_.known = false;
    frame_.bytes = std::max(frame_.bytes, rule_.offset);
  }

  uint64_t stack_pointer_;
  Rule rule_;
  std::vector<Rule> remembered_;
  Frame frame_;
};

}  // namespace

Frames ReadFrames(const llvm::object::ELFObjectFileBase& object, llvm::DWARFContext& context, uint64_t stack_pointer) {
  Frames frames;
  llvm::Expected<const llvm::DWARFDebugFrame*> table = context.getDebugFrame();
  if (!table) {
    llvm::consumeError(table.takeError());
    return frames;
  }
  const auto functions = FunctionsOfEntries(object);
  for (const llvm::dwarf::FrameEntry& entry : (*table)->entries()) {
    const auto* description = llvm::dyn_cast<llvm::dwarf::FDE>(&entry);
    if (description == nullptr || description->getLinkedCIE() == nullptr) continue;
    const auto function = functions.find(description->getOffset() + kAddressInEntry);
    if (function == functions.end()) continue;
    FrameReader reader(stack_pointer);
    reader.Execute(description->getLinkedCIE()->cfis());
    reader.Execute(description->cfis());
    frames[function->second] = reader.frame();
  }
  return frames;
}

}  // namespace plcxx::compile::audit
