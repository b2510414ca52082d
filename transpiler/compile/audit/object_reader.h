// One object file on its way to facts. Only audit/*.cc include this.
#pragma once

#include <llvm/DebugInfo/DWARF/DWARFContext.h>
#include <llvm/Object/ELFObjectFile.h>

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/compile/audit/frames.h"
#include "transpiler/compile/audit/machine_code.h"
#include "transpiler/compile/object_facts.h"

namespace plcxx::compile::audit {

/// What a place in a section refers to.
struct Reference {
  uint32_t symbol = 0;                // index into ObjectFacts::symbols
  uint64_t section = 0, address = 0;  // of the symbol, when it is defined
};

class ObjectReader {
 public:
  ObjectReader(const llvm::object::ELFObjectFileBase& object, MachineCode& machine, ObjectFacts& facts)
      : object_(object),
        machine_(machine),
        timing_(machine),
        facts_(facts),
        // Its warnings are about tables that nobody asks for here.
        context_(llvm::DWARFContext::create(object, llvm::DWARFContext::ProcessDebugRelocations::Process, nullptr, "",
                                            llvm::consumeError, llvm::consumeError)) {}

  void Run();

 private:
  struct Place {
    uint64_t section, begin, end;
    llvm::StringRef bytes;  // of the section
  };
  struct Island {  // constants between instructions, as ARM's mapping symbols tell them
    uint64_t begin;
    bool data;
  };

  void ReadSections();
  void ReadSymbols();
  void ReadReferences();
  void ReadFunction(uint32_t function);
  std::vector<uint32_t> ConstantsOf(const Place& place) const;

  // code_blocks.cc
  /// False when some bytes are no instruction.
  bool Disassemble(const Place& place, std::vector<Instruction>& out);
  void Resolve(const Place& place, std::vector<Instruction>& code, std::vector<CodeCall>& calls,
               std::vector<bool>& has_call, CodeFunction& function) const;
  void MakeBlocks(const Place& place, CodeFunction& function);
  const Reference* ReferenceIn(uint64_t section, uint64_t begin, uint64_t end) const;
  uint32_t FileIndex(const std::string& name);
  /// By address in the function.
  std::map<uint64_t, CodeLine> LinesOf(const Place& place);

  const llvm::object::ELFObjectFileBase& object_;
  MachineCode& machine_;
  Timing timing_;
  ObjectFacts& facts_;
  std::unique_ptr<llvm::DWARFContext> context_;
  Frames frames_;
  std::vector<Place> places_;                                      // by function
  std::map<std::pair<uint64_t, uint64_t>, uint32_t> function_at_;  // by section and address: its symbol
  std::map<uint64_t, std::map<uint64_t, Reference>> references_;   // by section and offset
  std::map<uint64_t, uint32_t> constants_at_;                      // by section index: in ObjectFacts::sections
  std::map<uint64_t, std::vector<Island>> islands_;                // by section, ascending
  std::unordered_map<uint64_t, uint32_t> symbol_index_;            // by the object's own number
  std::unordered_map<std::string, uint32_t> file_index_;
};

}  // namespace plcxx::compile::audit
