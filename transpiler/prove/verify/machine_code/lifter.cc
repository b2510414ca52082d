#include "transpiler/prove/verify/machine_code/lifter.h"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/IR/Dominators.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include <algorithm>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/refusal.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::prove::verify::machine_code {

using compile::audit::Flow;
using compile::audit::Instruction;

FunctionLifter::FunctionLifter(Program& program, uint32_t function, llvm::Function& target)
    : program_(program),
      number_(function),
      target_(target),
      builder_(target.getContext()),
      code_(program.InstructionsOf(function)) {}

const Function& FunctionLifter::function() const { return program_.objects().functions()[number_]; }
const Section& FunctionLifter::section() const { return program_.objects().sections()[function().place.section]; }
llvm::IntegerType* FunctionLifter::Word() const {
  return llvm::IntegerType::get(target_.getContext(), program_.convention().bits);
}
llvm::Value* FunctionLifter::Number(uint64_t value) const {
  const unsigned bits = program_.convention().bits;
  return llvm::ConstantInt::get(Word(), value & support::LowBits(bits));
}

std::optional<uint64_t> FunctionLifter::TargetOf(const Link& link) const {
  if (!link.defined || link.defined->section != function().place.section) return std::nullopt;
  const uint64_t target = link.defined->offset + static_cast<uint64_t>(link.addend);
  const uint64_t begin = function().place.offset;
  return target >= begin && target < begin + function().bytes ? std::optional(target) : std::nullopt;
}

/// Wherever a branch may lead, and what comes after one.
void FunctionLifter::FindBlocks() {
  std::set<uint64_t> begins;
  for (const Instruction& instruction : code_) {
    current_ = &instruction;
    if (instruction.flow == Flow::kNext || instruction.flow == Flow::kCall || instruction.flow == Flow::kIndirectCall)
      continue;
    begins.insert(instruction.address + instruction.bytes);
    // With a note of the linker it leads elsewhere: what the instruction itself says is its own address.
    if (instruction.target && instruction.target != instruction.address) targets_.insert(*instruction.target);
    const auto [first, last] = section().links.equal_range(instruction.address);
    for (auto link = first; link != last; ++link) {
      if (const auto target = TargetOf(link->second)) targets_.insert(*target);
    }
  }
  begins.insert(targets_.begin(), targets_.end());
  for (const Instruction& instruction : code_) {
    if (begins.contains(instruction.address))
      blocks_.emplace(instruction.address, llvm::BasicBlock::Create(target_.getContext(), "at", &target_));
  }
}

llvm::BasicBlock* FunctionLifter::BlockAt(uint64_t address) {
  const auto found = blocks_.find(address);
  if (found != blocks_.end()) return found->second;
  // Into the middle of an instruction, or out of the function.
  llvm::BasicBlock* nowhere = llvm::BasicBlock::Create(target_.getContext(), "nowhere", &target_);
  const auto before = builder_.saveIP();
  builder_.SetInsertPoint(nowhere);
  Refuse("a jump out of the function");
  builder_.CreateUnreachable();
  builder_.restoreIP(before);
  return nowhere;
}

llvm::Value* FunctionLifter::Get(unsigned number) { return builder_.CreateLoad(Word(), registers_[number]); }
void FunctionLifter::Set(unsigned number, llvm::Value* value) {
  const Convention& convention = program_.convention();
  if (std::ranges::find(convention.platform, number) != convention.platform.end())
    Demand(builder_.CreateICmpEQ(value, target_.getArg(number)));
  builder_.CreateStore(value, registers_[number]);
  if (number != convention.stack) return;
  DemandStack(value, convention.least_stack_align);
  ForgetBelowStack();
}
llvm::Value* FunctionLifter::GetFlag(unsigned number) {
  return builder_.CreateLoad(builder_.getInt1Ty(), flags_[number]);
}
void FunctionLifter::SetFlag(unsigned number, llvm::Value* value) { builder_.CreateStore(value, flags_[number]); }

llvm::Value* FunctionLifter::Unknown() { return builder_.CreateLoad(Word(), unknown_); }

llvm::Value* FunctionLifter::Load(llvm::Value* address, unsigned bits, unsigned align) {
  DemandNotBelowStack(address);
  llvm::Value* pointer = builder_.CreateIntToPtr(address, builder_.getPtrTy());
  return builder_.CreateAlignedLoad(builder_.getIntNTy(bits), pointer, llvm::Align(align));
}

void FunctionLifter::Store(llvm::Value* address, llvm::Value* value, unsigned align) {
  DemandNotBelowStack(address);
  llvm::Value* pointer = builder_.CreateIntToPtr(address, builder_.getPtrTy());
  builder_.CreateAlignedStore(value, pointer, llvm::Align(align));
}

llvm::Value* FunctionLifter::Divide(llvm::Value* a, llvm::Value* b, llvm::Instruction::BinaryOps operation,
                                    llvm::Value* by_zero) {
  llvm::Value* is_zero = builder_.CreateICmpEQ(b, Number(0));
  llvm::Value* by = builder_.CreateSelect(is_zero, Number(1), b);
  if (operation == llvm::Instruction::SDiv || operation == llvm::Instruction::SRem) {
    llvm::Value* least = Number(uint64_t{1} << (program_.convention().bits - 1));
    llvm::Value* overflows =
        builder_.CreateAnd(builder_.CreateICmpEQ(a, least), builder_.CreateICmpEQ(b, Number(~uint64_t{0})));
    by = builder_.CreateSelect(overflows, Number(1), by);
  }
  return builder_.CreateSelect(is_zero, by_zero, builder_.CreateBinOp(operation, a, by));
}

void FunctionLifter::ForgetBelowStack(uint64_t above) {
  llvm::FunctionType* type = llvm::FunctionType::get(builder_.getVoidTy(), {Word()}, false);
  llvm::Value* end = Get(program_.convention().stack);
  if (above != 0) end = builder_.CreateAdd(end, Number(above));
  builder_.CreateCall(program_.module().getOrInsertFunction(llvm_ir::kForgetBelow, type), {end});
}

void FunctionLifter::DemandStack(llvm::Value* pointer, unsigned align) {
  llvm::FunctionType* type = llvm::FunctionType::get(builder_.getVoidTy(), {Word(), Word(), Word()}, false);
  builder_.CreateCall(program_.module().getOrInsertFunction(llvm_ir::kStackPointer, type),
                      {pointer, target_.getArg(program_.convention().stack), Number(align)});
}

void FunctionLifter::DemandNotBelowStack(llvm::Value* address) {
  llvm::FunctionType* type = llvm::FunctionType::get(builder_.getVoidTy(), {Word(), Word()}, false);
  builder_.CreateCall(program_.module().getOrInsertFunction(llvm_ir::kNotBelow, type),
                      {address, Get(program_.convention().stack)});
}

void FunctionLifter::Refuse(const std::string& what) { program_.CallRefusal(builder_, what); }

void FunctionLifter::BranchIf(llvm::Value* condition, uint64_t target) {
  llvm::BasicBlock* next = BlockAt(current_->address + current_->bytes);
  builder_.CreateCondBr(condition, BlockAt(target), next);
}

void FunctionLifter::JumpTo(uint64_t target) { builder_.CreateBr(BlockAt(target)); }

void FunctionLifter::ReturnTo(llvm::Value* address) {
  llvm::Value* given = target_.getArg(program_.convention().link);
  builder_.CreateAssumption(builder_.CreateICmpEQ(address, given));
  builder_.CreateBr(exit_);
}

void FunctionLifter::BeginGuard(llvm::Value* condition) {
  llvm::BasicBlock* then = llvm::BasicBlock::Create(target_.getContext(), "then", &target_);
  after_guard_ = llvm::BasicBlock::Create(target_.getContext(), "after", &target_);
  builder_.CreateCondBr(condition, then, after_guard_);
  builder_.SetInsertPoint(then);
}

void FunctionLifter::EndGuard() {
  if (after_guard_ == nullptr) return;
  if (builder_.GetInsertBlock()->getTerminator() == nullptr) builder_.CreateBr(after_guard_);
  builder_.SetInsertPoint(std::exchange(after_guard_, nullptr));
}

llvm::Value* FunctionLifter::AddressOf(const Link& link) {
  if (!link.defined) return nullptr;
  const Section& target = program_.objects().sections()[link.defined->section];
  if (!target.is_constant || target.is_code) return nullptr;
  const uint64_t offset = link.defined->offset + static_cast<uint64_t>(link.addend);
  // What the linker merges keeps no neighbours.
  const uint64_t place = link.is_of_section ? offset : link.defined->offset;
  const auto [first, bytes] = target.MergedAt(place);
  llvm::Value* address = builder_.CreatePtrToInt(&program_.ConstantsOf(link.defined->section, first, bytes), Word());
  return offset == first ? address : builder_.CreateAdd(address, Number(offset - first));
}

llvm::Value* FunctionLifter::PartOf(AddressPart part, const Place& place) {
  return builder_.CreatePtrToInt(&program_.PartOf(part, place), Word());
}

void FunctionLifter::Run() {
  const Convention& convention = program_.convention();
  llvm::BasicBlock* entry = llvm::BasicBlock::Create(target_.getContext(), "entry", &target_);
  builder_.SetInsertPoint(entry);
  if (code_.empty()) {
    Refuse("a function with bytes that are no instruction: " + function().symbol);
    builder_.CreateUnreachable();
    return;
  }
  if (!section().is_constant) Refuse("a function that can be written: " + function().symbol);
  unknown_ = builder_.CreateAlloca(Word());
  for (unsigned i = 0; i < convention.registers; ++i) {
    registers_.push_back(builder_.CreateAlloca(Word()));
    builder_.CreateStore(target_.getArg(i), registers_.back());
  }
  for (unsigned i = 0; i < convention.flags; ++i) {
    flags_.push_back(builder_.CreateAlloca(builder_.getInt1Ty()));
    builder_.CreateStore(builder_.CreateTrunc(Unknown(), builder_.getInt1Ty()), flags_.back());
  }
  exit_ = llvm::BasicBlock::Create(target_.getContext(), "exit", &target_);
  FindBlocks();
  llvm::StringRef open_note;
  uint64_t next = function().place.offset;
  for (const Instruction& instruction : code_) {
    current_ = &instruction;
    // Constants stand in between: the processor takes them for instructions.
    if (instruction.address != std::exchange(next, instruction.address + instruction.bytes) &&
        builder_.GetInsertBlock()->getTerminator() == nullptr) {
      Refuse("constants where instructions are executed");
      builder_.CreateUnreachable();
    }
    const auto block = blocks_.find(instruction.address);
    if (block != blocks_.end()) {
      if (builder_.GetInsertBlock()->getTerminator() == nullptr) builder_.CreateBr(block->second);
      builder_.SetInsertPoint(block->second);
    }
    // Nothing leads here: what follows a jump and is no target of one.
    if (builder_.GetInsertBlock()->getTerminator() != nullptr) continue;
    if (program_.machine().is_arm()) {
      LiftArm(*this);
    } else {
      LiftRiscv(*this);
    }
    // What the linker writes into an instruction in another way than its row says is not executed.
    if (open_note.empty() && HasOpenNote()) open_note = program_.machine().OpcodeName(instruction.inst);
  }
  if (builder_.GetInsertBlock()->getTerminator() == nullptr) {
    Refuse("a function that has no end: " + function().symbol);
    builder_.CreateUnreachable();
  }
  builder_.SetInsertPoint(exit_);
  llvm::Value* all = llvm::UndefValue::get(target_.getReturnType());
  for (unsigned i = 0; i < convention.registers; ++i) all = builder_.CreateInsertValue(all, Get(i), i);
  builder_.CreateRet(all);
  if (open_note.empty()) return;
  builder_.SetInsertPoint(entry, entry->begin());
  Refuse("a note of the linker for '" + open_note.str() + "'");
}

void PromoteRegisters(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> registers;
  for (llvm::Instruction& inst : function.getEntryBlock()) {
    auto* local = llvm::dyn_cast<llvm::AllocaInst>(&inst);
    // That of unknown numbers is never written, and stays memory.
    if (local == nullptr || !llvm::isAllocaPromotable(local)) continue;
    const auto is_store = [](const llvm::User* user) { return llvm::isa<llvm::StoreInst>(user); };
    if (std::any_of(local->user_begin(), local->user_end(), is_store)) registers.push_back(local);
  }
  llvm::DominatorTree dominators(function);
  llvm::PromoteMemToReg(registers, dominators);
}

}  // namespace plcxx::prove::verify::machine_code
