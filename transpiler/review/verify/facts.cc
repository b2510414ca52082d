#include "transpiler/review/verify/facts.h"

#include <algorithm>
#include <utility>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/prove/verify/verify.h"
#include "transpiler/scenarios/failure.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/counted.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::review::verify {
namespace {

using prove::verify::facts::FactResult;
using prove::verify::facts::Violation;

constexpr size_t kMostValues = 60;  // of a state that is shown

uint64_t ConstantOf(const ir::Program& program, ir::InstId call, ir::FalseFactArgument which) {
  const std::vector<ir::ValueId>& arguments = program.calls[ir::CallId(program[call].payload)].arguments;
  return ir::ConstantValue(program[arguments[static_cast<size_t>(which)]]);
}

ir::StatementId StatementOf(const ir::Program& program, uint64_t number) {
  for (uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[ir::StatementId(i)].id == number) return ir::StatementId(i);
  }
  return {};
}

/// The place of a cell, for who writes it from outside; none: nobody can.
std::optional<ir::Place> PlaceOf(const ir::Program& program, const execute::Cell& cell) {
  ir::Place place;
  switch (cell.kind) {
    case execute::CellKind::kBit:
      place.type = ir::Type::kBit;
      place.space = cell.space;
      place.offset = cell.offset;
      place.bit = cell.bit;
      return place;
    case execute::CellKind::kField: {
      const ir::FieldInfo& field = ir::Info(program.states[cell.state].kind).fields[cell.field];
      if (field.count != 1) return std::nullopt;
      place.type = field.type;
      place.state = cell.state;
      place.field = cell.field;
      return place;
    }
    case execute::CellKind::kCalls:
      break;
  }
  return std::nullopt;
}

/// Whether the simulator, from the state that was found, comes to the same fact and finds it false.
bool Shows(const ir::Program& checked, const Violation& violation, ir::InstId call) {
  ir::Program program = checked;
  ir::Builder builder(program);
  ir::Routine routine{.name = "replay", .kind = ir::RoutineKind::kSchedule};
  routine.body = builder.NewRegion();
  builder.SetRegion(routine.body);
  std::vector<ir::ValueId> arguments;
  const ir::Routine& called = program.routines[violation.routine];
  for (size_t i = 0; i < called.parameters.size() && i < violation.arguments.size(); ++i)
    arguments.push_back(builder.Constant(called.parameters[i].type, violation.arguments[i]));
  if (arguments.size() != called.parameters.size()) return false;
  builder.CallRoutine(violation.routine, std::move(arguments));
  program.schedule.fast_only = program.routines.Add(std::move(routine));
  sim::Simulator simulator(program);
  simulator.PowerOn();
  const execute::Cells cells = execute::MakeCells(program);
  for (const Violation::CellValue& value : violation.state) {
    const auto place = PlaceOf(program, execute::CellAt(program, cells, value.cell));
    if (place) simulator.Write(*place, value.value);
  }
  simulator.TakeEvents();
  simulator.RunFastOnly(violation.now_ms);
  const uint64_t kind = ConstantOf(program, call, ir::FalseFactArgument::kKind);
  const uint64_t statement = ConstantOf(program, call, ir::FalseFactArgument::kStatement);
  const ir::HostFunctionId false_fact = ir::FalseFactOf(program);
  return std::ranges::any_of(simulator.TakeEvents(), [&](const sim::HostEvent& event) {
    return event.function == false_fact && event.arguments[static_cast<size_t>(ir::FalseFactArgument::kKind)] == kind &&
           event.arguments[static_cast<size_t>(ir::FalseFactArgument::kStatement)] == statement;
  });
}

/// Bits of one byte as that byte; what is 0 is left out.
std::string StateText(const ir::Program& program, const Violation& violation) {
  const execute::Cells cells = execute::MakeCells(program);
  std::vector<std::pair<std::string, uint64_t>> named;
  const ir::Routine& routine = program.routines[violation.routine];
  for (size_t i = 0; i < violation.arguments.size() && i < routine.parameters.size(); ++i)
    named.emplace_back(routine.parameters[i].name, violation.arguments[i]);
  for (const Violation::CellValue& value : violation.state) {
    const execute::Cell cell = execute::CellAt(program, cells, value.cell);
    if (value.value == 0 || cell.kind == execute::CellKind::kCalls) continue;
    if (cell.kind != execute::CellKind::kBit) {
      named.emplace_back(execute::CellName(program, cell), value.value);
      continue;
    }
    const std::string name = program.spaces[cell.space].name + "." + std::to_string(cell.offset);
    const auto found = std::ranges::find(named, name, &std::pair<std::string, uint64_t>::first);
    if (found == named.end()) {
      named.emplace_back(name, uint64_t{1} << cell.bit);
    } else {
      found->second |= uint64_t{1} << cell.bit;
    }
  }
  std::erase_if(named, [](const auto& one) { return one.second == 0; });
  if (named.empty()) return "all 0";
  std::string text;
  for (size_t i = 0; i < named.size() && i < kMostValues; ++i)
    text += (i == 0 ? "" : ", ") + named[i].first + "=" + std::to_string(named[i].second);
  return text;
}

}  // namespace

size_t FactsReport::CountOf(FactResult result) const {
  return static_cast<size_t>(std::ranges::count(findings, result, &FactFinding::result));
}

bool FactsReport::all_proved() const { return refusal.empty() && CountOf(FactResult::kProved) == findings.size(); }

std::string FactsReport::Text() const {
  if (!refusal.empty()) return "  facts that the code rests on: not looked at: " + refusal + "\n";
  if (findings.empty()) return "  facts that the code rests on: none\n";
  std::string text = "  facts that the code rests on: " + std::to_string(CountOf(FactResult::kProved)) + " of " +
                     std::to_string(findings.size()) + " hold for every state\n";
  for (const FactFinding& finding : findings) {
    switch (finding.result) {
      case FactResult::kProved:
        break;
      case FactResult::kNotDecided:
        text += "    " + finding.place + ": " + finding.kind + ": not decided: " + finding.reason + "\n";
        break;
      case FactResult::kViolated:
        text += "    " + finding.place + ": " + finding.kind + ": does not hold of the value " +
                std::to_string(finding.value) + ", in " + finding.routine + " with " + finding.state + "\n";
        break;
    }
  }
  return text;
}

FactsReport VerifyFactsOf(const compilation::Compilation& checked, const std::vector<std::string>& routines,
                          const prove::verify::facts::FactLimits& limits) {
  FactsReport report;
  if (!checked.ok()) {
    report.refusal = "the program does not compile with its facts checked";
    return report;
  }
  const ir::Program& program = checked.program;
  std::vector<ir::RoutineId> chosen;
  for (const ir::RoutineId id : prove::verify::RoutinesToVerify(program)) {
    if (routines.empty() || std::ranges::find(routines, program.routines[id].name) != routines.end())
      chosen.push_back(id);
  }
  const emit::Emittable emittable = emit::legalize::Legalize(program, {.name = checked.name});
  for (const prove::verify::facts::FactProof& proof : prove::verify::facts::ProveFacts(emittable, chosen, limits)) {
    const uint64_t statement = ConstantOf(program, proof.call, ir::FalseFactArgument::kStatement);
    FactFinding finding{
        .result = proof.result,
        .kind = std::string(ir::FactNames()[ConstantOf(program, proof.call, ir::FalseFactArgument::kKind)]),
        .place = scenarios::StatementPlace(StatementOf(program, statement), program, *checked.sources),
        .reason = proof.reason};
    if (proof.result == FactResult::kViolated) {
      if (Shows(program, proof.violation, proof.call)) {
        finding.value = proof.value;
        finding.routine = program.routines[proof.violation.routine].name;
        finding.state = StateText(program, proof.violation);
      } else {
        finding.result = FactResult::kNotDecided;
        finding.reason =
            "the state that was found does not show it in the simulator: " + StateText(program, proof.violation);
      }
    }
    report.findings.push_back(std::move(finding));
  }
  return report;
}

compilation::Compilation CompileChecked(compilation::CompilationRequest request) {
  request.options.emplace_back(compilation::kFactsOption, "checked");
  return compilation::Compile(request);
}

}  // namespace plcxx::review::verify
