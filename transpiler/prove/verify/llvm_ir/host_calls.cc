#include "transpiler/prove/verify/llvm_ir/host_calls.h"

#include <llvm/TargetParser/Triple.h>

#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::prove::verify::llvm_ir {

/// The memory as the host gets it.
class HostCalls::Memory : public CodeMemory {
 public:
  explicit Memory(HostCalls& calls) : calls_(calls) {}
  terms::TermId Read(uint32_t slot) override { return calls_.memory_.ReadSlot(slot); }
  void Write(uint32_t slot, terms::TermId value) override { calls_.slots_.Set(slot, value); }
  terms::TermId When() const override { return calls_.context_; }
  void Require(terms::TermId never, const char* text) override { calls_.Require(never, text); }

 private:
  HostCalls& calls_;
};

HostArgument HostCalls::ArgumentOf(const CodeValue& value) {
  if (value.term.valid()) return {.kind = HostArgument::Kind::kValue, .value = value.term};
  const bool known = value.targets.size() == 1 && terms_.IsConst(value.targets.front().offset);
  if (!known) return {.kind = HostArgument::Kind::kUnknownPointer};
  const Object& object = objects_[value.targets.front().object];
  const uint64_t offset = terms_.Value(value.targets.front().offset);
  if (object.kind == ObjectKind::kHost && offset == 0) return {.kind = HostArgument::Kind::kHost};
  const bool is_memory = object.kind == ObjectKind::kState || object.kind == ObjectKind::kLocal;
  if (!is_memory || offset >= object.bytes) return {.kind = HostArgument::Kind::kUnknownPointer};
  return {.kind = HostArgument::Kind::kMemory,
          .slot = object.first_slot + static_cast<uint32_t>(offset),
          .bytes = object.bytes - offset};
}

/// Whether what stands above a narrow number is 0 at the call, where callers see to that.
bool HostCalls::IsWidened(const llvm::CallInst& call) {
  const auto is_narrow = [](const llvm::Type& type) { return type.isIntegerTy() && type.getIntegerBitWidth() < 32; };
  for (unsigned i = 0; i < call.arg_size(); ++i) {
    if (!is_narrow(*call.getArgOperand(i)->getType())) continue;
    if (call.paramHasAttr(i, llvm::Attribute::SExt) || !call.paramHasAttr(i, llvm::Attribute::ZExt)) return false;
  }
  return !is_narrow(*call.getType()) ||
         (call.hasRetAttr(llvm::Attribute::ZExt) && !call.hasRetAttr(llvm::Attribute::SExt));
}

CodeValue HostCalls::Call(const llvm::CallInst& call, const llvm::Function& callee, const std::string& name) {
  const llvm::Type& type = *call.getType();
  std::vector<HostArgument> arguments;
  for (const llvm::Use& operand : call.args()) {
    const CodeValue value = values_.ValueOf(operand);
    const unsigned number = call.getArgOperandNo(&operand);
    const std::string_view parameter = number < callee.arg_size() ? callee.getArg(number)->getName() : "";
    if (number < callee.arg_size()) poison_.RequireArgument(call, *callee.getArg(number), value);
    arguments.push_back(ArgumentOf(value));
    arguments.back().name = parameter;
    arguments.back().is_unused =
        !callee.isDeclaration() && number < callee.arg_size() && callee.getArg(number)->use_empty();
  }
  const uint8_t width = type.isVoidTy() ? uint8_t{0} : WidthOf(type);
  if (type.isPointerTy() || type.isStructTy()) Refuse("a call of " + name + ", which returns no number");
  const llvm::Triple target(call.getModule()->getTargetTriple());
  const bool callers_widen = target.getArch() != llvm::Triple::UnknownArch && !target.isAArch64();
  const bool is_declared = run_.language == CodeRun::Language::kCpp && !callee.hasLocalLinkage();
  if (is_declared && callers_widen && !IsWidened(call))
    Refuse("a call of " + name + " that widens a number otherwise than its declaration says");
  if (refused()) return values_.AnyResult(type);
  Memory memory(*this);
  std::string refusal;
  const terms::TermId result =
      environment_.CallHost(memory, {.function = name, .arguments = arguments, .result_width = width}, refusal);
  if (!refusal.empty()) Refuse(std::move(refusal));
  if (type.isVoidTy()) return {};
  CodeValue value{.term = result.valid() && terms_.Width(result) == width ? result : Undefined(width)};
  value.poison = poison_.OfRange(call, value.term);
  if (const auto range = call.getRange()) value.poison = Either(value.poison, poison_.IsOutOf(*range, value.term));
  return value;
}

}  // namespace plcxx::prove::verify::llvm_ir
