// The emittable program as text: what was decided, in the order of the program.

#include "transpiler/emit/print/print.h"

namespace plcxx::emit::print {

std::string PrintEmittable(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out = "emittable " + emittable.namespace_name + "\n";
  for (const layout::Member& member : emittable.layout.members) {
    out += "member " + member.name + " : " + member.element + "[" + std::to_string(member.count) + "] at " +
           std::to_string(member.offset) + "\n";
  }
  static constexpr std::string_view kStorage[] = {"none",
                                                  "bit",
                                                  "byte",
                                                  "packed_bit",
                                                  "word16",
                                                  "word32",
                                                  "word64",
                                                  "float32",
                                                  "float64",
                                                  "wide",
                                                  "indexed",
                                                  "retentive_byte",
                                                  "retentive_bit",
                                                  "retentive_wide",
                                                  "retentive_indexed",
                                                  "field",
                                                  "local"};
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    if (emittable.place_names[i].empty()) continue;
    const layout::PlaceStorage& stored = emittable.layout.places[i];
    out += "place " + emittable.place_names[i] + " " + std::string(kStorage[static_cast<size_t>(stored.storage)]) +
           " at " + std::to_string(stored.offset) + (stored.bit != 0 ? "." + std::to_string(stored.bit) : "") + "\n";
  }
  for (const Chunk& chunk : emittable.chunks) {
    out += "chunk " + chunk.name + " " + std::to_string(chunk.statements) + " statements, file " +
           emittable.options.name + emittable.parts[chunk.part].suffix + ".cpp\n";
  }
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    if (emittable.forms[i] == Form::kLocal) out += "local %" + std::to_string(i) + "\n";
  }
  return out;
}

}  // namespace plcxx::emit::print
