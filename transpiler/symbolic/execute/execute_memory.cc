// Executor: what it reads and writes.
#include <algorithm>

#include "transpiler/symbolic/execute/executor.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/indexed_write.h"
#include "transpiler/symbolic/terms/known_bits.h"
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

/// What is known of an index without a question: a register that has only a few bits, a table's row of eight bytes.
class KnownIndex {
 public:
  explicit KnownIndex(const terms::Terms& terms) : terms_(terms) {}

  terms::KnownBits Of(terms::TermId id) {
    const terms::Term& term = terms_[id];
    if (terms_.IsConst(id)) return terms::AllKnown(terms_.Value(id), term.width);
    // What a single bit depends on may be all of the program.
    if (term.width == 1) return {};
    const auto before = std::ranges::find(known_, id, &Known::id);
    if (before != known_.end()) return before->bits;
    if (++visited_ > kMostTerms) return {};
    const terms::KnownBits bits = terms::KnownBitsOf(
        terms_, term, [this](terms::TermId operand) { return Of(operand); },
        [](uint32_t) { return terms::KnownBits(); });
    known_.push_back({id, bits});
    return bits;
  }

 private:
  static constexpr uint32_t kMostTerms = 100;
  struct Known {
    terms::TermId id;
    terms::KnownBits bits;
  };

  const terms::Terms& terms_;
  std::vector<Known> known_;
  uint32_t visited_ = 0;
};

/// Calls `visit(index, element)` for every index whose element lies wholly inside the bounds of an indexed place, and
/// which the term may be.
template <class Visit>
void ForEachElement(const terms::Terms& terms, const ir::Program& program, const ir::Place& place, terms::TermId at,
                    Visit&& visit) {
  constexpr uint8_t kIndexBits = 32;
  const int64_t high = std::min<int64_t>(place.high, program.spaces[place.space].bytes);
  const int64_t stride = place.stride, bytes = ir::Bytes(place.type);
  if (stride == 0) return;
  int64_t index = LeastIndex(place);
  ir::Place element = place;
  element.indexed = false;
  const auto visit_at = [&](int64_t i) {
    element.offset = static_cast<uint32_t>(place.offset + i * stride);
    visit(i, element);
  };
  if (terms.IsConst(at)) {
    const int64_t known = terms::AsSigned(terms.Value(at), kIndexBits);
    if (known >= index && int64_t{place.offset} + known * stride + bytes <= high) visit_at(known);
    return;
  }
  const terms::KnownBits known = KnownIndex(terms).Of(at);
  for (; int64_t{place.offset} + index * stride + bytes <= high; ++index) {
    const uint64_t value = terms::Masked(static_cast<uint64_t>(index), kIndexBits);
    if ((value & known.zeros) == 0 && (~value & known.ones) == 0) visit_at(index);
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
  ForEachElement(terms_, program_, place, index, [&](int64_t i, const ir::Place& element) {
    elements.push_back({terms::Masked(static_cast<uint64_t>(i), 32), memory_.ReadPlace(element)});
  });
  // Negative indices come last as numbers without sign.
  std::ranges::sort(elements, {}, &terms::TableElement::index);
  return terms::LookUp(terms_, flow_.active, index, elements, none);
}

void Executor::WriteAt(const ir::Place& place, terms::TermId index, terms::TermId value) {
  if (!IsPresent(program_, place)) return;
  terms::IndexedWrite write(terms_, flow_.active, index, value);
  ForEachElement(terms_, program_, place, index, [&](int64_t i, const ir::Place& element) {
    const auto [when, written] = write.At(terms::Masked(static_cast<uint64_t>(i), 32));
    if (!terms_.IsFalse(when)) WritePlace(element, terms_.Ite(when, written, memory_.ReadPlace(element)));
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
