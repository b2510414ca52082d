// <name>.map.json: symbols and statements for tools. One entry a line, so that two maps can be compared as text.

#include <map>
#include <unordered_set>

#include "transpiler/emit/print/print.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/support/hex.h"

namespace plcxx::emit::print {
namespace {

std::string Json(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20) {
      out += "\\u" + support::HexDigits(code, 4);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

/// The name of the file alone: where it lay when it was translated is nobody's business.
std::string_view FileName(std::string_view path) { return path.substr(path.find_last_of("/\\") + 1); }

/// Of an indexed place `offset` is where its stretch begins; the first value of it lies `first` bytes after.
void Elements(const layout::Elements& elements, const ir::Place& place, std::string& out) {
  out += ", \"first\": " + std::to_string(elements.first) + ", \"stride\": " + std::to_string(place.stride) +
         ", \"lowest_index\": " + std::to_string(elements.lowest) + ", \"count\": " + std::to_string(elements.count);
}

void Symbols(const Emittable& emittable, std::string& out) {
  const ir::Program& program = *emittable.program;
  std::map<std::string_view, const ir::Documentation*> documentation;
  for (const ir::Documentation& row : program.documentation) documentation.emplace(row.address, &row);
  bool first = true;
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const layout::PlaceStorage& stored = emittable.layout.places[i];
    if (emittable.place_names[i].empty() || stored.storage == layout::Storage::kLocal) continue;
    const ir::Place& place = program.places[ir::PlaceId(i)];
    const std::string& address = ir::SourceName(place);
    out += first ? "\n" : ",\n";
    first = false;
    out += "    {\"name\": " + Json(emittable.place_names[i]) + ", \"source\": " + Json(place.name) +
           ", \"address\": " + Json(address) + ", \"type\": " + Json(ir::Name(place.type)) +
           ", \"offset\": " + std::to_string(stored.offset);
    if (stored.storage == layout::Storage::kPackedBit || stored.storage == layout::Storage::kRetentiveBit) {
      out += ", \"bit\": " + std::to_string(stored.bit);
    }
    const bool wide =
        stored.storage == layout::Storage::kWide || stored.storage == layout::Storage::kRetentiveWide || place.indexed;
    if (wide && program.spaces[place.space].order == ir::ByteOrder::kBig) out += ", \"order\": \"big\"";
    if (place.indexed) Elements(layout::ElementsOf(place), place, out);
    const auto row = documentation.find(address);
    if (row != documentation.end()) {
      const ir::Documentation& known = *row->second;
      if (!known.predefined.empty()) out += ", \"predefined\": " + Json(known.predefined);
      const std::string& comment = known.help.empty() ? known.meaning : known.help;
      if (!comment.empty()) out += ", \"comment\": " + Json(comment);
    }
    out += "}";
  }
}

void Instances(const Emittable& emittable, std::string& out) {
  const ir::Program& program = *emittable.program;
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const ir::StateInstance& state = program.states[ir::StateId(i)];
    out += i == 0 ? "\n" : ",\n";
    out += "    {\"name\": " + Json(emittable.state_names[i]) + ", \"source\": " + Json(state.name) +
           ", \"kind\": " + Json(ir::Info(state.kind).text) +
           ", \"offset\": " + std::to_string(emittable.layout.states[i].offset) + ", \"fields\": {";
    const auto fields = ir::Info(state.kind).fields;
    for (uint8_t f = 0; f < static_cast<uint8_t>(fields.size()); ++f) {
      out += (f == 0 ? "" : ", ") + Json(fields[f].name) + ": " +
             std::to_string(emittable.layout.states[i].offset + layout::FieldOffset(state.kind, f));
    }
    out += "}}";
  }
}

void Statements(const Emittable& emittable, const source::SourceManager& sources, std::string& out) {
  bool first = true;
  std::unordered_set<uint32_t> printed;  // a statement that was generated more than once is one place
  for (const ir::Statement& statement : emittable.program->statements) {
    if (statement.range == source::Range{}) continue;  // the control's own
    if (!printed.insert(statement.id).second) continue;
    const source::Position at = sources.Locate(statement.range.begin);
    out += first ? "\n" : ",\n";
    first = false;
    out += "    {\"id\": " + std::to_string(statement.id) + ", \"subject\": " + Json(statement.subject) +
           ", \"file\": " + Json(FileName(sources.Get(at.file).path)) + ", \"line\": " + std::to_string(at.line) +
           ", \"column\": " + std::to_string(at.column) + "}";
  }
}

}  // namespace

std::string PrintMap(const Emittable& emittable, const source::SourceManager& sources) {
  const ir::Program& program = *emittable.program;
  std::string out = "{\n  \"program\": " + Json(emittable.options.name) + ",\n  \"dialect\": " + Json(program.dialect) +
                    ",\n  \"state_bytes\": " + std::to_string(emittable.layout.size) + ",\n  \"symbols\": [";
  Symbols(emittable, out);
  out += "\n  ],\n  \"instances\": [";
  Instances(emittable, out);
  out += "\n  ],\n  \"statements\": [";
  Statements(emittable, sources, out);
  return out + "\n  ]\n}\n";
}

}  // namespace plcxx::emit::print
