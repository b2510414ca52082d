// Which functions of the host and of runtime_support the texts call, and which headers they need.

#include <algorithm>
#include <set>
#include <string_view>

#include "transpiler/emit/initial_values.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::emit::legalize {

void FindUsedHostFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.host_used.assign(program.host_functions.size(), false);
  for (const ir::InstId id : PrintedInsts(program, emittable.options)) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kHostCall) {
      emittable.host_used[program.calls[ir::CallId(inst.payload)].host.index] = true;
    }
  }
}

namespace {

constexpr std::string_view kFloatOfBits = "F32OfBits", kDoubleOfBits = "F64OfBits";

/// By OpKind: whether the text of an instruction names it. What has a wording of its own may name another one.
std::vector<bool> NamedOperations(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::vector<bool> named(ir::OpCount(), false);
  for (const ir::InstId id : PrintedInsts(program, emittable.options)) {
    const bool subtracts = emittable.wordings[id.index] == Wording::kSubtract;
    named[static_cast<size_t>(subtracts ? ir::OpKind::kSub32 : program[id].op)] = true;
    const auto use = [&](uint32_t word) {
      if (emittable.wordings[word] == Wording::kNegative) named[static_cast<size_t>(ir::OpKind::kMinus32)] = true;
    };
    if (subtracts) {
      use(program[id].a);  // the other one has lost its sign
    } else {
      ir::ForEachUse(program, program[id], use);
    }
  }
  return named;
}

/// Values at power-on that are infinities or no numbers are written by their bits.
void AddFunctionsOfInitialValues(Emittable& emittable) {
  for (const auto& [storage, array] : InitialArraysOf(emittable)) {
    if (array.type != ir::Type::kF32 && array.type != ir::Type::kF64) continue;
    const bool has_all = std::ranges::all_of(
        array.values, [&](const auto& value) { return HasLiteral(array.type, value.second.value); });
    if (!has_all) emittable.functions.emplace_back(array.type == ir::Type::kF32 ? kFloatOfBits : kDoubleOfBits);
  }
}

}  // namespace

void FindUsedFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::InstId> insts = PrintedInsts(program, emittable.options);
  const std::vector<bool> used = NamedOperations(emittable);
  for (uint32_t i = 0; i < used.size(); ++i) {
    const auto op = static_cast<ir::OpKind>(i);
    const ir::OpInfo& info = ir::Info(op);
    if (!used[i] || info.shape != ir::Shape::kPure) continue;
    const size_t bracket = info.spelling.find('(');
    if (bracket != std::string_view::npos && bracket > 0) {
      emittable.functions.emplace_back(info.spelling.substr(0, bracket));
    }
    // Comparisons that may never hold are called by name, see Wording.
    if (op == ir::OpKind::kLess8) emittable.functions.emplace_back("Less8");
    if (op == ir::OpKind::kGreater8) emittable.functions.emplace_back("Greater8");
  }
  for (const ir::InstId id : insts) {
    const ir::Inst& inst = program[id];
    if (emittable.wordings[id.index] == Wording::kFunction)
      emittable.functions.emplace_back(ir::Info(inst.op).function);
    const bool number = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF32;
    if (number && !HasLiteral(inst.type, ir::ConstantValue(inst))) {
      emittable.functions.emplace_back(kFloatOfBits);
    }
    const bool wide = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF64;
    if (wide && !HasLiteral(inst.type, ir::ConstantValue(inst))) {
      emittable.functions.emplace_back(kDoubleOfBits);
    }
  }
  AddFunctionsOfInitialValues(emittable);
  std::sort(emittable.functions.begin(), emittable.functions.end());
  emittable.functions.erase(std::unique(emittable.functions.begin(), emittable.functions.end()),
                            emittable.functions.end());
}

void FindUsedHeaders(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::set<std::string> headers = {"arith.h", "bcd.h", "bits.h", "logic.h", "state.h"};
  for (const ir::StateInstance& state : program.states) headers.insert(std::string(ir::Info(state.kind).header));
  const std::vector<bool> named = NamedOperations(emittable);
  for (uint32_t i = 0; i < named.size(); ++i) {
    const std::string_view header = ir::Info(static_cast<ir::OpKind>(i)).header;
    if (named[i] && !header.empty()) headers.insert(std::string(header));
  }
  for (const ir::InstId id : PrintedInsts(program, emittable.options)) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF32) headers.insert("floats.h");
    if (inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF64) headers.insert("doubles.h");
  }
  // Not of a statement, then of a value at power-on.
  if (std::ranges::binary_search(emittable.functions, kFloatOfBits)) headers.insert("floats.h");
  if (std::ranges::binary_search(emittable.functions, kDoubleOfBits)) headers.insert("doubles.h");
  for (const layout::PlaceStorage& stored : emittable.layout.places) {
    const bool wide = stored.storage == layout::Storage::kWide || stored.storage == layout::Storage::kIndexed ||
                      stored.storage == layout::Storage::kRetentiveWide ||
                      stored.storage == layout::Storage::kRetentiveIndexed;
    if (wide) headers.insert("wide.h");
  }
  if (emittable.layout.retentive_bytes > 0) headers.insert("retentive.h");
  if (emittable.options.flavour == Flavour::kDebug) headers.insert("forced.h");
  emittable.headers.assign(headers.begin(), headers.end());
}

}  // namespace plcxx::emit::legalize
