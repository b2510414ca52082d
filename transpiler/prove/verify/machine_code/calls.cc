// Calls: of what C++ declares by the target's convention, of all else register by register.
#include <llvm/Demangle/Demangle.h>

#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/prove/verify/machine_code/lifter.h"

namespace plcxx::prove::verify::machine_code {
namespace {

constexpr uint64_t kStackBytes = 8192;  // of one function that is executed, and of what it calls

/// Where an argument is: registers, low part first, or bytes above the stack pointer.
struct Location {
  std::vector<unsigned> registers;
  std::optional<uint64_t> stack;
};

class Arguments {
 public:
  explicit Arguments(const Convention& convention) : convention_(convention) {}

  Location Next(unsigned width) {
    const unsigned word = convention_.bits;
    const unsigned count = width > word ? 2 : 1;
    if (count == 2 && convention_.pairs_are_even) next_ += next_ % 2;
    Location location;
    for (unsigned i = 0; i < count && next_ < convention_.arguments.size(); ++i) {
      // AAPCS does not split a number; RISC-V does.
      if (convention_.pairs_are_even && next_ + count - i > convention_.arguments.size()) break;
      location.registers.push_back(convention_.arguments[next_++]);
    }
    const auto left = static_cast<unsigned>(count - location.registers.size());
    if (left == 0) return location;
    next_ = convention_.arguments.size();
    if (left == 2) stack_ = (stack_ + 2 * word / 8 - 1) / (2 * word / 8) * (2 * word / 8);
    location.stack = stack_;
    stack_ += left * word / 8;
    return location;
  }
  uint64_t stack_bytes() const { return stack_; }
  uint64_t aligned_stack_bytes() const {
    return (stack_ + convention_.stack_align - 1) / convention_.stack_align * convention_.stack_align;
  }

 private:
  const Convention& convention_;
  size_t next_ = 0;
  uint64_t stack_ = 0;
};

llvm::Type* TypeOf(llvm::LLVMContext& context, unsigned width) {
  return width == 0 ? static_cast<llvm::Type*>(llvm::PointerType::get(context, 0))
                    : static_cast<llvm::Type*>(llvm::IntegerType::get(context, width));
}

}  // namespace

llvm::Function& Program::Declared(const std::string& symbol, const Signature& signature) {
  std::vector<llvm::Type*> parameters;
  for (const SignatureParameter& parameter : signature.parameters)
    parameters.push_back(TypeOf(context_, parameter.width));
  llvm::Type* result =
      signature.result_width == 0 ? llvm::Type::getVoidTy(context_) : TypeOf(context_, signature.result_width);
  auto* type = llvm::FunctionType::get(result, parameters, false);
  auto* function = llvm::cast<llvm::Function>(module_->getOrInsertFunction(symbol, type).getCallee());
  for (unsigned i = 0; i < signature.parameters.size(); ++i) {
    function->getArg(i)->setName(signature.parameters[i].name);
    if (signature.parameters[i].width == 0 && signature.parameters[i].name == "m")
      function->addParamAttr(i, llvm::Attribute::getWithAlignment(context_, llvm::Align(convention_.bits / 8)));
  }
  return *function;
}

/// The function as C++ calls it, around the one of machine code.
void Program::AddWrapper(uint32_t number, const Signature& signature) {
  const Function& function = objects_.functions()[number];
  llvm::Function& wrapper = Declared(function.symbol, signature);
  const auto refuse = [&](Builder&& build) {
    CallRefusal(build, "several functions " + llvm::demangle(function.symbol));
  };
  if (!wrapper.isDeclaration()) {
    // Another file has it, too: an inline function, or one of its own.
    const auto first = wrapped_.find(wrapper.getName().str());
    if (objects_.AreAlike(objects_.functions()[first->second], function)) return;
    refuse(Builder(&wrapper.getEntryBlock(), wrapper.getEntryBlock().begin()));
    return;
  }
  wrapped_.emplace(wrapper.getName().str(), number);
  Builder build(llvm::BasicBlock::Create(context_, "entry", &wrapper));
  // Others are given what the linker takes for the name.
  const Linked linked = objects_.LinkedAs(function.symbol, function.place);
  const auto taken = linked.place ? objects_.FunctionAt(*linked.place) : std::nullopt;
  const bool is_taken = taken && objects_.AreAlike(objects_.functions()[*taken], function);
  if (linked.resolution != Resolution::kOutside && !is_taken) refuse(Builder(&wrapper.getEntryBlock()));
  llvm::IntegerType* word = build.getIntNTy(convention_.bits);
  const auto number_of = [&](uint64_t value) { return llvm::ConstantInt::get(word, value); };
  auto* bytes = llvm::ArrayType::get(build.getInt8Ty(), kStackBytes);
  llvm::AllocaInst* stack = build.CreateAlloca(bytes);
  stack->setAlignment(llvm::Align(16));
  llvm::AllocaInst* unknown = build.CreateAlloca(llvm::ArrayType::get(word, convention_.registers));
  std::vector<llvm::Value*> registers;
  for (unsigned i = 0; i < convention_.registers; ++i) registers.push_back(build.CreateLoad(word, unknown));

  Arguments arguments(convention_);
  std::vector<Location> locations;
  for (const SignatureParameter& parameter : signature.parameters)
    locations.push_back(arguments.Next(parameter.width == 0 ? convention_.bits : parameter.width));
  llvm::Value* top =
      build.CreateAdd(build.CreatePtrToInt(stack, word), number_of(kStackBytes - arguments.aligned_stack_bytes()));
  registers[convention_.stack] = top;
  for (unsigned i = 0; i < locations.size(); ++i) {
    llvm::Value* value = wrapper.getArg(i);
    if (value->getType()->isPointerTy()) value = build.CreatePtrToInt(value, word);
    const Location& location = locations[i];
    const std::vector<llvm::Value*> words = Split(build, value);
    size_t next = 0;
    for (const unsigned reg : location.registers) registers[reg] = words[next++];
    for (uint64_t at = location.stack.value_or(0); next < words.size(); at += convention_.bits / 8) {
      llvm::Value* address = build.CreateIntToPtr(build.CreateAdd(top, number_of(at)), build.getPtrTy());
      build.CreateAlignedStore(words[next++], address, llvm::Align(1));
    }
  }
  llvm::Value* after = build.CreateCall(&Lifted(number), registers);
  const auto is_as_before = [&](unsigned reg) {
    build.CreateAssumption(build.CreateICmpEQ(build.CreateExtractValue(after, reg), registers[reg]));
  };
  for (const unsigned reg : convention_.kept) is_as_before(reg);
  if (signature.result_width == 0) {
    build.CreateRetVoid();
    return;
  }
  llvm::Value* low = build.CreateExtractValue(after, convention_.results[0]);
  const unsigned width = signature.result_width;
  const std::array words = {low, build.CreateExtractValue(after, convention_.results[1])};
  llvm::Value* result = Join(build, words, width);
  // Callers take what is above for zero.
  if (width < convention_.bits) build.CreateAssumption(build.CreateICmpEQ(build.CreateZExt(result, word), low));
  build.CreateRet(result);
}

void FunctionLifter::CallSignature(const Signature& signature, const std::string& symbol,
                                   std::optional<uint32_t> defined) {
  const Convention& convention = program_.convention();
  DemandStack(Get(convention.stack), convention.stack_align);
  llvm::Function& callee = program_.Declared(symbol, signature);
  Arguments places(convention);
  std::vector<llvm::Value*> arguments;
  for (const SignatureParameter& parameter : signature.parameters) {
    const unsigned width = parameter.width == 0 ? convention.bits : parameter.width;
    const Location location = places.Next(width);
    std::vector<llvm::Value*> words;
    for (const unsigned reg : location.registers) words.push_back(Get(reg));
    const size_t count = width > convention.bits ? 2 : 1;
    for (uint64_t at = location.stack.value_or(0); words.size() < count; at += convention.bits / 8)
      words.push_back(Load(builder_.CreateAdd(Get(convention.stack), Number(at)), convention.bits, 1));
    llvm::Value* value = program_.Join(builder_, words, width);
    if (width < convention.bits) Demand(builder_.CreateICmpEQ(builder_.CreateZExt(value, Word()), words.front()));
    if (parameter.width == 0) {
      DemandNotBelowStack(value);
      value = builder_.CreateIntToPtr(value, builder_.getPtrTy());
    }
    arguments.push_back(value);
  }
  llvm::Value* result = builder_.CreateCall(&callee, arguments);
  ForgetAfterCall(defined);
  // What it gets on the stack is its own.
  ForgetBelowStack(places.stack_bytes());
  if (signature.result_width == 0) return;
  const std::vector<llvm::Value*> words = program_.Split(builder_, result);
  for (size_t i = 0; i < words.size(); ++i) Set(convention.results[i], words[i]);
}

void FunctionLifter::ForgetAfterCall(std::optional<uint32_t> callee) {
  const Convention& convention = program_.convention();
  for (unsigned reg = 0; reg < convention.registers; ++reg) {
    const bool kept = std::find(convention.kept.begin(), convention.kept.end(), reg) != convention.kept.end();
    // Compilers know which registers a function of the same file leaves alone.
    if (!kept && (!callee || program_.MayWrite(*callee, reg))) Set(reg, Unknown());
  }
  ForgetFlags();
  ForgetBelowStack();
}

void FunctionLifter::ForgetFlags() {
  for (unsigned flag = 0; flag < flags_.size(); ++flag)
    SetFlag(flag, builder_.CreateTrunc(Unknown(), builder_.getInt1Ty()));
}

void FunctionLifter::CallLifted(llvm::Function& callee) {
  std::vector<llvm::Value*> registers;
  for (unsigned i = 0; i < registers_.size(); ++i) registers.push_back(Get(i));
  llvm::Value* after = builder_.CreateCall(&callee, registers);
  for (unsigned i = 0; i < registers_.size(); ++i) Set(i, builder_.CreateExtractValue(after, i));
  ForgetFlags();
}

void FunctionLifter::Call(const Link& link) {
  const Convention& convention = program_.convention();
  // Where it is loaded nobody knows; that it comes back there is all that matters.
  Set(convention.link, Unknown());
  for (const unsigned reg : convention.linkers) Set(reg, Unknown());
  const std::optional<uint32_t> callee = program_.objects().FunctionOf(link);
  const std::string& symbol = callee ? program_.objects().functions()[*callee].symbol : link.symbol;
  const Signature* signature = program_.SignatureOf(symbol);
  if (!callee && link.resolution != Resolution::kOutside) {
    // In these files there is something of that name that is no function, or several.
    Refuse("a call of " + llvm::demangle(symbol));
  } else if (signature != nullptr) {
    CallSignature(*signature, symbol, callee);
  } else if (callee) {
    CallLifted(program_.Lifted(*callee));
  } else if (!CallLibrary(symbol)) {
    Refuse("a call of " + llvm::demangle(symbol));
  }
}

void FunctionLifter::TailCall(const Link& link) {
  const unsigned back = program_.convention().link;
  llvm::Value* ours = Get(back);
  Call(link);
  ReturnTo(ours);
}

}  // namespace plcxx::prove::verify::machine_code
