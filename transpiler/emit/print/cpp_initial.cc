// What a State holds at power-on: zeros, the values of the spaces' initial bytes, and the retentive block's layout.

#include <map>

#include "transpiler/emit/print/part_printer.h"
#include "transpiler/support/hex.h"

namespace plcxx::emit::print {
namespace {

constexpr size_t kLeastTable = 8;       // values that are a table
constexpr uint32_t kMostZeros = 4;      // between two values of one table
constexpr uint32_t kMostDistance = 16;  // of their addresses
constexpr uint32_t kBytesPerRow = 16;   // of a table; a row begins at a multiple, so that a new value changes one row
constexpr uint32_t kBitBytesPerRow = 1;

std::string HexByte(uint64_t value) {
  return "0x" + support::HexDigits(value & 0xFF, 2, support::HexLetters::kCapital);
}

}  // namespace

/// A value of an array member: bit[5] = true.
struct Initial {
  uint32_t index = 0;  // in the array
  ir::SpaceId space;
  uint32_t offset = 0;  // of the space
  uint64_t value = 0;
};

namespace {

/// Whether a table can go on with `next` after `last`, or with its first value.
bool Follows(const Initial& last, const Initial& next) {
  return next.space == last.space && next.index <= last.index + 1 + kMostZeros &&
         next.offset <= last.offset + kMostDistance;
}

}  // namespace

/// Values of one array, by index.
struct InitialArray {
  std::string member;  // "m.word16"
  ir::Type type;
  std::map<uint32_t, Initial> values;

  std::string Text(uint64_t value) const { return type == ir::Type::kI8 ? HexByte(value) : ConstantText(type, value); }
};

namespace {

/// The initial bytes, gathered to the values that they are parts of.
class InitialValues {
 public:
  explicit InitialValues(const Emittable& emittable) : emittable_(emittable) {
    for (uint32_t s = 0; s < emittable.program->spaces.size(); ++s) Space(ir::SpaceId(s));
  }

  const std::map<layout::Storage, InitialArray>& arrays() const { return arrays_; }

 private:
  void Add(layout::Storage storage, std::string_view member, ir::Type type, Initial initial) {
    InitialArray& array = arrays_[storage];
    array.member = "m." + std::string(member);
    array.type = type;
    array.values.emplace(initial.index, initial).first->second.value |= initial.value;
  }

  void Space(ir::SpaceId id) {
    const ir::Space& space = emittable_.program->spaces[id];
    if (emittable_.layout.bytes[id.index].empty()) return;
    for (const ir::InitialByte& initial : space.initial) {
      if (initial.value != 0) Byte(emittable_.layout.bytes[id.index][initial.offset], id, initial);
    }
  }

  void Byte(const layout::ByteStorage& stored, ir::SpaceId id, const ir::InitialByte& initial) {
    const uint32_t index = stored.whole.index;
    if (layout::IsWord(stored.whole.storage)) {
      const layout::WordMember& word = layout::WordMemberOf(stored.whole.storage);
      for (const layout::Member& member : emittable_.layout.members) {
        if (member.name != word.name) continue;
        const uint32_t significance = (stored.whole.offset - member.offset) % member.element_bytes;
        Add(stored.whole.storage, word.name, word.type,
            {index, id, initial.offset, uint64_t{initial.value} << (8 * significance)});
      }
    } else if (stored.whole.storage == layout::Storage::kRetentiveByte) {
      Add(layout::Storage::kRetentiveByte, "retentive.bytes", ir::Type::kI8,
          {index, id, initial.offset, initial.value});
    } else if (stored.whole.storage == layout::Storage::kByte) {
      Add(layout::Storage::kByte, "byte", ir::Type::kI8, {index, id, initial.offset, initial.value});
    } else {
      uint32_t left = initial.value;
      for (const layout::PlaceStorage& bit : stored.bits) {
        if (bit.storage == layout::Storage::kBit && (left & 1) != 0)
          Add(layout::Storage::kBit, "bit", ir::Type::kBit, {bit.index, id, initial.offset, 1});
        left >>= 1;
      }
    }
  }

  const Emittable& emittable_;
  std::map<layout::Storage, InitialArray> arrays_;
};

}  // namespace

void PartPrinter::InitialTable(layout::Storage storage, const InitialArray& array, uint32_t begin, uint32_t end) {
  const uint32_t row_bytes = array.type == ir::Type::kBit ? kBitBytesPerRow : kBytesPerRow;
  Line("{");
  ++indent_;
  Line("static constexpr " + std::string(ir::CppName(array.type)) + " kValues[] = {");
  ++indent_;
  std::string row;
  uint32_t row_number = array.values.at(begin).offset / row_bytes;
  for (uint32_t index = begin; index < end; ++index) {
    const auto found = array.values.find(index);
    if (found != array.values.end() && found->second.offset / row_bytes != row_number) {
      row.pop_back();
      Line(std::move(row));
      row.clear();
      row_number = found->second.offset / row_bytes;
    }
    row += array.Text(found == array.values.end() ? 0 : found->second.value) + ", ";
  }
  row.pop_back();
  Line(std::move(row));
  --indent_;
  Line("};");
  Line("plcxx::Place(" + array.member + ", " + ElementName(emittable_, storage, begin) + ", kValues);");
  --indent_;
  Line("}");
}

void PartPrinter::InitStorage() {
  for (const layout::Member& member : emittable_.layout.members) {
    if (member.name == "retentive") {
      Line("m.retentive = Retentive{};");
      Line("m.retentive.layout = kRetentiveLayout;");
    } else {
      Line("Clear(m." + member.name + ");");
    }
  }
  const InitialValues initial(emittable_);
  for (const auto& [storage, array] : initial.arrays()) {
    for (auto first = array.values.begin(); first != array.values.end();) {
      auto end = first;
      const Initial* last = &first->second;
      size_t count = 0;
      for (; end != array.values.end() && Follows(*last, end->second); ++end, ++count) last = &end->second;
      if (count >= kLeastTable) {
        InitialTable(storage, array, first->first, last->index + 1);
        first = end;
      }
      for (; first != end; ++first) {
        Line(array.member + "[" + ElementName(emittable_, storage, first->first) +
             "] = " + array.Text(first->second.value) + ";");
      }
    }
  }
  if (debug()) Line("m.ReapplyForces();");
}

}  // namespace plcxx::emit::print
