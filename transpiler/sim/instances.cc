#include "transpiler/sim/instances.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>
#include <type_traits>

#include "transpiler/support/check.h"

namespace plcxx::sim {
namespace {

/// Of each struct, and of the memory that a vector has.
constexpr size_t kAlignment = alignof(uint64_t);
static_assert(kAlignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

/// Where a field is in its struct.
struct FieldSlot {
  ir::StateKind kind;
  size_t offset;
  size_t element_bytes;
  size_t count;
};

// The table says what the struct has: the same order, the same widths.
constexpr FieldSlot kSlots[] = {
#define PLCXX_STATE(...)
#define PLCXX_FIELD(Kind, Field, FieldType) \
  {ir::StateKind::k##Kind, offsetof(plcxx::Kind, Field), sizeof(plcxx::Kind::Field), 1},
#define PLCXX_HIDDEN(Kind, Field, FieldType, Count) \
  {ir::StateKind::k##Kind, offsetof(plcxx::Kind, Field), sizeof(plcxx::Kind::Field) / (Count), (Count)},
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
};

constexpr bool InStructOrder() {
  for (size_t i = 1; i < std::size(kSlots); ++i) {
    if (kSlots[i].kind == kSlots[i - 1].kind && kSlots[i].offset <= kSlots[i - 1].offset) return false;
  }
  return true;
}
static_assert(InStructOrder(), "states.def lists the fields in the order of the struct");

#define PLCXX_STATE(Kind, ...) \
  static_assert(std::is_trivially_copyable_v<plcxx::Kind> && alignof(plcxx::Kind) <= kAlignment);
#define PLCXX_FIELD(Kind, Field, FieldType)                                        \
  static_assert(sizeof(plcxx::Kind::Field) == ir::Bytes(ir::Type::k##FieldType) && \
                std::is_same_v<decltype(plcxx::Kind::Field), bool> == (ir::Type::k##FieldType == ir::Type::kBit));
#define PLCXX_HIDDEN(Kind, Field, FieldType, Count) \
  static_assert(sizeof(plcxx::Kind::Field) == ir::Bytes(ir::Type::k##FieldType) * (Count));
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN

/// The rows of a kind begin here.
constexpr size_t FirstSlot(ir::StateKind kind) {
  size_t i = 0;
  while (kSlots[i].kind != kind) ++i;
  return i;
}
struct KindRow {
  size_t first_slot;
  size_t bytes;                         // of the struct
  void (*begin)(unsigned char* bytes);  // a struct begins to live there, all 0
};
/// By StateKind, which is the order of the table.
constexpr KindRow kKinds[] = {
#define PLCXX_STATE(Kind, ...) \
  {FirstSlot(ir::StateKind::k##Kind), sizeof(plcxx::Kind), [](unsigned char* bytes) { new (bytes) plcxx::Kind{}; }},
#define PLCXX_FIELD(...)
#define PLCXX_HIDDEN(...)
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
};
const KindRow& RowOf(ir::StateKind kind) { return kKinds[static_cast<size_t>(kind)]; }

const FieldSlot& SlotOf(ir::StateKind kind, uint8_t field) { return kSlots[RowOf(kind).first_slot + field]; }

/// Where byte `i` of an element stands, counted from the least significant one.
constexpr size_t ByteAt(size_t i, size_t bytes) {
  return std::endian::native == std::endian::little ? i : bytes - 1 - i;
}

uint64_t Element(std::span<const unsigned char> bytes) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes.size(); ++i) value |= uint64_t{bytes[ByteAt(i, bytes.size())]} << (8 * i);
  return value;
}

}  // namespace

Instances::Instances(const ir::Program& program) : forced_(program.states.size()) {
  size_t bytes = 0;
  for (const ir::StateInstance& state : program.states) {
    kinds_.push_back(state.kind);
    at_.push_back(static_cast<uint32_t>(bytes));
    bytes += (RowOf(state.kind).bytes + kAlignment - 1) / kAlignment * kAlignment;
  }
  bytes_.resize(bytes);
  for (uint32_t i = 0; i < size(); ++i) Zero(i);
}

void Instances::Zero(uint32_t instance) { RowOf(kinds_[instance]).begin(BytesAt(at_[instance])); }

uint32_t Instances::PlaceOf(uint32_t instance, uint8_t field) const {
  return at_[instance] + static_cast<uint32_t>(SlotOf(kinds_[instance], field).offset);
}

uint64_t Instances::Read(uint32_t instance, uint8_t field) const {
  const FieldSlot& slot = SlotOf(kinds_[instance], field);
  return Element({BytesAt(PlaceOf(instance, field)), slot.element_bytes * slot.count});
}

void Instances::Set(uint32_t instance, uint8_t field, uint64_t value) {
  // A bool that holds anything but 0 and 1 is undefined behaviour for whoever reads it.
  if (ir::Info(kinds_[instance]).fields[field].type == ir::Type::kBit) value &= 1;
  unsigned char* const bytes = BytesAt(PlaceOf(instance, field));
  const size_t count = SlotOf(kinds_[instance], field).element_bytes;
  for (size_t i = 0; i < count; ++i) bytes[ByteAt(i, count)] = static_cast<unsigned char>(value >> (8 * i));
}

void Instances::Write(uint32_t instance, uint8_t field, uint64_t value) {
  Set(instance, field, value);
  Reforce(instance);
}

void Instances::Force(uint32_t instance, uint8_t field, uint64_t value) {
  Release(instance, field);
  forced_[instance].push_back({field, value});
  Set(instance, field, value);
}

void Instances::Release(uint32_t instance, uint8_t field) {
  std::erase_if(forced_[instance], [field](const ForcedField& forced) { return forced.field == field; });
}

void Instances::WriteForced(uint32_t instance) {
  for (const ForcedField& forced : forced_[instance]) Set(instance, forced.field, forced.value);
}

void Instances::Clear() {
  for (uint32_t i = 0; i < size(); ++i) {
    Zero(i);
    Reforce(i);
  }
}

void Instances::AppendTo(std::vector<uint8_t>& bytes) const {
  for (uint32_t i = 0; i < size(); ++i) {
    const auto fields = static_cast<uint8_t>(ir::Info(kinds_[i]).fields.size());
    for (uint8_t field = 0; field < fields; ++field) {
      const FieldSlot& slot = SlotOf(kinds_[i], field);
      const std::span<const unsigned char> all(BytesAt(PlaceOf(i, field)), slot.element_bytes * slot.count);
      for (size_t k = 0; k < slot.count; ++k) {
        const uint64_t value = Element(all.subspan(k * slot.element_bytes, slot.element_bytes));
        for (size_t j = 0; j < slot.element_bytes; ++j) bytes.push_back(static_cast<uint8_t>(value >> (8 * j)));
      }
    }
  }
}

}  // namespace plcxx::sim
