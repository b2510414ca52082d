#include "transpiler/prove/verify/llvm_ir/addresses.h"

#include <algorithm>
#include <string>
#include <utility>

namespace plcxx::prove::verify::llvm_ir {

terms::TermId Addresses::AddressOf(uint32_t object, uint8_t width) {
  if (object == 0) return terms_.Const(0, width);
  terms::TermId& address = addresses_[object];
  if (!address.valid()) {
    address = terms_.Variable("address " + std::to_string(object), width);
    object_at_.emplace(address.index, object);
  }
  return address;
}

terms::TermId Addresses::NumberOf(const CodeValue& pointer, uint8_t width) {
  terms::TermId number;
  for (auto target = pointer.targets.rbegin(); target != pointer.targets.rend(); ++target) {
    const terms::TermId here = terms_.Add(AddressOf(target->object, width), terms_.Resize(target->offset, width));
    number = number.valid() ? terms_.Ite(target->when, here, number) : here;
  }
  return number.valid() ? number : Undefined(width);
}

/// Targets of the number, with offsets of its width; none: it is no address.
std::vector<Target> Addresses::TargetsOf(terms::TermId number) {
  const auto known = targets_.find(number.index);
  if (known != targets_.end()) return known->second;
  const terms::Term term = terms_[number];
  std::vector<Target> targets;
  if (term.kind == terms::TermKind::kVariable) {
    const auto object = object_at_.find(number.index);
    if (object != object_at_.end()) targets.push_back({terms_.Bit(true), object->second, terms_.Const(0, term.width)});
  } else if (term.kind == terms::TermKind::kAdd) {
    const terms::TermId a(term.a), b(term.b);
    targets = TargetsOf(a);
    const bool first = !targets.empty();
    if (!first) targets = TargetsOf(b);
    for (Target& target : targets) target.offset = terms_.Add(target.offset, first ? b : a);
  } else if (term.kind == terms::TermKind::kSub) {
    targets = TargetsOf(terms::TermId(term.a));
    for (Target& target : targets) target.offset = terms_.Sub(target.offset, terms::TermId(term.b));
  } else if (term.kind == terms::TermKind::kIte) {
    const CodeValue then{.targets = TargetsOf(terms::TermId(term.b))};
    const CodeValue otherwise{.targets = TargetsOf(terms::TermId(term.c))};
    if (!then.targets.empty() && !otherwise.targets.empty())
      targets = values_.Choose(terms::TermId(term.a), then, otherwise).targets;
  }
  targets_.emplace(number.index, targets);
  return targets;
}

CodeValue Addresses::PointerAt(terms::TermId number) {
  CodeValue pointer{.targets = TargetsOf(number)};
  if (pointer.targets.empty()) {
    Refuse("an address that is no object's with an offset");
    return values_.PointerTo(0);
  }
  // What wraps in the target's width is outside of the object in 64 bits.
  for (Target& target : pointer.targets) target.offset = terms_.Zext(target.offset, 64);
  return pointer;
}

void Addresses::ForgetBelow(terms::TermId number) {
  const std::vector<Target> targets = TargetsOf(number);
  if (targets.empty()) Refuse("a stack pointer that is no object's address with an offset");
  for (const Target& target : targets) {
    const Object& object = objects_[target.object];
    if (!IsOwnLocal(object)) continue;
    const uint64_t end = std::min(ranges_.Of(target.offset).high, object.bytes);
    for (uint64_t at = 0; at < end; ++at) {
      const auto slot = static_cast<uint32_t>(object.first_slot + at);
      if (slots_.At(slot).valid()) slots_.Set(slot, terms::TermId());
    }
  }
}

void Addresses::RequireWithin(terms::TermId number, terms::TermId other) {
  const std::vector<Target> allowed = TargetsOf(other);
  if (TargetsOf(number).empty()) return Refuse("a stack pointer that is no object's address with an offset");
  const CodeValue pointer = PointerAt(number);
  for (const Target& target : pointer.targets) {
    const auto is_same = [&](const Target& one) { return one.object == target.object; };
    const Object& object = objects_[target.object];
    const bool is_stack = IsOwnLocal(object) && std::ranges::all_of(allowed, is_same);
    const terms::TermId beyond =
        is_stack ? terms_.Ult(terms_.Const(object.bytes, 64), target.offset) : terms_.Bit(true);
    Require(terms_.And(target.when, beyond), "a stack pointer that leads out of the stack");
  }
}

void Addresses::RequireNotBelow(terms::TermId number, terms::TermId limit) {
  for (const Target& target : TargetsOf(number)) {
    for (const Target& end : TargetsOf(limit)) {
      if (end.object != target.object) continue;
      const terms::TermId both = terms_.And(target.when, end.when);
      Require(terms_.And(both, terms_.Ult(target.offset, end.offset)), "an access below the stack pointer");
    }
  }
}

}  // namespace plcxx::prove::verify::llvm_ir
