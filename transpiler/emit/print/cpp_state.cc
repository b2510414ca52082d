// The struct State of the generated header, and what m[...] gives for each kind of name.

#include <algorithm>
#include <set>

#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {
namespace {

class StatePrinter {
 public:
  explicit StatePrinter(const Emittable& emittable) : emittable_(emittable), program_(*emittable.program) {}

  std::string Run();

 private:
  void RetentiveBlock();
  void Members();
  void Debugging();
  void Accessors();
  void InstanceAccessors();
  void Accessor(std::string_view tag_type, std::string_view value_type, std::string_view expression);
  void PackedAccessor(std::string_view tag_type, std::string_view array);
  void WideAccessor(std::string_view tag_type, std::string_view array);
  void ElementAccessor(std::string_view tag_type, std::string_view array);
  bool Uses(layout::Storage storage) const;
  bool HasMember(std::string_view name) const;
  bool debug() const { return emittable_.options.flavour == Flavour::kDebug; }

  const Emittable& emittable_;
  const ir::Program& program_;
  std::string out_;
};

bool StatePrinter::HasMember(std::string_view name) const {
  const auto& members = emittable_.layout.members;
  return std::any_of(members.begin(), members.end(),
                     [name](const layout::Member& member) { return member.name == name; });
}

/// Whether any name is of this class: what is stored has one.
bool StatePrinter::Uses(layout::Storage storage) const {
  return std::ranges::any_of(emittable_.layout.places,
                             [storage](const layout::PlaceStorage& place) { return place.storage == storage; });
}

void StatePrinter::RetentiveBlock() {
  if (emittable_.layout.retentive_bytes == 0) return;
  // The layout is the spaces, not what this program uses of them: a copy made by another program of the machine fits.
  std::string layout = program_.dialect;
  for (const ir::Space& space : program_.spaces) {
    if (space.lifetime == ir::Lifetime::kRetentive)
      layout += " " + space.name + "[" + std::to_string(space.bytes) + "]";
  }
  out_ += "// What outlives power-off, in address order. A copy with another layout is refused.\n";
  out_ += "inline constexpr uint32_t kRetentiveLayout = plcxx::LayoutHash(" + CppString(layout) + ");\n";
  out_ += "struct Retentive {\n  uint32_t layout;\n  uint8_t bytes[" +
          std::to_string(emittable_.layout.retentive_bytes) + "];\n};\n\n";
}

void StatePrinter::Accessor(std::string_view tag_type, std::string_view value_type, std::string_view expression) {
  const std::string tag(tag_type), value(value_type), object(expression);
  if (debug()) {
    out_ += "  plcxx::Forced<" + value + "> operator[](" + tag + " tag) noexcept { return {" + object + ", Mask(&" +
            object + "), Value(&" + object + ")}; }\n";
  } else {
    out_ += "  [[gnu::const, gnu::always_inline]] " + value + "& operator[](" + tag + " tag) noexcept { return " +
            object + "; }\n";
  }
  out_ += "  [[gnu::pure, gnu::always_inline]] const " + value + "& operator[](" + tag +
          " tag) const noexcept { return " + object + "; }\n";
}

void StatePrinter::PackedAccessor(std::string_view tag_type, std::string_view array) {
  const std::string tag(tag_type), bytes(array);
  const std::string ref =
      "plcxx::PackedBitRef(" + bytes + "[tag.byte], plcxx::MaskOf(plcxx::PackedBit{tag.byte, tag.bit}))";
  if (debug()) {
    out_ += "  plcxx::ForcedPackedBit operator[](" + tag + " tag) noexcept {\n    return {" + ref + ", " + bytes +
            "[tag.byte], Mask(&" + bytes + "[tag.byte]), Value(&" + bytes + "[tag.byte])};\n  }\n";
  } else {
    out_ += "  [[gnu::const, gnu::always_inline]] plcxx::PackedBitRef operator[](" + tag +
            " tag) noexcept {\n    return " + ref + ";\n  }\n";
  }
  out_ += "  [[gnu::pure, gnu::always_inline]] bool operator[](" + tag + " tag) const noexcept {\n    return (" +
          bytes + "[tag.byte] & plcxx::MaskOf(plcxx::PackedBit{tag.byte, tag.bit})) != 0;\n  }\n";
}

/// The address of a byte is that of an element, not a sum: to GCC 12 (-fipa-modref) a function that writes or reads
/// array + number touches the beginning of the array, and the stores to what is there before its call are gone.
void StatePrinter::WideAccessor(std::string_view tag_type, std::string_view array) {
  const std::string tag(tag_type), bytes(array);
  const std::string ref = "plcxx::WideRef<T, kOrder>", head = "  template <class T, plcxx::ByteOrder kOrder>\n";
  if (debug()) {
    out_ += head + "  plcxx::ForcedBytes<" + ref + ", T> operator[](plcxx::" + tag +
            "<T, kOrder> tag) noexcept {\n    uint8_t* const at = &" + bytes + "[tag.byte];\n    return {" + ref +
            "(at), at, true, Mask(at), Value(at)};\n  }\n";
  } else {
    out_ += head + "  [[gnu::const, gnu::always_inline]] " + ref + " operator[](plcxx::" + tag +
            "<T, kOrder> tag) noexcept {\n    return " + ref + "(&" + bytes + "[tag.byte]);\n  }\n";
  }
  out_ += head + "  [[gnu::pure, gnu::always_inline]] T operator[](plcxx::" + tag +
          "<T, kOrder> tag) const noexcept {\n    return plcxx::ReadBytes<T, kOrder>(&" + bytes + "[tag.byte]);\n  }\n";
}

void StatePrinter::ElementAccessor(std::string_view tag_type, std::string_view array) {
  const std::string element = "plcxx::Element<plcxx::" + std::string(tag_type) + "<T, kOrder>> element", bytes(array);
  const std::string ref = "plcxx::ElementRef<T, kOrder>", head = "  template <class T, plcxx::ByteOrder kOrder>\n";
  if (debug()) {
    out_ += head + "  plcxx::ForcedBytes<" + ref + ", T> operator[](" + element +
            ") noexcept {\n    uint8_t* const at = &" + bytes + "[element.place.byte];\n    return {" + ref +
            "(at, element.inside), at, element.inside, Mask(at), Value(at)};\n  }\n";
  } else {
    out_ += head + "  [[gnu::const, gnu::always_inline]] " + ref + " operator[](" + element +
            ") noexcept {\n    return " + ref + "(&" + bytes + "[element.place.byte], element.inside);\n  }\n";
  }
  out_ += head + "  [[gnu::pure, gnu::always_inline]] T operator[](" + element +
          ") const noexcept {\n    return element.inside ? plcxx::ReadBytes<T, kOrder>(&" + bytes +
          "[element.place.byte]) : T{};\n  }\n";
}

void StatePrinter::Members() {
  constexpr uint32_t kMaxNatural = 4;  // numbers of 8 bytes begin at multiples of 4 on 32-bit x86
  out_ += "struct State {\n";
  for (const layout::Member& member : emittable_.layout.members) {
    const bool is_number = !member.element.starts_with("plcxx::") && member.name != "retentive";
    out_ += is_number && member.element_bytes > kMaxNatural ? "  alignas(8) " : "  ";
    out_ += member.element + " " + member.name;
    if (member.name != "retentive") out_ += "[" + std::to_string(member.count) + "]";
    out_ += ";\n";
  }
  if (emittable_.layout.members.empty()) out_ += "  bool unused;\n";
}

void StatePrinter::Debugging() {
  const std::string size = std::to_string(emittable_.layout.size);
  const std::string count = std::to_string(std::max(1u, program_.statements.size()));
  out_ += "\n  // Debug flavour: what is forced, and which statements are switched off.\n";
  out_ += "  unsigned char force_mask[" + size + "];\n  unsigned char force_value[" + size + "];\n  bool off[" + count +
          "];\n\n";
  out_ += "  bool on(unsigned statement) const noexcept { return !off[statement]; }\n";
  out_ +=
      "  size_t OffsetOf(const void* object) const noexcept {\n    return static_cast<size_t>(static_cast<const "
      "unsigned char*>(object) - "
      "reinterpret_cast<const unsigned char*>(this));\n  }\n";
  out_ += "  const unsigned char* Mask(const void* object) const noexcept { return force_mask + OffsetOf(object); }\n";
  out_ +=
      "  const unsigned char* Value(const void* object) const noexcept { return force_value + OffsetOf(object); }\n";
  out_ += "  void ReapplyForces() noexcept { plcxx::ApplyForces(this, force_mask, force_value, " + size + "); }\n";
}

void StatePrinter::Accessors() {
  if (HasMember("bit")) Accessor("Bit", "bool", "bit[tag]");
  if (Uses(layout::Storage::kByte)) Accessor("Byte", "uint8_t", "byte[tag]");
  if (HasMember("word16")) Accessor("Word16", "uint16_t", "word16[tag]");
  if (HasMember("word32")) Accessor("Word32", "uint32_t", "word32[tag]");
  if (HasMember("word64")) Accessor("Word64", "uint64_t", "word64[tag]");
  if (HasMember("float32")) Accessor("Float32", "float", "float32[tag]");
  if (HasMember("float64")) Accessor("Float64", "double", "float64[tag]");
  if (Uses(layout::Storage::kPackedBit)) PackedAccessor("plcxx::PackedBit", "byte");
  if (Uses(layout::Storage::kWide)) WideAccessor("Wide", "byte");
  if (Uses(layout::Storage::kIndexed)) ElementAccessor("Wide", "byte");
  if (Uses(layout::Storage::kRetentiveByte)) Accessor("RetentiveByte", "uint8_t", "retentive.bytes[tag]");
  if (Uses(layout::Storage::kRetentiveBit)) PackedAccessor("plcxx::RetentiveBit", "retentive.bytes");
  if (Uses(layout::Storage::kRetentiveWide)) WideAccessor("RetentiveWide", "retentive.bytes");
  if (Uses(layout::Storage::kRetentiveIndexed)) ElementAccessor("RetentiveWide", "retentive.bytes");
}

void StatePrinter::InstanceAccessors() {
  std::set<std::pair<ir::StateKind, uint8_t>> named;  // fields that are places
  for (uint32_t i = 0; i < program_.places.size(); ++i) {
    const ir::Place& place = program_.places[ir::PlaceId(i)];
    if (place.is_field() && !emittable_.place_names[i].empty()) {
      named.emplace(program_.states[place.state].kind, place.field);
    }
  }
  for (uint32_t k = 0; k < ir::StateKindCount(); ++k) {
    const auto kind = static_cast<ir::StateKind>(k);
    const ir::StateInfo& info = ir::Info(kind);
    if (!HasMember(info.text)) continue;
    Accessor(std::string(info.struct_name) + "Tag", "plcxx::" + std::string(info.struct_name),
             std::string(info.text) + "[tag]");
    for (const auto& [used, field] : named) {
      if (used != kind) continue;
      const std::string name(info.fields[field].name);
      Accessor(std::string(info.struct_name) + "_" + name, ir::CppName(info.fields[field].type),
               std::string(info.text) + "[tag.instance]." + name);
    }
  }
}

std::string StatePrinter::Run() {
  RetentiveBlock();
  Members();
  if (debug()) Debugging();
  out_ += '\n';
  Accessors();
  InstanceAccessors();
  out_ += "};\n\n";
  return std::move(out_);
}

}  // namespace

std::string PrintState(const Emittable& emittable) { return StatePrinter(emittable).Run(); }

}  // namespace plcxx::emit::print
