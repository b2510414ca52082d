#include "transpiler/prove/verify/llvm_ir/arguments.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint32_t kStateObject = 1, kHostObject = 2;

}  // namespace

bool Arguments::BindOne(const llvm::Argument& parameter, const CodeArgument& argument, CodeValue& value) {
  const llvm::Type& type = *parameter.getType();
  // C++ says so of a reference; callers are asked for it.
  const uint64_t align = parameter.getParamAlign().valueOrOne().value();
  switch (argument.kind) {
    case CodeArgument::Kind::kState:
      objects_[kStateObject].align = std::max(objects_[kStateObject].align, align);
      value = values_.PointerTo(kStateObject);
      break;
    case CodeArgument::Kind::kHost:
      value = values_.PointerTo(kHostObject);
      break;
    case CodeArgument::Kind::kMemory:
      objects_.push_back({.kind = ObjectKind::kLocal,
                          .first_slot = argument.slot,
                          .bytes = argument.bytes,
                          .align = align,
                          .values = {}});
      value = values_.PointerTo(static_cast<uint32_t>(objects_.size() - 1));
      break;
    case CodeArgument::Kind::kValue:
      value = {.term = argument.value};
      return !type.isPointerTy() && WidthOf(type) == terms_.Width(argument.value);
  }
  return type.isPointerTy();
}

/// "s.0.val" is what stood at s at the time of the call.
bool Arguments::BindByName(const llvm::Argument& parameter, CodeValue& value) {
  const std::string_view name = parameter.getName();
  for (const CodeArgument& argument : run_.arguments) {
    if (argument.name == name) return BindOne(parameter, argument, value);
    const std::optional<uint32_t> offset = PromotedOffset(name, argument.name);
    const bool state = argument.kind == CodeArgument::Kind::kState;
    if (!offset || (!state && argument.kind != CodeArgument::Kind::kMemory)) continue;
    const llvm::Type& type = *parameter.getType();
    if (type.isPointerTy() || type.isStructTy()) return false;
    const auto bytes = static_cast<uint32_t>(layout_.getTypeStoreSize(parameter.getType()));
    const uint32_t all = state ? run_.state_bytes : argument.bytes;
    if (bytes > all || *offset > all - bytes) return false;
    terms::TermId term;
    for (uint32_t i = bytes; i-- > 0;) {
      const terms::TermId byte = memory_.ReadSlot(argument.slot + *offset + i);
      term = term.valid() ? terms_.Concat(term, byte) : byte;
    }
    value = {.term = terms_.Resize(term, WidthOf(type))};
    return true;
  }
  return false;
}

bool Arguments::Bind(const llvm::Function& function, std::vector<CodeValue>& values) {
  const size_t count = function.arg_size();
  bool in_order = count == run_.arguments.size();
  for (unsigned i = 0; in_order && i < count; ++i) {
    const std::string_view name = function.getArg(i)->getName();
    in_order = name.empty() || run_.arguments[i].name.empty() || name == run_.arguments[i].name;
  }
  values.resize(count);
  for (unsigned i = 0; i < count; ++i) {
    const llvm::Argument& parameter = *function.getArg(i);
    if (!IsSupported(*parameter.getType())) return false;
    const bool bound = in_order ? BindOne(parameter, run_.arguments[i], values[i]) : BindByName(parameter, values[i]);
    if (!bound) return false;
  }
  return true;
}

}  // namespace plcxx::prove::verify::llvm_ir
