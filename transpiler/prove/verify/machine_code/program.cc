// All functions of a program: what is lifted, and around what.
#include <llvm/MC/MCInstrDesc.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/function_name.h"
#include "transpiler/prove/verify/llvm_ir/refusal.h"
#include "transpiler/prove/verify/machine_code/lifter.h"

namespace plcxx::prove::verify::machine_code {

Program::Program(llvm::LLVMContext& context, const Objects& objects, compile::audit::MachineCode& machine,
                 std::span<const Signature> signatures)
    : context_(context),
      objects_(objects),
      machine_(machine),
      convention_(machine.is_arm() ? ArmConvention() : RiscvConvention(objects.first().is64Bit() ? 64 : 32)) {
  for (const Signature& signature : signatures) signatures_.emplace(signature.function, &signature);
}

llvm::FunctionType* Program::LiftedType() const {
  llvm::IntegerType* word = llvm::IntegerType::get(context_, convention_.bits);
  const std::vector<llvm::Type*> registers(convention_.registers, word);
  return llvm::FunctionType::get(llvm::StructType::get(context_, registers), registers, false);
}

const Signature* Program::SignatureOf(const std::string& symbol) const {
  // What the compiler has split off or specialised is another function than the one that was declared.
  if (symbol.find('.') != std::string::npos) return nullptr;
  const auto found = signatures_.find(llvm_ir::NameInSource(symbol));
  return found == signatures_.end() ? nullptr : found->second;
}

llvm::GlobalVariable& Program::ConstantsOf(uint32_t number, uint64_t first, uint64_t count) {
  llvm::GlobalVariable*& constants = constants_[{number, first}];
  if (constants != nullptr) return *constants;
  const Section& section = objects_.sections()[number];
  std::vector<llvm::Constant*> bytes;
  llvm::Type* byte = llvm::Type::getInt8Ty(context_);
  for (const char one : section.bytes.substr(first, count))
    bytes.push_back(llvm::ConstantInt::get(byte, static_cast<uint8_t>(one)));
  // What the linker will write is no number that is known.
  for (const auto& [offset, link] : NotesOn(section, first, bytes.size())) {
    for (uint64_t at = std::max(offset, first); at < offset + BytesOf(*link) && at - first < bytes.size(); ++at)
      bytes[at - first] = llvm::UndefValue::get(byte);
  }
  std::vector<llvm::Type*> types(bytes.size(), byte);
  auto* type = llvm::StructType::get(context_, types, /*isPacked=*/true);
  constants = new llvm::GlobalVariable(*module_, type, /*isConstant=*/true, llvm::GlobalValue::PrivateLinkage,
                                       llvm::ConstantStruct::get(type, bytes), section.name);
  const llvm::Align align(section.align == 0 ? 1 : section.align);
  constants->setAlignment(llvm::commonAlignment(align, first));
  return *constants;
}

llvm::GlobalVariable& Program::PartOf(AddressPart part, const Place& place) {
  llvm::GlobalVariable*& variable = parts_[{part, place}];
  if (variable != nullptr) return *variable;
  // Of no bytes: whatever is read or written by it is outside.
  llvm::Type* nothing = llvm::ArrayType::get(llvm::Type::getInt8Ty(context_), 0);
  variable = new llvm::GlobalVariable(*module_, nothing, /*isConstant=*/true, llvm::GlobalValue::PrivateLinkage,
                                      llvm::ConstantAggregateZero::get(nothing), "part of an address");
  return *variable;
}

std::vector<llvm::Value*> Program::Split(Builder& build, llvm::Value* value) const {
  llvm::IntegerType* word = llvm::IntegerType::get(context_, convention_.bits);
  const unsigned width = value->getType()->getIntegerBitWidth();
  if (width <= convention_.bits) return {width < convention_.bits ? build.CreateZExt(value, word) : value};
  return {build.CreateTrunc(value, word), build.CreateTrunc(build.CreateLShr(value, convention_.bits), word)};
}

llvm::Value* Program::Join(Builder& build, std::span<llvm::Value* const> words, unsigned width) const {
  llvm::Type* type = llvm::IntegerType::get(context_, width);
  if (width <= convention_.bits) return width < convention_.bits ? build.CreateTrunc(words[0], type) : words[0];
  llvm::Value* high = build.CreateShl(build.CreateZExt(words[1], type), convention_.bits);
  return build.CreateOr(high, build.CreateZExt(words[0], type));
}

void Program::CallRefusal(Builder& build, const std::string& what) {
  llvm::FunctionType* type = llvm::FunctionType::get(build.getVoidTy(), false);
  build.CreateCall(module_->getOrInsertFunction(std::string(llvm_ir::kRefusal) + what, type));
}

/// How many instructions an IT puts under a condition: its mask ends with a 1.
unsigned Program::InstructionsUnder(const llvm::MCInst& inst) const {
  if (machine_.OpcodeName(inst) != "t2IT") return 0;
  const auto mask = static_cast<uint32_t>(inst.getOperand(1).getImm());
  return 4 - static_cast<unsigned>(std::countr_zero(mask | 16U));
}

/// The decoder goes on with conditions of what it decoded last, which may be another function's end.
void Program::EndConditions() {
  constexpr uint8_t kNop[] = {0x00, 0xBF};
  compile::audit::Instruction nop;
  for (unsigned i = 0; machine_.is_arm() && i < 4; ++i) machine_.Decode(kNop, 0, nop);
}

void Program::Decode() {
  for (const Function& function : objects_.functions()) {
    std::vector<compile::audit::Instruction>& code = code_.emplace_back();
    const Section& section = objects_.sections()[function.place.section];
    const uint64_t begin = function.place.offset, end = begin + function.bytes;
    if (end > section.bytes.size()) continue;
    const llvm::ArrayRef<uint8_t> bytes(reinterpret_cast<const uint8_t*>(section.bytes.data()), section.bytes.size());
    bool data = false;
    unsigned conditions = 0;  // instructions that are under one
    EndConditions();
    for (uint64_t at = begin; at < end;) {
      const auto mark = section.data_begins.find(at);
      if (mark != section.data_begins.end()) data = mark->second;
      if (data) {
        conditions = 0;
        EndConditions();
        ++at;
        continue;
      }
      compile::audit::Instruction instruction;
      // Under a condition only the last one goes elsewhere: the conditions would go on there.
      const bool is_instruction = machine_.Decode(bytes.slice(at, end - at), at, instruction) &&
                                  (conditions < 2 || instruction.flow == compile::audit::Flow::kNext);
      if (!is_instruction) {
        code.clear();
        break;
      }
      conditions = std::max(conditions, 1U) - 1 + InstructionsUnder(instruction.inst);
      at += instruction.bytes;
      code.push_back(std::move(instruction));
    }
  }
}

/// What it writes stands in front of its operands; a list of registers after them is loaded, or only read.
void Program::NoteWrites(const llvm::MCInst& inst, std::vector<bool>& writes) const {
  const llvm::MCInstrDesc& description = machine_.Describe(inst);
  const bool loads_list = description.isVariadic() && description.mayLoad();
  for (unsigned i = 0; i < (loads_list ? inst.getNumOperands() : description.getNumDefs()); ++i) {
    const llvm::MCOperand& operand = inst.getOperand(i);
    const bool is_flags = i < description.getNumOperands() && description.operands()[i].isOptionalDef();
    if (!operand.isReg() || operand.getReg() == 0 || is_flags) continue;
    const unsigned number = machine_.registers().getEncodingValue(operand.getReg());
    if (number < convention_.registers) writes[number] = true;
  }
}

/// Directly, and by what each calls.
void Program::FindWrites() {
  const std::vector<Function>& functions = objects_.functions();
  writes_.assign(functions.size(), std::vector<bool>(convention_.registers));
  std::vector<std::vector<uint32_t>> callees(functions.size());
  for (uint32_t i = 0; i < functions.size(); ++i) {
    const Section& section = objects_.sections()[functions[i].place.section];
    const uint64_t begin = functions[i].place.offset, end = begin + functions[i].bytes;
    bool knows_all = !code_[i].empty();
    for (const compile::audit::Instruction& instruction : code_[i]) {
      NoteWrites(instruction.inst, writes_[i]);
      const bool indirect = instruction.flow == compile::audit::Flow::kIndirectCall ||
                            instruction.flow == compile::audit::Flow::kIndirectJump;
      const bool far_calls = machine_.is_riscv();  // auipc and jalr, the linker's note tells of them
      if (indirect && !far_calls) knows_all = false;
    }
    const auto first = section.links.lower_bound(begin), last = section.links.lower_bound(end);
    for (auto link = first; link != last; ++link) {
      const Link& to = link->second;
      const bool inside = to.defined && to.defined->section == functions[i].place.section &&
                          to.defined->offset >= begin && to.defined->offset < end;
      if (to.binding == Link::Binding::kNone) continue;  // for the linker alone
      if (inside || (to.defined && !objects_.sections()[to.defined->section].is_code)) continue;
      if (const auto callee = objects_.FunctionOf(to)) {
        callees[i].push_back(*callee);
      } else {
        knows_all = false;
      }
    }
    if (!knows_all) writes_[i].assign(convention_.registers, true);
    writes_[i][convention_.link] = true;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (uint32_t i = 0; i < functions.size(); ++i) {
      for (const uint32_t callee : callees[i]) {
        for (unsigned reg = 0; reg < convention_.registers; ++reg) {
          if (!writes_[callee][reg] || writes_[i][reg]) continue;
          writes_[i][reg] = changed = true;
        }
      }
    }
  }
}

std::unique_ptr<llvm::Module> Program::Lift() {
  module_ = std::make_unique<llvm::Module>("machine code", context_);
  module_->setDataLayout(convention_.bits == 64 ? "e-m:e-p:64:64-i64:64-n64-S128" : "e-m:e-p:32:32-i64:64-n32-S64");
  Decode();
  FindWrites();
  const std::vector<Function>& functions = objects_.functions();
  for (uint32_t i = 0; i < functions.size(); ++i) {
    lifted_.push_back(llvm::Function::Create(LiftedType(), llvm::GlobalValue::InternalLinkage,
                                             "code of " + functions[i].symbol, *module_));
  }
  for (uint32_t i = 0; i < functions.size(); ++i) {
    FunctionLifter(*this, i, *lifted_[i]).Run();
    PromoteRegisters(*lifted_[i]);
    if (const Signature* signature = SignatureOf(functions[i].symbol)) AddWrapper(i, *signature);
  }
  return std::move(module_);
}

}  // namespace plcxx::prove::verify::machine_code
