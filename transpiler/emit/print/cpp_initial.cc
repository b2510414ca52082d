// What a State holds at power-on: zeros, the values of the spaces' initial bytes, and the retentive block's layout.

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

/// Whether a table can go on with `next` after `last`, or with its first value.
bool Follows(const InitialElement& last, const InitialElement& next) {
  return next.space == last.space && next.index <= last.index + 1 + kMostZeros &&
         next.offset <= last.offset + kMostDistance;
}

std::string TextOf(const InitialArray& array, uint64_t value) {
  return array.type == ir::Type::kI8 ? HexByte(value) : ConstantText(array.type, value);
}

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
    row += TextOf(array, found == array.values.end() ? 0 : found->second.value) + ", ";
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
  for (const auto& [storage, array] : InitialArraysOf(emittable_)) {
    for (auto first = array.values.begin(); first != array.values.end();) {
      auto end = first;
      const InitialElement* last = &first->second;
      size_t count = 0;
      for (; end != array.values.end() && Follows(*last, end->second); ++end, ++count) {
        if (!HasLiteral(array.type, end->second.value)) break;  // a table is constexpr
        last = &end->second;
      }
      if (end == first) ++end;
      if (count >= kLeastTable) {
        InitialTable(storage, array, first->first, last->index + 1);
        first = end;
      }
      for (; first != end; ++first) {
        Line(array.member + "[" + ElementName(emittable_, storage, first->first) +
             "] = " + TextOf(array, first->second.value) + ";");
      }
    }
  }
  if (debug()) Line("m.ReapplyForces();");
}

}  // namespace plcxx::emit::print
