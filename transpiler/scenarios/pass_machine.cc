#include "transpiler/scenarios/pass_machine.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/slices.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::scenarios {
namespace {

using execute::CellId;
using prove::machine::Version;
using prove::properties::InputValue;

/// Of what the program reads or writes, what somebody else sets or takes back between two of its periods.
std::vector<passes::ByteBetweenSlices> BytesBetweenSlices(const Version& version) {
  const std::vector<bool> inputs = prove::machine::InputsOf(version);
  const std::vector<bool> requests = prove::machine::RequestCells(version);
  const prove::machine::Uses uses = prove::machine::UsesOf(version);
  std::vector<passes::ByteBetweenSlices> bytes;
  for (uint32_t i = 0; i < version.cells.calls; ++i) {
    if (!(uses.reads[i] || uses.writes[i]) || !(inputs[i] || requests[i])) continue;
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, CellId(i));
    if (cell.kind != execute::CellKind::kBit) continue;
    if (bytes.empty() || bytes.back().space != cell.space || bytes.back().offset != cell.offset)
      bytes.push_back({.space = cell.space, .offset = cell.offset});
    uint8_t& mask = inputs[i] ? bytes.back().set : bytes.back().taken_back;
    mask = static_cast<uint8_t>(mask | 1U << cell.bit);
  }
  return bytes;
}

/// Whether the operator's texts are asked for in front of the first slice alone, where the proofs have new ones anyway:
/// what arrives later waits until then.
bool TextsWaitForPass(const ir::Program& program) {
  const auto asks = [&](ir::RegionId region) {
    size_t count = 0;
    ir::ForEachInst(program, region, [&](ir::InstId id) {
      const ir::Inst& inst = program[id];
      const ir::Shape shape = ir::Info(inst.op).shape;
      if (shape == ir::Shape::kText || (shape == ir::Shape::kStep && inst.payload == program.text_inbox.index)) ++count;
    });
    return count;
  };
  size_t all = 0, first = 0;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) all += asks(region);
    const std::vector<ir::SlicePiece> pieces = ir::SlicePieces(program, ir::RoutineId(i));
    if (routine.sliced && !pieces.empty()) first += asks(pieces.front().region);
  }
  return all == first;
}

/// Whether a pass that begins with slice 0 ends before slice 0 again, whatever happens, and power-on does.
bool ReturnsToFirstSlice(const PassMachine& pass) {
  terms::Terms terms;
  const Version& version = pass.version;
  std::map<CellId, terms::TermId> variables;
  const auto variable_of = [&](CellId cell) {
    terms::TermId& variable = variables[cell];
    const execute::Cell what = execute::CellAt(*version.program, version.cells, cell);
    if (!variable.valid())
      variable = terms.Variable(execute::CellName(*version.program, what), execute::CellWidth(*version.program, what));
    return variable;
  };
  const prove::machine::PartEnvironment environment{
      .initial = variable_of, .now = terms.Variable("now", 32), .observed = {}};
  const prove::machine::Transition init = prove::machine::RunInit(terms, version, environment);
  const prove::machine::Transition period =
      prove::machine::RunPart(terms, version, prove::machine::Part::kPeriod, environment);
  if (!init.refusal.empty() || !period.refusal.empty()) return false;
  const auto is_zero = [&](terms::TermId term) {
    return term.valid() && terms.IsConst(term) && terms.Value(term) == 0;
  };
  const ir::Place& counter = version.program->places[pass.pass.slice];
  return std::ranges::all_of(execute::CellsOf(*version.program, version.cells, counter), [&](CellId cell) {
    return is_zero(init.next[cell.index]) && is_zero(period.next[cell.index]);
  });
}

CellId SameCell(CellId id, const Version& from, const Version& to) {
  const execute::Cell cell = execute::CellAt(*from.program, from.cells, id);
  switch (cell.kind) {
    case execute::CellKind::kBit:
      return to.cells.OfBit(cell.space, cell.offset, cell.bit);
    case execute::CellKind::kField:
      return CellId(to.cells.states[cell.state.index] + (id.index - from.cells.states[cell.state.index]));
    case execute::CellKind::kCalls:
      break;
  }
  PLCXX_UNREACHABLE();  // no location is called
}

/// The slice in front of which an input comes; none: it comes before the pass.
std::optional<uint32_t> SliceOf(const passes::WholePass& pass, ir::SpaceId space) {
  const auto at = std::ranges::find(pass.inputs, space);
  if (at == pass.inputs.end()) return std::nullopt;
  return static_cast<uint32_t>(at - pass.inputs.begin());
}

}  // namespace

void MakePassMachine(const compilation::CompilationRequest& request, PassMachine& pass) {
  pass.compilation = compilation::Compile(request);
  ir::Program& program = pass.compilation.program;
  if (!TextsWaitForPass(program)) {
    pass.refusal = "texts of the operator that come between two slices are not followed yet";
    return;
  }
  pass.bytes = BytesBetweenSlices(prove::machine::MakeVersion(program));
  std::optional<passes::WholePass> whole = passes::MakeWholePass(program, pass.bytes);
  if (!whole) {
    pass.refusal = "a schedule with slices and parts of their own times is not followed yet";
    return;
  }
  pass.pass = *std::move(whole);
  pass.version = prove::machine::MakeVersion(program);
  if (!ReturnsToFirstSlice(pass))
    pass.refusal = "a pass does not always end with its last slice: that is not followed yet";
}

prove::properties::Property InPass(const prove::properties::Property& property, const ProveMachine& machine,
                                   const PassMachine& pass) {
  prove::properties::Property same = property;
  for (prove::properties::PropertyOperand& operand : same.operands) {
    for (CellId& cell : operand.cells) cell = SameCell(cell, machine.version, pass.version);
  }
  return same;
}

prove::properties::PropertyRun FromPass(const prove::properties::PropertyRun& run, const ProveMachine& machine,
                                        const PassMachine& pass) {
  prove::properties::PropertyRun same = run;
  for (InputValue& value : same.before_power_on) value.cell = SameCell(value.cell, pass.version, machine.version);
  // A run tells what changes from pass to pass; here what changes from slice to slice is wanted.
  std::vector<std::map<std::pair<uint32_t, uint8_t>, bool>> values(pass.pass.slices);  // by byte and bit
  for (const auto& period : run.periods) {
    for (const InputValue& value : period.front()) {
      const execute::Cell cell = execute::CellAt(*pass.version.program, pass.version.cells, value.cell);
      if (!SliceOf(pass.pass, cell.space)) continue;
      for (auto& of_slice : values) of_slice[{cell.offset, cell.bit}] = false;  // what it does not tell is 0
    }
  }
  std::map<CellId, bool> now;
  const std::vector<bool> writes = prove::machine::UsesOf(machine.version).writes;
  for (auto& period : same.periods) {
    std::vector<std::vector<InputValue>> slices(pass.pass.slices);
    for (const InputValue& value : period.front()) {
      const execute::Cell cell = execute::CellAt(*pass.version.program, pass.version.cells, value.cell);
      if (const std::optional<uint32_t> slice = SliceOf(pass.pass, cell.space)) {
        values[*slice][{cell.offset, cell.bit}] = value.value;
      } else {
        slices.front().push_back({SameCell(value.cell, pass.version, machine.version), value.value});
      }
    }
    for (uint32_t slice = 0; slice < pass.pass.slices; ++slice) {
      for (const auto& [at, value] : values[slice]) {
        const passes::ByteBetweenSlices& byte = pass.bytes[at.first];
        const CellId cell = machine.version.cells.OfBit(byte.space, byte.offset, at.second);
        if ((byte.taken_back >> at.second & 1) != 0) {
          if (value) slices[slice].push_back({cell, false});
        } else if (const auto before = now.find(cell);
                   before == now.end() || before->second != value || writes[cell.index]) {
          slices[slice].push_back({cell, value});
          now[cell] = value;
        }
      }
    }
    period = std::move(slices);
  }
  return same;
}

}  // namespace plcxx::scenarios
