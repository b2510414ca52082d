// Executor: what it reads and writes.
#include <algorithm>

#include "transpiler/symbolic/execute/executor.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/look_up.h"

namespace plcxx::execute {
namespace {

/// In memory at all, as the simulator has it; other places read 0 and write nothing.
bool IsPresent(const ir::Program& program, const ir::Place& place) {
  if (place.is_field()) {
    if (place.state.index >= program.states.size()) return false;
    const auto fields = ir::Info(program.states[place.state].kind).fields;
    return place.field < fields.size() && fields[place.field].count == 1;
  }
  if (!place.space.valid() || place.space.index >= program.spaces.size()) return false;
  const uint32_t bytes = ir::Bytes(place.type);
  if (bytes == 0 || (place.type == ir::Type::kBit && place.bit > 7)) return false;
  return place.indexed || uint64_t{place.offset} + bytes <= program.spaces[place.space].bytes;
}

/// Calls `visit(index, element)` for every index whose element lies wholly inside the bounds of an indexed place.
template <class Visit>
void ForEachElement(const ir::Program& program, const ir::Place& place, Visit&& visit) {
  const int64_t high = std::min<int64_t>(place.high, program.spaces[place.space].bytes);
  const int64_t stride = place.stride, bytes = ir::Bytes(place.type);
  if (stride == 0) return;
  // The least index at or above the low bound; division rounds down here.
  const int64_t below = int64_t{place.low} - place.offset;
  int64_t index = below >= 0 ? (below + stride - 1) / stride : -(-below / stride);
  ir::Place element = place;
  element.indexed = false;
  for (; int64_t{place.offset} + index * stride + bytes <= high; ++index) {
    element.offset = static_cast<uint32_t>(place.offset + index * stride);
    visit(index, element);
  }
}

}  // namespace

void Executor::WriteCell(CellId cell, terms::TermId value) {
  if (terms_.IsTrue(flow_.active)) {
    memory_.Write(cell, value);
  } else if (!terms_.IsFalse(flow_.active)) {
    memory_.Write(cell, terms_.Ite(flow_.active, value, memory_.Read(cell)));
  }
}

void Executor::WritePlace(const ir::Place& place, terms::TermId value) {
  if (!IsPresent(program_, place)) return;
  if (terms_.IsTrue(flow_.active)) {
    memory_.WritePlace(place, value);
  } else if (!terms_.IsFalse(flow_.active)) {
    memory_.WritePlace(place, terms_.Ite(flow_.active, value, memory_.ReadPlace(place)));
  }
}

terms::TermId Executor::ReadPlace(const ir::Place& place) {
  return IsPresent(program_, place) ? memory_.ReadPlace(place) : terms_.Const(0, meaning::WidthOf(place.type));
}

terms::TermId Executor::ReadAt(const ir::Place& place, terms::TermId index) {
  const terms::TermId none = terms_.Const(0, meaning::WidthOf(place.type));
  if (!IsPresent(program_, place)) return none;
  std::vector<terms::TableElement> elements;
  ForEachElement(program_, place, [&](int64_t i, const ir::Place& element) {
    const uint64_t at = terms::Masked(static_cast<uint64_t>(i), 32);
    if (!terms_.IsFalse(terms_.Eq(index, terms_.Const(at, 32)))) elements.push_back({at, memory_.ReadPlace(element)});
  });
  // Negative indices come last as numbers without sign.
  std::ranges::sort(elements, {}, &terms::TableElement::index);
  return terms::LookUp(terms_, index, elements, none);
}

void Executor::WriteAt(const ir::Place& place, terms::TermId index, terms::TermId value) {
  if (!IsPresent(program_, place)) return;
  ForEachElement(program_, place, [&](int64_t i, const ir::Place& element) {
    const terms::TermId chosen = terms_.Eq(index, terms_.Const(static_cast<uint64_t>(i), 32));
    if (!terms_.IsFalse(chosen)) WritePlace(element, terms_.Ite(chosen, value, memory_.ReadPlace(element)));
  });
}

std::vector<terms::TermId> Executor::Fields(ir::StateId state) {
  std::vector<terms::TermId> fields;
  const uint32_t first = memory_.cells().states[state.index];
  for (uint32_t i = 0; i < meaning::FieldTerms(program_.states[state].kind); ++i)
    fields.push_back(memory_.Read(CellId(first + i)));
  return fields;
}

void Executor::StepInstance(ir::StateId state, std::span<const terms::TermId> fields) {
  const uint32_t first = memory_.cells().states[state.index];
  for (uint32_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != memory_.Read(CellId(first + i))) WriteCell(CellId(first + i), fields[i]);
  }
}

}  // namespace plcxx::execute
