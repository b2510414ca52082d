#include <algorithm>

#include "transpiler/emit/cpp_printer.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit {
namespace {

void FindUsedHostFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.host_used.assign(program.host_functions.size(), false);
  for (const ir::InstId id : PrintedInsts(program, emittable.options.flavour)) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kHostCall) {
      emittable.host_used[program.calls[ir::CallId(inst.payload)].host.index] = true;
    }
  }
}

void FindUsedFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::InstId> insts = PrintedInsts(program, emittable.options.flavour);
  std::vector<bool> used(ir::OpCount(), false);
  for (const ir::InstId id : insts) used[static_cast<size_t>(program[id].op)] = true;
  for (uint32_t i = 0; i < used.size(); ++i) {
    const auto op = static_cast<ir::OpKind>(i);
    const ir::OpInfo& info = ir::Info(op);
    if (!used[i] || info.shape != ir::Shape::kPure) continue;
    const size_t bracket = info.spelling.find('(');
    if (bracket != std::string_view::npos && bracket > 0) {
      emittable.functions.emplace_back(info.spelling.substr(0, bracket));
    }
    // Comparisons that may never hold are called by name, see IsForegone.
    if (op == ir::OpKind::kLess8) emittable.functions.emplace_back("Less8");
    if (op == ir::OpKind::kGreater8) emittable.functions.emplace_back("Greater8");
  }
  for (const ir::InstId id : insts) {
    const ir::Inst& inst = program[id];
    if (IsForegone(program, inst)) emittable.functions.emplace_back(ir::Info(inst.op).function);
    const bool number = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF32;
    if (number && ConstantText(inst.type, ir::ConstantValue(inst)).front() == 'F') {
      emittable.functions.emplace_back("F32OfBits");
    }
    const bool wide = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF64;
    if (wide && ConstantText(inst.type, ir::ConstantValue(inst)).front() == 'F') {
      emittable.functions.emplace_back("F64OfBits");
    }
  }
  std::sort(emittable.functions.begin(), emittable.functions.end());
  emittable.functions.erase(std::unique(emittable.functions.begin(), emittable.functions.end()),
                            emittable.functions.end());
}

}  // namespace

std::vector<ir::InstId> PrintedInsts(const ir::Program& program, Flavour flavour) {
  std::vector<ir::InstId> insts;
  for (const ir::Routine& routine : program.routines) {
    if (routine.simulation_only && flavour != Flavour::kDebug) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) ir::ForEachInst(program, region, [&insts](ir::InstId id) { insts.push_back(id); });
    }
  }
  return insts;
}

Emittable Legalize(const ir::Program& program, const EmitOptions& options) {
  Emittable emittable;
  emittable.program = &program;
  emittable.options = options;
  emittable.layout = MakeLayout(program);
  FindUsedHostFunctions(emittable);
  FindUsedFunctions(emittable);
  NamePlaces(emittable);
  PlaceTemporaries(emittable);  // before CutChunks: a chunk never cuts between a value and its use
  CutChunks(emittable);
  CutParts(emittable);
  ShareLocals(emittable);   // after CutChunks: chunks get them, too
  ChooseLeaves(emittable);  // after CutChunks: what ends a function decides what `return` leaves
  PlaceEffects(emittable);  // after ChooseLeaves: a way out that needs no text asks for no value
  PlaceBraces(emittable);   // after PlaceEffects: around the locals
  FindUsedParameters(emittable);
  NameLocals(emittable);  // after FindUsedParameters: no local has a parameter's name
  return emittable;
}

std::string Print(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out = "emittable " + emittable.namespace_name + "\n";
  for (const Member& member : emittable.layout.members) {
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
    const PlaceStorage& stored = emittable.layout.places[i];
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

}  // namespace plcxx::emit
