// The module's function for objects: machine code to a program that can be executed.
#include <llvm/IR/LLVMContext.h>

#include <memory>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/module.h"
#include "transpiler/prove/verify/machine_code/lifter.h"
#include "transpiler/prove/verify/object_code.h"

namespace plcxx::prove::verify::machine_code {
namespace {

std::unique_ptr<CompiledCode> ReadObjects(const ObjectCodeRequest& request, std::string& reason) {
  Objects objects;
  if (!objects.Read(request.objects, reason)) return nullptr;
  if (const Section* section = objects.RunsByItself()) {
    reason = "the code has functions that run before or after the program's (" + section->name + ")";
    return nullptr;
  }
  const auto machine = compile::audit::MachineCode::Make(objects.first(), request.processor, reason);
  if (machine == nullptr) return nullptr;
  const bool known = machine->is_arm() || (machine->is_riscv() && !objects.first().is64Bit());
  if (!known || !objects.first().isLittleEndian()) {
    reason = "machine code of this processor is not read; there are RV32IMAC and ARMv7E-M";
    return nullptr;
  }
  auto context = std::make_unique<llvm::LLVMContext>();
  std::unique_ptr<llvm::Module> module = Program(*context, objects, *machine, request.signatures).Lift();
  return llvm_ir::MakeCode(std::move(context), std::move(module));
}

}  // namespace
}  // namespace plcxx::prove::verify::machine_code

extern "C" [[gnu::visibility("default")]] plcxx::prove::verify::CompiledCode* plcxx_read_objects(
    const plcxx::prove::verify::ObjectCodeRequest& request, std::string& reason) {
  return plcxx::prove::verify::machine_code::ReadObjects(request, reason).release();
}
