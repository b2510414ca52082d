#include "transpiler/prove/verify/front_end/front_end.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/prove/verify/compiled_code.h"

namespace plcxx::prove::verify::front_end {
namespace {

/// The spaces one after the other, all bytes as they are: the State on which the sources' own code works.
emit::layout::Layout PlainLayout(const ir::Program& program) {
  emit::layout::Layout layout;
  layout.places.resize(program.places.size());
  layout.bytes.resize(program.spaces.size());
  for (uint32_t s = 0; s < program.spaces.size(); ++s) {
    const ir::Space& space = program.spaces[ir::SpaceId(s)];
    if (space.lifetime == ir::Lifetime::kRoutine) continue;
    for (uint32_t i = 0; i < space.bytes; ++i, ++layout.size) {
      emit::layout::ByteStorage stored{};
      stored.whole = {.storage = emit::layout::Storage::kByte, .index = layout.size, .bit = 0, .offset = layout.size};
      layout.bytes[s].push_back(stored);
    }
  }
  return layout;
}

bool Calls(const ir::Program& program, ir::RoutineId caller, ir::RoutineId callee) {
  bool calls = false;
  const ir::Routine& routine = program.routines[caller];
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid()) continue;
    ir::ForEachInst(program, region, [&](ir::InstId id) {
      const ir::Inst& inst = program[id];
      calls = calls || (inst.op == ir::OpKind::kCall && program.calls[ir::CallId(inst.payload)].routine == callee);
    });
  }
  return calls;
}

class Comparer {
 public:
  Comparer(const emit::Emittable& emittable, const ir::Reference& reference)
      : program_(*emittable.program), reference_(reference), plain_(emittable) {
    plain_.layout = PlainLayout(program_);
    plain_.chunks.clear();
    for (std::vector<uint32_t>& chunks : plain_.region_chunks) chunks.clear();
    NameRoutines();
    MakeShape();
  }

  Comparison Run(const verify::VerifyLimits& limits);

 private:
  void NameRoutines();
  void MakeShape();
  void AddEffects();
  void FindConstants();
  verify::RoutineProof CompareInitialValues(const verify::CompiledCode& code) const;
  void AddLocals(const ir::ReferenceFunction& function);
  void AddInCallers(const ir::ReferenceFunction& function);
  void FindNotCompared();
  FunctionProof ProofInCallers(const ir::ReferenceFunction& function, std::span<const FunctionProof> functions) const;
  uint32_t SlotOf(const ir::ReferenceBytes& at) const {
    return plain_.layout.bytes[at.space.index][at.offset].whole.offset;
  }

  const ir::Program& program_;
  const ir::Reference& reference_;
  emit::Emittable plain_;  // the program without chunks, in plain memory
  verify::CodeShape shape_;
  verify::SourceCode source_;
  std::vector<std::string> not_compared_;  // by index of the reference's functions: why; empty: they are
};

/// Functions of the sources as the sources name them; no other has a name that a function may have.
void Comparer::NameRoutines() {
  for (std::string& name : plain_.routine_names) name = "routine " + name;
  for (const ir::ReferenceFunction& function : reference_.functions)
    plain_.routine_names[function.routine.index] = function.name;
  for (const ir::ReferenceCallee& callee : reference_.callees) {
    if (callee.routine.valid()) plain_.routine_names[callee.routine.index] = callee.name;
  }
}

/// Bytes that hold what they were given at power-on: string literals, and variables that are declared so.
void Comparer::FindConstants() {
  std::vector<std::vector<bool>> written(program_.spaces.size());
  for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
    const ir::Space& space = program_.spaces[ir::SpaceId(s)];
    shape_.is_constant.emplace_back(space.bytes, !space.host_visible && space.lifetime == ir::Lifetime::kVolatile);
    written[s].resize(space.bytes);
  }
  for (const ir::ReferenceVariable& variable : reference_.variables) {
    std::vector<bool>& bytes = shape_.is_constant[variable.at.space.index];
    for (uint32_t i = 0; variable.is_constant && i < variable.at.bytes; ++i) bytes[variable.at.offset + i] = true;
  }
  const auto note = [&](ir::PlaceId id, ir::Access access) {
    const ir::Place& place = program_.places[id];
    if (access == ir::Access::kRead || !place.space.valid()) return;
    std::vector<bool>& bytes = written[place.space.index];
    const uint32_t begin = place.indexed ? place.low : place.offset;
    const uint32_t end = place.indexed ? place.high : place.offset + ir::Bytes(place.type);
    for (uint32_t i = begin; i < end && i < bytes.size(); ++i) bytes[i] = true;
  };
  for (const ir::Inst& inst : program_.insts) ir::ForEachAccess(program_, inst, note, [](ir::StateId) {});
  for (uint32_t s = 0; s < written.size(); ++s) {
    for (uint32_t i = 0; i < written[s].size(); ++i) {
      if (written[s][i]) shape_.is_constant[s][i] = false;
    }
  }
}

void Comparer::AddLocals(const ir::ReferenceFunction& function) {
  for (const ir::ReferenceLocal& local : function.locals) {
    if (local.at.bytes == 0) continue;
    const uint32_t slot = SlotOf(local.at);
    const std::string global = function.name + "." + local.name + " at " + std::to_string(slot);
    source_.locals.push_back({.function = function.name,
                              .name = local.name + (local.is_parameter ? ".addr" : ""),
                              .bytes = local.at.bytes,
                              .global = global});
    shape_.globals.push_back({.name = global, .slot = slot, .bytes = local.at.bytes});
    shape_.dead_behind[function.routine.index].emplace_back(slot, slot + local.at.bytes);
  }
}

/// Executed as a part of its callers: what it keeps where only it works is nothing that they leave.
void Comparer::AddInCallers(const ir::ReferenceFunction& function) {
  shape_.in_callers.push_back(function.routine);
  const auto is_gone = [this](const ir::ReferenceBytes& at) {
    if (at.bytes == 0) return;
    const uint32_t slot = SlotOf(at);
    for (auto& dead : shape_.dead_behind) dead.emplace_back(slot, slot + at.bytes);
  };
  for (const ir::ReferenceLocal& local : function.locals) is_gone(local.at);
  if (function.result) is_gone(*function.result);
}

/// What is executed in its callers makes these what it is. Where others call them, all are unknown functions.
void Comparer::FindNotCompared() {
  const std::vector<ir::ReferenceFunction>& functions = reference_.functions;
  std::vector<size_t> open;
  for (const ir::ReferenceFunction& function : functions) {
    not_compared_.push_back(function.read_otherwise);
    if (!function.read_otherwise.empty()) open.push_back(not_compared_.size() - 1);
  }
  for (size_t i = 0; i < open.size(); ++i) {
    const ir::ReferenceFunction& function = functions[open[i]];
    shape_.unknown.push_back(function.routine);
    if (function.in_callers.empty()) continue;
    for (size_t caller = 0; caller < functions.size(); ++caller) {
      if (!not_compared_[caller].empty() || !Calls(program_, functions[caller].routine, function.routine)) continue;
      not_compared_[caller] = not_compared_[open[i]];
      open.push_back(caller);
    }
  }
}

/// Proved where all that call it are, and calls of others that are executed in their callers are looked through.
FunctionProof Comparer::ProofInCallers(const ir::ReferenceFunction& function,
                                       std::span<const FunctionProof> functions) const {
  FunctionProof found{.proof = {}, .not_compared = {}, .in_callers = {}};
  found.proof.routine = function.name;
  std::vector<ir::RoutineId> open = {function.routine};
  for (size_t i = 0; i < open.size(); ++i) {
    for (uint32_t r = 0; r < program_.routines.size(); ++r) {
      const ir::RoutineId caller(r);
      if (!Calls(program_, caller, open[i])) continue;
      if (std::ranges::find(shape_.in_callers, caller) == shape_.in_callers.end()) {
        found.in_callers.push_back(plain_.routine_names[r]);
      } else if (std::ranges::find(open, caller) == open.end()) {
        open.push_back(caller);
      }
    }
  }
  if (found.in_callers.empty()) {
    found.not_compared = function.in_callers + ", and nothing calls it";
    return found;
  }
  found.proof.result = verify::ProofResult::kProved;
  for (const std::string& caller : found.in_callers) {
    const auto proof = std::ranges::find(functions, caller, [](const FunctionProof& one) { return one.proof.routine; });
    if (proof != functions.end() && proof->not_compared.empty() && proof->proof.result == verify::ProofResult::kProved)
      continue;
    found.proof.result = verify::ProofResult::kNotDecided;
    found.proof.reason = function.in_callers + ", and so with its callers: " + caller;
  }
  return found;
}

void Comparer::AddEffects() {
  for (const ir::ReferenceEffect& effect : reference_.effects) {
    verify::SourceCode::Effect& added = source_.effects.emplace_back();
    added.function = effect.function;
    added.arguments = effect.arguments;
    added.mask = effect.mask;
    added.value = effect.value;
    if (effect.stores_at) {
      const uint32_t slot = SlotOf(*effect.stores_at);
      added.global = "byte " + std::to_string(slot);
      shape_.globals.push_back({.name = added.global, .slot = slot, .bytes = 1});
    }
    if (effect.host.valid()) {
      added.calls = "host " + program_.host_functions[effect.host].name;
      shape_.hosts.emplace_back(added.calls, effect.host);
    }
  }
}

void Comparer::MakeShape() {
  source_.bitcode = reference_.bitcode;
  source_.prefix = plain_.namespace_name + "::";
  shape_.passes = verify::Passes::kNothing;
  shape_.fault = reference_.fault;
  shape_.open_faults = reference_.undefined_faults;
  shape_.library = LibraryResult;
  shape_.dead_behind.resize(program_.routines.size());
  for (const ir::ReferenceVariable& variable : reference_.variables) {
    if (variable.at.bytes == 0) continue;
    shape_.globals.push_back(
        {.name = variable.name,
         .slot = SlotOf(variable.at),
         .bytes = variable.at.bytes,
         .kind = variable.is_table ? verify::CodeGlobal::Kind::kTable : verify::CodeGlobal::Kind::kBytes});
  }
  for (const ir::ReferenceFunction& function : reference_.functions) {
    AddLocals(function);
    if (!function.in_callers.empty()) AddInCallers(function);
  }
  for (const ir::ReferenceCallee& callee : reference_.callees) {
    if (callee.routine.valid()) shape_.unknown.push_back(callee.routine);
    if (callee.host.valid()) shape_.hosts.emplace_back(callee.name, callee.host);
  }
  AddEffects();
  FindNotCompared();
  FindConstants();
}

/// Of all variables, as one more proof.
verify::RoutineProof Comparer::CompareInitialValues(const verify::CompiledCode& code) const {
  verify::RoutineProof proof;
  proof.routine = "initial values";
  proof.result = verify::ProofResult::kProved;
  for (const ir::ReferenceVariable& variable : reference_.variables) {
    const std::vector<int16_t> bytes = code.InitialBytes(variable.name);
    const std::vector<ir::InitialByte>& initial = program_.spaces[variable.at.space].initial;
    for (uint32_t i = 0; i < bytes.size() && i < variable.at.bytes; ++i) {
      const auto at = std::ranges::lower_bound(initial, variable.at.offset + i, {}, &ir::InitialByte::offset);
      const bool there = at != initial.end() && at->offset == variable.at.offset + i;
      const uint64_t expected = there ? at->value : 0;
      ++proof.bytes;
      if (bytes[i] < 0 || expected == static_cast<uint64_t>(bytes[i])) continue;
      proof.result = verify::ProofResult::kDifferent;
      proof.differences.push_back({.what = variable.name + ", byte " + std::to_string(i),
                                   .has_values = true,
                                   .expected = expected,
                                   .compiled = static_cast<uint64_t>(bytes[i])});
    }
  }
  return proof;
}

Comparison Comparer::Run(const verify::VerifyLimits& limits) {
  Comparison comparison{.compiler = reference_.compiler, .reason = {}, .functions = {}};
  const verify::LoadedCode loaded = verify::LoadSourceCode(source_);
  comparison.reason = loaded.reason;
  if (loaded.code == nullptr) return comparison;
  comparison.functions.push_back({.proof = CompareInitialValues(*loaded.code), .not_compared = {}, .in_callers = {}});
  std::vector<ir::RoutineId> routines;
  for (size_t i = 0; i < not_compared_.size(); ++i) {
    const ir::ReferenceFunction& function = reference_.functions[i];
    if (not_compared_[i].empty()) {
      if (function.in_callers.empty()) routines.push_back(function.routine);
      continue;
    }
    FunctionProof& found = comparison.functions.emplace_back();
    found.proof.routine = function.name;
    found.not_compared = not_compared_[i];
  }
  for (verify::RoutineProof& proof : verify::Verify(plain_, *loaded.code, routines, limits, shape_)) {
    const bool known = std::ranges::any_of(
        comparison.functions, [&](const FunctionProof& one) { return one.proof.routine == proof.routine; });
    if (!known) comparison.functions.push_back({.proof = std::move(proof), .not_compared = {}, .in_callers = {}});
  }
  std::vector<FunctionProof> in_callers;
  for (size_t i = 0; i < not_compared_.size(); ++i) {
    const ir::ReferenceFunction& function = reference_.functions[i];
    if (function.in_callers.empty() || !not_compared_[i].empty()) continue;
    in_callers.push_back(ProofInCallers(function, comparison.functions));
  }
  for (FunctionProof& function : in_callers) comparison.functions.push_back(std::move(function));
  return comparison;
}

}  // namespace

Comparison Compare(const emit::Emittable& emittable, const ir::Reference& reference,
                   const verify::VerifyLimits& limits) {
  if (!reference.reason.empty()) return {.compiler = {}, .reason = reference.reason, .functions = {}};
  return Comparer(emittable, reference).Run(limits);
}

}  // namespace plcxx::prove::verify::front_end
