#include "transpiler/fleet/write_code.h"

#include <algorithm>
#include <set>
#include <string>

#include "transpiler/fleet/code_writer.h"

namespace plcxx::fleet {
namespace {

/// A struct of the fields of a kind of instance as rows, and its lanes as the struct of runtime_support.
std::string FieldsOf(ir::StateKind kind) {
  const ir::StateInfo& info = ir::Info(kind);
  const std::string name = "plcxx::" + std::string(info.struct_name);
  std::string members, take, give, get, set;
  uint32_t first = 0;
  for (const ir::FieldInfo& field : info.fields) {
    const std::string type(ir::CppName(field.type)), row = "row_" + std::string(field.name);
    const uint32_t planes = field.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(field.type);
    members +=
        "  Lanes<" + type + "> " + row + (field.count > 1 ? "[" + std::to_string(field.count) + "]" : "") + ";\n";
    for (uint32_t i = 0; i < field.count; ++i, first += planes) {
      const std::string at = field.count > 1 ? "[" + std::to_string(i) + "]" : "";
      const std::string place = "first + " + std::to_string(first);
      take += "    " + row + at + " = FieldRows<" + type + ">(m, " + place + ");\n";
      give += "    PutFieldRows(m, " + place + ", " + row + at + ", active);\n";
      const std::string member = "instance." + std::string(field.name) + at;
      get += "    __builtin_memcpy(&" + member + ", &" + row + at + ".v[lane], sizeof(" + type + "));\n";
      set += "    __builtin_memcpy(&" + row + at + ".v[lane], &" + member + ", sizeof(" + type + "));\n";
    }
  }
  return "template <>\nstruct Fields<" + name + "> {\n" + members + "  void Take(const State& m, unsigned first) {\n" +
         take + "  }\n  template <class M>\n  void Give(State& m, unsigned first, const M& active) const {\n" + give +
         "  }\n  " + name + " Get(unsigned lane) const {\n    " + name + " instance{};\n" + get +
         "    return instance;\n  }\n  void Set(unsigned lane, const " + name + "& instance) {\n" + set + "  }\n};\n";
}

std::string Head(const ir::Program& program, const Layout& layout) {
  std::string out = "#define PLCXX_FLEET_PLANES " + std::to_string(std::max(layout.planes, 1u)) +
                    "\n#define PLCXX_FLEET_RETENTIVE " + std::to_string(layout.retentive_planes) +
                    "\n#define PLCXX_FLEET_CLOCKS " + std::to_string(std::max(layout.clock_count, 1u)) +
                    "\n#define PLCXX_FLEET_SCALARS " + std::to_string(std::max(layout.scalars, 1u)) +
                    "\n#include \"transpiler/fleet/runtime/unit_timers.h\"\n#include "
                    "\"transpiler/fleet/runtime/rings.h\"\n#include \"transpiler/fleet/runtime/products.h\"\n";
  std::set<std::string> headers;
  for (const char* header : {"arith.h", "bcd.h", "c_integers.h", "doubles.h", "floats.h", "logic.h", "registers.h",
                             "rings.h", "position_counters.h"})
    headers.insert(header);
  std::set<ir::StateKind> kinds;
  for (const ir::StateInstance& state : program.states) {
    kinds.insert(state.kind);
    headers.emplace(ir::Info(state.kind).header);
  }
  for (const std::string& header : headers) out += "#include \"plcxx/" + header + "\"\n";
  out += "namespace plcxx_fleet {\n";
  for (const ir::StateKind kind : kinds) out += FieldsOf(kind);
  for (uint32_t i = 0; i < program.routines.size(); ++i)
    out += "template <class M>\nvoid R" + std::to_string(i) + "(State& m, const M& active);\n";
  return out;
}

std::string Entry(const ir::Program& program, const Layout& layout, const LocalBytes& locals,
                  const SameEverywhere& same) {
  std::string out =
      "}\n\nextern \"C\" uint64_t plcxx_fleet_bytes() { return sizeof(plcxx_fleet::State); }\n"
      "extern \"C\" uint64_t plcxx_fleet_words() { return plcxx_fleet::kWords; }\n"
      "extern \"C\" void plcxx_fleet_run(void* state, const void* host, uint32_t piece) {\n"
      "  using namespace plcxx_fleet;\n"
      "  State& m = *static_cast<State*>(state);\n"
      "  m.host = static_cast<const Host*>(host);\n"
      "  switch (piece) {\n";
  const auto piece = [&](Piece number, ir::RoutineId routine) {
    if (!routine.valid()) return;
    out += "    case " + std::to_string(static_cast<uint32_t>(number)) + ": {\n" +
           RoutineWriter(program, layout, locals, same, routine).ClearLocals(routine, "All{}") + "R" +
           std::to_string(routine.index) + "(m, All{}); } break;\n";
  };
  piece(Piece::kInit, program.schedule.init);
  piece(Piece::kPeriod, program.schedule.period);
  piece(Piece::kFastOnly, program.schedule.fast_only);
  piece(Piece::kElapse, program.schedule.elapse);
  return out + "    default: break;\n  }\n}\n";
}

}  // namespace

void Count(Share& share, bool is_per_lane) { ++(is_per_lane ? share.per_lane : share.sliced); }

Code WriteCode(const ir::Program& program, const Layout& layout, const SameEverywhere& same) {
  Code code;
  const LocalBytes locals(program);
  code.text = Head(program, layout);
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    RoutineWriter writer(program, layout, locals, same, ir::RoutineId(i));
    code.text += writer.Write();
    code.share.sliced += writer.share().sliced;
    code.share.per_lane += writer.share().per_lane;
  }
  code.text += Entry(program, layout, locals, same);
  return code;
}

}  // namespace plcxx::fleet
