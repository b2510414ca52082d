#include "transpiler/prove/verify/llvm_ir/code_values.h"

#include <llvm/IR/Operator.h>

#include <algorithm>
#include <utility>

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint32_t kNullObject = 0;

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

CodeValue CodeValues::AnyOf(const llvm::Type& type) {
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(&type)) {
    CodeValue value;
    for (const llvm::Type* element : structure->elements()) value.parts.push_back(AnyOf(*element));
    return value;
  }
  // A pointer that points to nothing: whoever follows it is refused.
  if (type.isPointerTy()) return PointerTo(kNullObject);
  return {.term = Undefined(WidthOf(type))};
}

CodeValue CodeValues::PointerTo(uint32_t object, uint64_t offset) {
  return {.targets = {{.when = terms_.Bit(true), .object = object, .offset = terms_.Const(offset, 64)}}};
}

/// Several names of the same slots are one object.
uint32_t CodeValues::PlacedObject(const CodeGlobal& global) {
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

uint32_t CodeValues::ObjectOf(const llvm::GlobalVariable& global) {
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

CodeValue CodeValues::ConstantOf(const llvm::Constant& constant) {
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

CodeValue CodeValues::ValueOf(const llvm::Value* value) {
  if (const auto* constant = llvm::dyn_cast<llvm::Constant>(value)) return ConstantOf(*constant);
  const auto found = now_.values.find(value);
  if (found != now_.values.end()) return found->second;
  // Computed on a way that was not taken; nothing depends on it here.
  return AnyOf(*value->getType());
}

CodeValue CodeValues::Choose(terms::TermId condition, const CodeValue& then, const CodeValue& otherwise) {
  if (terms_.IsTrue(condition)) return then;
  if (terms_.IsFalse(condition)) return otherwise;
  CodeValue chosen;
  if (then.term.valid()) chosen.term = terms_.Ite(condition, then.term, otherwise.term);
  if (then.poison.valid() || otherwise.poison.valid()) {
    const auto poison = [this](const CodeValue& value) {
      return value.poison.valid() ? value.poison : terms_.Bit(false);
    };
    chosen.poison = OrNone(terms_.Ite(condition, poison(then), poison(otherwise)));
  }
  for (size_t i = 0; i < then.parts.size(); ++i)
    chosen.parts.push_back(Choose(condition, then.parts[i], otherwise.parts[i]));
  for (const Target& target : then.targets) {
    chosen.targets.push_back({terms_.And(condition, target.when), target.object, target.offset});
  }
  const terms::TermId not_condition = terms_.Not(condition);
  for (const Target& target : otherwise.targets) {
    const terms::TermId when = terms_.And(not_condition, target.when);
    // Two places of one object are one target with a chosen offset.
    const auto same =
        std::ranges::find_if(chosen.targets, [&](const Target& other) { return other.object == target.object; });
    if (same == chosen.targets.end()) {
      chosen.targets.push_back({when, target.object, target.offset});
      continue;
    }
    same->offset = terms_.Ite(condition, same->offset, target.offset);
    same->when = terms_.Or(same->when, when);
  }
  return chosen;
}

}  // namespace plcxx::prove::verify::llvm_ir
