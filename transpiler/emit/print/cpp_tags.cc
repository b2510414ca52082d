// The names of a program in its generated header: what m[...] is indexed with.

#include <algorithm>
#include <map>

#include "transpiler/emit/print/cpp_printer.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {
namespace {

class TagPrinter {
 public:
  explicit TagPrinter(const Emittable& emittable) : emittable_(emittable), program_(*emittable.program) {
    for (const ir::Documentation& row : program_.documentation) documentation_.emplace(row.address, &row);
  }

  std::string Run();

 private:
  /// One enumerator; `value` is empty where the one before says it.
  struct Entry {
    uint32_t index = 0;
    std::string name, value, comment;
  };

  void Enumeration(std::string_view comment, std::string_view type, const std::vector<Entry>& entries);
  void ArrayTags(std::string_view comment, std::string_view type, layout::Storage storage);
  void ByteTags();
  void PackedTags(std::string_view type, layout::Storage storage);
  void WideTags(std::string_view prefix, layout::Storage storage);
  void IndexedTags(std::string_view prefix, layout::Storage storage);
  void StateTags();
  void FieldTags(ir::StateKind kind, uint8_t field);
  void Constant(const std::string& type, uint32_t place, const std::string& value);
  std::string ByteName(uint32_t index) const { return ElementName(emittable_, layout::Storage::kByte, index); }
  std::string WideType(std::string_view prefix, const ir::Place& place) const;
  std::vector<uint32_t> PlacesIn(layout::Storage storage) const;
  std::string DocumentationOf(const ir::Place& place) const;

  const Emittable& emittable_;
  const ir::Program& program_;
  std::map<std::string_view, const ir::Documentation*> documentation_;
  std::string out_;
};

/// Places of one storage class in the order of their index; several names of one place stay together.
std::vector<uint32_t> TagPrinter::PlacesIn(layout::Storage storage) const {
  std::vector<uint32_t> places;
  for (uint32_t i = 0; i < emittable_.layout.places.size(); ++i) {
    if (emittable_.layout.places[i].storage == storage && !emittable_.place_names[i].empty()) places.push_back(i);
  }
  std::stable_sort(places.begin(), places.end(), [this](uint32_t left, uint32_t right) {
    const layout::PlaceStorage& a = emittable_.layout.places[left];
    const layout::PlaceStorage& b = emittable_.layout.places[right];
    return std::tuple(a.index, a.bit, emittable_.place_names[left]) <
           std::tuple(b.index, b.bit, emittable_.place_names[right]);
  });
  return places;
}

std::string TagPrinter::DocumentationOf(const ir::Place& place) const {
  std::string out;
  const std::string& address = ir::SourceName(place);
  if (!place.address.empty() && place.address != place.name) out = place.address;
  const auto row = documentation_.find(address);
  if (row == documentation_.end()) return out;
  const ir::Documentation& known = *row->second;
  if (!known.predefined.empty()) out += (out.empty() ? "" : " ") + known.predefined;
  const std::string& text = known.help.empty() ? known.meaning : known.help;
  if (!text.empty()) out += (out.empty() ? "" : ": ") + text;
  return CommentText(out);
}

void TagPrinter::Enumeration(std::string_view comment, std::string_view type, const std::vector<Entry>& entries) {
  if (entries.empty()) return;
  out_ += "// " + std::string(comment) + "\nenum " + std::string(type) + " : uint16_t {\n";
  std::string aliases;
  const Entry* first = nullptr;  // of those with the same index
  for (const Entry& entry : entries) {
    const std::string comment_text = entry.comment.empty() ? "" : "  // " + entry.comment;
    if (first != nullptr && first->index == entry.index) {
      aliases +=
          "inline constexpr " + std::string(type) + " " + entry.name + " = " + first->name + ";" + comment_text + "\n";
      continue;
    }
    first = &entry;
    out_ += "  " + entry.name + (entry.value.empty() ? "" : " = " + entry.value) + "," + comment_text + "\n";
  }
  out_ += "};\n" + aliases + "\n";
}

void TagPrinter::ArrayTags(std::string_view comment, std::string_view type, layout::Storage storage) {
  const bool fixed = storage == layout::Storage::kRetentiveByte;  // its index is its address: it does not move
  std::vector<Entry> entries;
  for (const uint32_t i : PlacesIn(storage)) {
    const uint32_t index = emittable_.layout.places[i].index;
    entries.push_back({index, emittable_.place_names[i], fixed ? std::to_string(index) : "",
                       DocumentationOf(program_.places[ir::PlaceId(i)])});
  }
  Enumeration(comment, type, entries);
}

/// Single bytes count up by themselves. A stretch has a name, by which its bytes and the next stretch are told, so
/// that one more byte anywhere changes no other line.
void TagPrinter::ByteTags() {
  std::vector<Entry> entries;
  for (const uint32_t i : PlacesIn(layout::Storage::kByte)) {
    const uint32_t index = emittable_.layout.places[i].index;
    entries.push_back({index, emittable_.place_names[i], "", DocumentationOf(program_.places[ir::PlaceId(i)])});
  }
  const auto by_index = [](const Entry& a, const Entry& b) { return a.index < b.index; };
  const auto& stretches = emittable_.layout.stretches;
  for (const layout::Stretch& stretch : stretches) {
    if (!std::binary_search(entries.begin(), entries.end(), Entry{stretch.index, "", "", ""}, by_index)) {
      entries.push_back({stretch.index, ByteName(stretch.index), "", ""});
      std::inplace_merge(entries.begin(), entries.end() - 1, entries.end(), by_index);
    }
  }
  for (size_t i = 0; i < stretches.size(); ++i) {
    const layout::Stretch& stretch = stretches[i];
    const auto begin = std::lower_bound(entries.begin(), entries.end(), Entry{stretch.index, "", "", ""}, by_index);
    for (auto entry = begin; entry != entries.end(); ++entry) {
      const uint32_t behind = entry->index - stretch.index;
      if (behind >= stretch.end - stretch.begin) break;
      if (behind > 0) {
        entry->value = ByteName(stretch.index) + " + " + std::to_string(behind);
        continue;
      }
      if (i > 0) {
        const layout::Stretch& before = stretches[i - 1];
        entry->value = ByteName(before.index) + " + " + std::to_string(before.end - before.begin);
      }
      const std::string range = program_.spaces[stretch.space].name + " " + std::to_string(stretch.begin) + ".." +
                                std::to_string(stretch.end - 1) + " at several widths";
      entry->comment = range + (entry->comment.empty() ? "" : "; " + entry->comment);
    }
  }
  Enumeration("Words.", "Byte", entries);
}

void TagPrinter::Constant(const std::string& type, uint32_t place, const std::string& value) {
  const std::string documentation = DocumentationOf(program_.places[ir::PlaceId(place)]);
  out_ += "inline constexpr " + type + " " + emittable_.place_names[place] + "{" + value + "};" +
          (documentation.empty() ? "" : "  // " + documentation) + "\n";
}

void TagPrinter::PackedTags(std::string_view type, layout::Storage storage) {
  const std::vector<uint32_t> places = PlacesIn(storage);
  if (places.empty()) return;
  const bool retentive = storage == layout::Storage::kRetentiveBit;
  out_ += retentive ? "// Bits of the retentive block.\n" : "// Bits of words that the program also uses whole.\n";
  for (const uint32_t i : places) {
    const layout::PlaceStorage& stored = emittable_.layout.places[i];
    const std::string byte = retentive ? std::to_string(stored.index) : ByteName(stored.index);
    Constant("plcxx::" + std::string(type), i, byte + ", " + std::to_string(stored.bit));
  }
  out_ += '\n';
}

std::string TagPrinter::WideType(std::string_view prefix, const ir::Place& place) const {
  const bool little = program_.spaces[place.space].order == ir::ByteOrder::kLittle;
  return "plcxx::" + std::string(prefix) + (little ? "Little<" : "Big<") + std::string(ir::CppName(place.type)) + ">";
}

void TagPrinter::WideTags(std::string_view prefix, layout::Storage storage) {
  const std::vector<uint32_t> places = PlacesIn(storage);
  if (places.empty()) return;
  const bool retentive = storage == layout::Storage::kRetentiveWide;
  out_ += retentive ? "// Values of several bytes in the retentive block.\n"
                    : "// Values of several bytes that the program also uses otherwise.\n";
  for (const uint32_t i : places) {
    const uint32_t index = emittable_.layout.places[i].index;
    Constant(WideType(prefix, program_.places[ir::PlaceId(i)]), i, retentive ? std::to_string(index) : ByteName(index));
  }
  out_ += '\n';
}

void TagPrinter::IndexedTags(std::string_view prefix, layout::Storage storage) {
  const std::vector<uint32_t> places = PlacesIn(storage);
  if (places.empty()) return;
  const bool retentive = storage == layout::Storage::kRetentiveIndexed;
  out_ += "// Values with an index: the first byte, the distance in bytes, the lowest index, how many.\n";
  for (const uint32_t i : places) {
    const ir::Place& place = program_.places[ir::PlaceId(i)];
    const layout::Elements elements = layout::ElementsOf(place);
    const uint32_t first = emittable_.layout.places[i].index + elements.first;
    Constant("plcxx::Indexed<" + WideType(prefix, place) + ">", i,
             (retentive ? std::to_string(first) : ByteName(first)) + ", " + std::to_string(place.stride) + ", " +
                 std::to_string(elements.lowest) + ", " + std::to_string(elements.count));
  }
  out_ += '\n';
}

void TagPrinter::FieldTags(ir::StateKind kind, uint8_t field) {
  std::vector<uint32_t> places;
  for (uint32_t i = 0; i < program_.places.size(); ++i) {
    const ir::Place& place = program_.places[ir::PlaceId(i)];
    if (place.is_field() && place.field == field && program_.states[place.state].kind == kind &&
        !emittable_.place_names[i].empty()) {
      places.push_back(i);
    }
  }
  if (places.empty()) return;
  std::stable_sort(places.begin(), places.end(), [this](uint32_t a, uint32_t b) {
    return std::tuple(emittable_.layout.places[a].index, emittable_.place_names[a]) <
           std::tuple(emittable_.layout.places[b].index, emittable_.place_names[b]);
  });
  const std::string instance = std::string(ir::Info(kind).struct_name);
  const std::string tag = instance + "_" + std::string(ir::Info(kind).fields[field].name);
  out_ += "struct " + tag + " {\n  " + instance + "Tag instance;\n};\n";
  for (const uint32_t i : places) {
    Constant(tag, i, emittable_.state_names[program_.places[ir::PlaceId(i)].state.index]);
  }
}

void TagPrinter::StateTags() {
  for (uint32_t k = 0; k < ir::StateKindCount(); ++k) {
    const auto kind = static_cast<ir::StateKind>(k);
    std::vector<uint32_t> instances;
    for (uint32_t i = 0; i < program_.states.size(); ++i) {
      if (program_.states[ir::StateId(i)].kind == kind) instances.push_back(i);
    }
    if (instances.empty()) continue;
    out_ += "enum " + std::string(ir::Info(kind).struct_name) + "Tag : uint16_t {\n";
    for (const uint32_t i : instances) out_ += "  " + emittable_.state_names[i] + ",\n";
    out_ += "};\n";
    for (uint8_t f = 0; f < static_cast<uint8_t>(ir::Info(kind).fields.size()); ++f) FieldTags(kind, f);
    out_ += '\n';
  }
}

std::string TagPrinter::Run() {
  ArrayTags("Signals, one byte each.", "Bit", layout::Storage::kBit);
  ByteTags();
  ArrayTags("16-bit values.", "Word16", layout::Storage::kWord16);
  ArrayTags("32-bit values.", "Word32", layout::Storage::kWord32);
  ArrayTags("64-bit values.", "Word64", layout::Storage::kWord64);
  ArrayTags("Floating-point values.", "Float32", layout::Storage::kFloat32);
  ArrayTags("Floating-point values of 64 bits.", "Float64", layout::Storage::kFloat64);
  PackedTags("PackedBit", layout::Storage::kPackedBit);
  WideTags("", layout::Storage::kWide);
  IndexedTags("", layout::Storage::kIndexed);
  ArrayTags("Words of the retentive block, by address.", "RetentiveByte", layout::Storage::kRetentiveByte);
  PackedTags("RetentiveBit", layout::Storage::kRetentiveBit);
  WideTags("Retentive", layout::Storage::kRetentiveWide);
  IndexedTags("Retentive", layout::Storage::kRetentiveIndexed);
  StateTags();
  return std::move(out_);
}

}  // namespace

std::string PrintTags(const Emittable& emittable) { return TagPrinter(emittable).Run(); }

}  // namespace plcxx::emit::print
