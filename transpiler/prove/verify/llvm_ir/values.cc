// Executor: constants, globals, and what types are read.
#include <llvm/IR/Constants.h>
#include <llvm/IR/GlobalVariable.h>
#include <llvm/IR/Operator.h>

#include <algorithm>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/executor.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint32_t kNullObject = 0;
constexpr unsigned kWidest = 64;

void AppendBytes(const llvm::Constant& constant, const llvm::DataLayout& layout, uint64_t at,
                 std::vector<int16_t>& bytes) {
  const auto set = [&](const llvm::APInt& bits, uint64_t size) {
    for (uint64_t i = 0; i < size && at + i < bytes.size(); ++i) {
      const bool there = 8 * i < bits.getBitWidth();
      const unsigned width = there ? std::min<unsigned>(8, bits.getBitWidth() - static_cast<unsigned>(8 * i)) : 0;
      bytes[at + i] =
          there ? static_cast<int16_t>(bits.extractBitsAsZExtValue(width, static_cast<unsigned>(8 * i))) : int16_t{0};
    }
  };
  const uint64_t size = layout.getTypeStoreSize(constant.getType());
  if (const auto* integer = llvm::dyn_cast<llvm::ConstantInt>(&constant)) {
    set(integer->getValue(), size);
  } else if (const auto* number = llvm::dyn_cast<llvm::ConstantFP>(&constant)) {
    set(number->getValueAPF().bitcastToAPInt(), size);
  } else if (llvm::isa<llvm::ConstantAggregateZero>(constant)) {
    for (uint64_t i = 0; i < size && at + i < bytes.size(); ++i) bytes[at + i] = 0;
  } else if (const auto* structure = llvm::dyn_cast<llvm::ConstantStruct>(&constant)) {
    const llvm::StructLayout* offsets = layout.getStructLayout(structure->getType());
    for (unsigned i = 0; i < structure->getNumOperands(); ++i)
      AppendBytes(*structure->getOperand(i), layout, at + offsets->getElementOffset(i), bytes);
  } else if (const auto* array = llvm::dyn_cast<llvm::ArrayType>(constant.getType())) {
    const uint64_t stride = layout.getTypeAllocSize(array->getElementType());
    for (unsigned i = 0; i < array->getNumElements(); ++i) {
      const llvm::Constant* element = constant.getAggregateElement(i);
      if (element != nullptr) AppendBytes(*element, layout, at + i * stride, bytes);
    }
  }
}

}  // namespace

std::vector<int16_t> BytesOf(const llvm::Constant& constant, const llvm::DataLayout& layout) {
  std::vector<int16_t> bytes(layout.getTypeAllocSize(constant.getType()), -1);
  AppendBytes(constant, layout, 0, bytes);
  return bytes;
}

Executor::Executor(const llvm::Module& module, FlowCache& flows, terms::Terms& terms, CodeEnvironment& environment,
                   const CodeRun& run)
    : module_(module),
      layout_(module.getDataLayout()),
      flows_(flows),
      terms_(terms),
      environment_(environment),
      run_(run),
      ranges_(terms),
      first_term_(terms.size()),
      objects_{{.kind = ObjectKind::kNull},
               {.kind = ObjectKind::kState, .bytes = run.state_bytes},
               {.kind = ObjectKind::kHost}},
      initial_(run.state_bytes + run.further_slots),
      next_slot_(run.state_bytes + run.further_slots) {
  outcome_.left_out = terms.Bit(false);
}

bool Executor::IsSupported(const llvm::Type& type) const {
  if (type.isIntegerTy()) return type.getIntegerBitWidth() <= kWidest;
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(&type)) {
    for (const llvm::Type* element : structure->elements()) {
      if (!IsSupported(*element)) return false;
    }
    return true;
  }
  return type.isFloatTy() || type.isDoubleTy() || (type.isPointerTy() && type.getPointerAddressSpace() == 0);
}

uint8_t Executor::WidthOf(const llvm::Type& type) const {
  return static_cast<uint8_t>(type.isIntegerTy() ? type.getIntegerBitWidth() : type.isFloatTy() ? 32U : 64U);
}

terms::TermId Executor::Undefined(uint8_t width) {
  return terms_.Variable("undefined " + std::to_string(terms_.variable_count()), width);
}

CodeValue Executor::AnyOf(const llvm::Type& type) {
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(&type)) {
    CodeValue value;
    for (const llvm::Type* element : structure->elements()) value.parts.push_back(AnyOf(*element));
    return value;
  }
  // A pointer that points to nothing: whoever follows it is refused.
  if (type.isPointerTy()) return PointerTo(kNullObject);
  return {.term = Undefined(WidthOf(type))};
}

CodeValue Executor::PointerTo(uint32_t object, uint64_t offset) {
  return {.targets = {{.when = terms_.Bit(true), .object = object, .offset = terms_.Const(offset, 64)}}};
}

/// Several names of the same slots are one object.
uint32_t Executor::PlacedObject(const CodeGlobal& global) {
  constexpr uint64_t kAnyAlignment = 8;  // it is asked of nobody
  const auto same = std::ranges::find_if(objects_, [&global](const Object& object) {
    return object.kind == ObjectKind::kGlobal && object.first_slot == global.slot && object.bytes == global.bytes;
  });
  const auto number = static_cast<uint32_t>(same - objects_.begin());
  if (same == objects_.end()) {
    objects_.push_back({.kind = ObjectKind::kGlobal,
                        .first_slot = global.slot,
                        .bytes = global.bytes,
                        .align = kAnyAlignment,
                        .values = {}});
  }
  if (global.kind == CodeGlobal::Kind::kBytes) return number;
  objects_.push_back(
      {.kind = ObjectKind::kTable, .elements = number, .bytes = global.bytes, .align = kAnyAlignment, .values = {}});
  return static_cast<uint32_t>(objects_.size() - 1);
}

uint32_t Executor::ObjectOf(const llvm::GlobalVariable& global) {
  const auto found = globals_.find(&global);
  if (found != globals_.end()) return found->second;
  const auto placed = std::ranges::find(run_.globals, global.getName(), &CodeGlobal::name);
  if (placed != run_.globals.end()) {
    const uint32_t object = PlacedObject(*placed);
    globals_.emplace(&global, object);
    return object;
  }
  if (!global.isConstant() || !global.hasDefinitiveInitializer()) {
    Refuse("a global variable that is not constant: " + global.getName().str());
    return kNullObject;
  }
  Object object{.kind = ObjectKind::kConstant, .values = BytesOf(*global.getInitializer(), layout_)};
  object.align = global.getPointerAlignment(layout_).value();
  object.bytes = object.values.size();
  objects_.push_back(std::move(object));
  const auto number = static_cast<uint32_t>(objects_.size() - 1);
  globals_.emplace(&global, number);
  return number;
}

CodeValue Executor::ConstantOf(const llvm::Constant& constant) {
  const llvm::Type& type = *constant.getType();
  if (const auto* integer = llvm::dyn_cast<llvm::ConstantInt>(&constant))
    return {.term = terms_.Const(integer->getValue().getZExtValue(), WidthOf(type))};
  if (const auto* number = llvm::dyn_cast<llvm::ConstantFP>(&constant))
    return {.term = terms_.Const(number->getValueAPF().bitcastToAPInt().getZExtValue(), WidthOf(type))};
  if (llvm::isa<llvm::UndefValue>(constant)) {
    CodeValue value = AnyOf(type);
    if (llvm::isa<llvm::PoisonValue>(constant)) value.poison = terms_.Bit(true);
    return value;
  }
  if (llvm::isa<llvm::ConstantPointerNull>(constant)) return PointerTo(kNullObject);
  if (type.isPointerTy()) {
    llvm::APInt offset(layout_.getIndexTypeSizeInBits(constant.getType()), 0);
    const llvm::Value* base = constant.stripAndAccumulateConstantOffsets(layout_, offset, /*AllowNonInbounds=*/true);
    if (const auto* global = llvm::dyn_cast<llvm::GlobalVariable>(base))
      return PointerTo(ObjectOf(*global), static_cast<uint64_t>(offset.getSExtValue()));
  }
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(&type)) {
    CodeValue value;
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      const llvm::Constant* element = constant.getAggregateElement(i);
      value.parts.push_back(element != nullptr ? ConstantOf(*element) : AnyOf(*structure->getElementType(i)));
    }
    return value;
  }
  Refuse("a constant that is not a number: " + constant.getName().str());
  return AnyOf(type);
}

CodeValue Executor::ValueOf(const llvm::Value* value) {
  if (const auto* constant = llvm::dyn_cast<llvm::Constant>(value)) return ConstantOf(*constant);
  const auto found = values_.find(value);
  if (found != values_.end()) return found->second;
  // Computed on a way that was not taken; nothing depends on it here.
  return AnyOf(*value->getType());
}

}  // namespace plcxx::prove::verify::llvm_ir
