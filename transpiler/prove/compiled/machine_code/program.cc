// All functions of a program: what is lifted, and around what.
#include <llvm/Demangle/Demangle.h>
#include <llvm/MC/MCInstrDesc.h>

#include <utility>

#include "transpiler/prove/compiled/machine_code/lifter.h"

namespace plcxx::prove::compiled::machine_code {

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
  const std::string text = llvm::demangle(symbol);
  const auto found = signatures_.find(text.substr(0, text.find('(')));
  return found == signatures_.end() ? nullptr : found->second;
}

llvm::GlobalVariable& Program::ConstantsOf(uint32_t number) {
  llvm::GlobalVariable*& constants = constants_[number];
  if (constants != nullptr) return *constants;
  const Section& section = objects_.sections()[number];
  std::vector<llvm::Constant*> bytes;
  llvm::Type* byte = llvm::Type::getInt8Ty(context_);
  for (const char one : section.bytes) bytes.push_back(llvm::ConstantInt::get(byte, static_cast<uint8_t>(one)));
  // What the linker will write is no number that is known.
  for (const auto& [offset, link] : section.links) {
    for (uint64_t at = offset; at < offset + convention_.bits / 8 && at < bytes.size(); ++at)
      bytes[at] = llvm::UndefValue::get(byte);
  }
  std::vector<llvm::Type*> types(bytes.size(), byte);
  auto* type = llvm::StructType::get(context_, types, /*isPacked=*/true);
  constants = new llvm::GlobalVariable(*module_, type, /*isConstant=*/true, llvm::GlobalValue::PrivateLinkage,
                                       llvm::ConstantStruct::get(type, bytes), section.name);
  constants->setAlignment(llvm::Align(section.align == 0 ? 1 : section.align));
  return *constants;
}

/// Directly, and by what each calls.
void Program::FindWrites() {
  const std::vector<Function>& functions = objects_.functions();
  writes_.assign(functions.size(), std::vector<bool>(convention_.registers));
  std::vector<std::vector<uint32_t>> callees(functions.size());
  for (uint32_t i = 0; i < functions.size(); ++i) {
    const Section& section = objects_.sections()[functions[i].place.section];
    const uint64_t begin = functions[i].place.offset, end = begin + functions[i].bytes;
    const llvm::ArrayRef<uint8_t> bytes(reinterpret_cast<const uint8_t*>(section.bytes.data()), section.bytes.size());
    bool all = false, data = false;
    for (uint64_t at = begin; at < end && end <= bytes.size();) {
      const auto mark = section.data_begins.find(at);
      if (mark != section.data_begins.end()) data = mark->second;
      compile::audit::Instruction instruction;
      if (data || !machine_.Decode(bytes.slice(at, end - at), at, instruction)) {
        ++at;
        continue;
      }
      at += instruction.bytes;
      // Any register that an instruction names may be one that it writes: the lists of loads are not told from others.
      for (const llvm::MCOperand& operand : instruction.inst) {
        if (operand.isReg() && operand.getReg() != 0) {
          const unsigned number = machine_.registers().getEncodingValue(operand.getReg());
          if (number < convention_.registers) writes_[i][number] = true;
        }
      }
      all = all || instruction.flow == compile::audit::Flow::kIndirectCall ||
            instruction.flow == compile::audit::Flow::kIndirectJump;
    }
    const auto first = section.links.lower_bound(begin), last = section.links.lower_bound(end);
    bool knows_callees = true;
    for (auto link = first; link != last; ++link) {
      const Link& to = link->second;
      if (to.symbol.empty() || (to.defined && to.defined->section == functions[i].place.section)) continue;
      if (to.defined && !objects_.sections()[to.defined->section].is_code) continue;
      if (const auto callee = objects_.FunctionOf(to)) {
        callees[i].push_back(*callee);
      } else {
        knows_callees = false;
      }
    }
    const bool far_calls = machine_.is_riscv();  // auipc and jalr, the linker's note tells of them
    if (!knows_callees || (all && !far_calls)) writes_[i].assign(convention_.registers, true);
    for (const unsigned reg : convention_.results) writes_[i][reg] = true;
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

}  // namespace plcxx::prove::compiled::machine_code
