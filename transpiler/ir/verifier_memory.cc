// The memory map: every place lies inside its space or names a field of a state instance.

#include "transpiler/ir/verifier_state.h"

namespace plcxx::ir {
namespace {

void VerifySpace(Verifier& verifier, const Space& space) {
  for (const Zone& zone : space.zones) {
    if (zone.begin > zone.end || zone.end > uint64_t{8} * space.bytes)
      verifier.Report("space " + space.name + ": zone outside");
  }
  for (size_t i = 0; i < space.constants.size(); ++i) {
    const ByteRange& range = space.constants[i];
    if (range.begin > range.end || range.end > space.bytes) {
      verifier.Report("space " + space.name + ": constant outside");
    }
    if (i > 0 && space.constants[i - 1].end > range.begin) {
      verifier.Report("space " + space.name + ": constants do not ascend");
    }
  }
  for (size_t i = 0; i < space.initial.size(); ++i) {
    if (space.initial[i].offset >= space.bytes) verifier.Report("space " + space.name + ": initial value outside");
    if (i > 0 && space.initial[i - 1].offset >= space.initial[i].offset) {
      verifier.Report("space " + space.name + ": initial values do not ascend");
    }
  }
}

void VerifyField(Verifier& verifier, const Place& place) {
  if (place.state.index >= verifier.program.states.size()) {
    verifier.Report("place " + place.name + ": unknown state instance");
    return;
  }
  const auto fields = Info(verifier.program.states[place.state].kind).fields;
  if (place.field >= fields.size()) {
    verifier.Report("place " + place.name + ": unknown field");
    return;
  }
  const FieldInfo& field = fields[place.field];
  if (field.hidden) verifier.Report("place " + place.name + ": field " + std::string(field.name) + " is hidden");
  if (field.type != place.type)
    verifier.Report("place " + place.name + ": the field is " + std::string(Name(field.type)));
  if (place.indexed) verifier.Report("place " + place.name + ": a field cannot be indexed");
}

void VerifyMemoryPlace(Verifier& verifier, const Place& place) {
  if (place.space.index >= verifier.program.spaces.size()) {
    verifier.Report("place " + place.name + ": unknown space");
    return;
  }
  const Space& space = verifier.program.spaces[place.space];
  if (place.type == Type::kNone) verifier.Report("place " + place.name + ": no type");
  if (place.type == Type::kBit ? place.bit > 7 : place.bit != kNoBit) {
    verifier.Report("place " + place.name + (place.type == Type::kBit ? ": no bit 0..7" : ": a bit of a word"));
  }
  if (place.indexed) {
    if (place.low > place.high || place.high > space.bytes || place.stride == 0) {
      verifier.Report("place " + place.name + ": index bounds outside of space " + space.name);
    }
  } else if (place.offset >= space.bytes || space.bytes - place.offset < Bytes(place.type)) {
    verifier.Report("place " + place.name + ": outside of space " + space.name);
  }
}

}  // namespace

void Verifier::VerifyMemory() {
  for (const Space& space : program.spaces) VerifySpace(*this, space);
  for (const HostFunction& host : program.host_functions) {
    const bool is_known = host.access == HostAccess::kWritesState && host.only_space.index < program.spaces.size();
    if (host.only_space.valid() && !is_known) Report("host function " + host.name + ": writes no such space");
  }
  for (const Place& place : program.places) {
    if (place.is_field()) {
      VerifyField(*this, place);
    } else {
      VerifyMemoryPlace(*this, place);
    }
  }
  if (program.text_inbox.valid() && (program.text_inbox.index >= program.states.size() ||
                                     program.states[program.text_inbox].kind != StateKind::kTextInbox)) {
    Report("the text inbox is none");
  }
}

}  // namespace plcxx::ir
