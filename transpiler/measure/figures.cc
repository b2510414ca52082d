#include "transpiler/measure/figures.h"

#include <algorithm>

#include "transpiler/compile/audit_module.h"
#include "transpiler/compile/audit_rules.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/slices.h"
#include "transpiler/measure/budgets.h"
#include "transpiler/measure/host_audit.h"
#include "transpiler/measure/slices.h"

namespace plcxx::measure {
namespace {

bool IsFloat(ir::Type type) { return type == ir::Type::kF32 || type == ir::Type::kF64; }

bool HasFloats(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::InstId> insts = emit::PrintedInsts(program, emittable.options);
  return std::ranges::any_of(insts, [&](ir::InstId id) { return IsFloat(program[id].type); }) ||
         std::ranges::any_of(program.places, [](const ir::Place& place) { return IsFloat(place.type); });
}

std::string Qualified(const emit::Emittable& emittable, const std::string& name) {
  return emittable.namespace_name + "::" + name;
}

void Report(const compile::AuditFinding& finding, diag::Engine& diagnostics) {
  switch (finding.rule) {
    case compile::AuditRule::kUnreadable:
      diagnostics.Report({}, diag::CannotAudit,
                         "function '" + finding.function + "' has bytes that are no instruction");
      return;
    case compile::AuditRule::kHeap:
      diagnostics.Report({}, diag::AuditHeap, finding.function, finding.detail);
      return;
    case compile::AuditRule::kException:
      diagnostics.Report({}, diag::AuditException, finding.function, finding.detail);
      return;
    case compile::AuditRule::kStaticConstructor:
      diagnostics.Report({}, diag::AuditStaticConstructor, finding.function);
      return;
    case compile::AuditRule::kRecursion:
      diagnostics.Report({}, diag::AuditRecursion, finding.function, finding.detail);
      return;
    case compile::AuditRule::kIndirectCall:
      diagnostics.Report({}, diag::AuditIndirectCall, finding.function);
      return;
    case compile::AuditRule::kFloat:
      diagnostics.Report({}, diag::AuditFloat, finding.function, finding.detail);
      return;
    case compile::AuditRule::kUndefined:
      diagnostics.Report({}, diag::AuditUndefined, finding.function, finding.detail);
      return;
  }
}

void AddSections(const compile::ProgramCode& code, BuildFigures& figures) {
  for (const compile::ObjectFacts& object : code.objects()) {
    for (const compile::CodeSection& section : object.sections) {
      using Kind = compile::SectionKind;
      if (section.kind == Kind::kCode) figures.code_bytes += section.bytes;
      if (section.kind == Kind::kConstants) figures.constant_bytes += section.bytes;
      if (section.kind == Kind::kData || section.kind == Kind::kZeroes) figures.volatile_bytes += section.bytes;
    }
  }
}

}  // namespace

std::optional<compile::ProgramCode> ReadObjects(const std::vector<std::string>& objects, const compile::Target& target,
                                                compilation::Compilation& compilation) {
  std::string reason;
  const compile::ReadObjectFunction read = compile::LoadObjectReader(reason);
  if (read == nullptr) {
    compilation.diagnostics.Report({}, diag::CannotAudit, reason);
    return std::nullopt;
  }
  std::vector<compile::ObjectFacts> facts(objects.size());
  for (size_t i = 0; i < objects.size(); ++i) {
    read({.bytes = objects[i], .processor = target.processor}, facts[i]);
    if (facts[i].failure.empty()) continue;
    compilation.diagnostics.Report({}, diag::CannotAudit, facts[i].failure);
    return std::nullopt;
  }
  return compile::ProgramCode(std::move(facts));
}

void AuditObjects(const compile::ProgramCode& code, const emit::Emittable& emittable,
                  compilation::Compilation& compilation) {
  compile::AuditExpectations expectations;
  const ir::Program& program = *emittable.program;
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    if (!emittable.host_used[i]) continue;
    expectations.host_functions.insert(Qualified(emittable, program.host_functions[ir::HostFunctionId(i)].name));
  }
  expectations.has_floats = HasFloats(emittable);
  for (const compile::AuditFinding& finding : compile::Audit(code, expectations)) {
    Report(finding, compilation.diagnostics);
  }
}

void AuditPeriod(const compile::ProgramCode& code, std::string_view entry, const std::vector<std::string_view>& own,
                 const emit::Emittable& emittable, compilation::Compilation& compilation) {
  compile::AuditExpectations expectations;
  expectations.host_functions.insert(own.begin(), own.end());
  expectations.has_floats = HasFloats(emittable);
  const auto findings = compile::AuditFrom(code, entry, expectations);
  PLCXX_CHECK(findings);
  for (const compile::AuditFinding& finding : *findings) Report(finding, compilation.diagnostics);
}

BuildFigures Measure(const compile::ProgramCode& code, const emit::Emittable& emittable,
                     const std::vector<emit::OutputFile>& files) {
  compile::LoopBounds bounds{.loops = {}, .largest_object = emittable.layout.size};
  uint64_t elements = 0;
  for (const emit::layout::Member& member : emittable.layout.members)
    elements = std::max<uint64_t>(elements, member.count);
  compile::AddRuntimeLoops(bounds.loops, elements);
  for (const emit::OutputFile& file : files) {
    for (const emit::PrintedLoop& loop : file.loops) {
      bounds.loops.push_back(compile::LoopAt(file.name, file.text, loop.line, loop.rounds));
      if (loop.budget.valid()) bounds.loops.back().budget = loop.budget.index;
    }
  }
  BuildFigures figures;
  figures.retentive_bytes = emittable.layout.retentive_bytes;
  figures.volatile_bytes = emittable.layout.size - emittable.layout.retentive_bytes;
  AddSections(code, figures);
  if (!code.objects().empty()) figures.timing = code.objects().front().timing;
  compile::Measurement measurement(code, bounds);
  const ir::Program& program = *emittable.program;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (emit::SharesLocals(routine.kind) || !emit::IsPrinted(routine, emittable.options)) continue;
    const uint32_t function = code.Find(Qualified(emittable, routine.name));
    if (function == compile::kNoFunction) continue;
    const ir::RoutineId id(i);
    const std::map<uint32_t, uint64_t> budgets = BudgetRounds(program, id);
    PartitionFigures partition{.name = routine.name,
                               .routine = id,
                               .figures = measurement.From(function, budgets),
                               .state = StateUsed(emittable, RegionsOf(program, id)),
                               .slices = {},
                               .slices_join = false};
    // It clears all of it.
    if (routine.kind == ir::RoutineKind::kInit) partition.state = {figures.retentive_bytes, figures.volatile_bytes};
    for (const SliceCode& slice : SlicesOf(code, emittable, id)) {
      compile::Measurement one(code, bounds, slice.impossible);
      partition.slices.push_back({slice.slice, slice.piece, one.From(function, budgets),
                                  StateUsed(emittable, RegionsOfSlice(program, id, slice.piece))});
    }
    // One that emission has not cut (ir::Routine::sliced) has one slice.
    partition.slices_join = partition.slices.empty() && ir::TakesSlice(routine) && !routine.sliced;
    figures.partitions.push_back(std::move(partition));
  }
  return figures;
}

}  // namespace plcxx::measure
