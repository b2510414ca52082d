#include "transpiler/prove/properties/run_of.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/properties/cone.h"
#include "transpiler/symbolic/execute/host_writes.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

/// What the host has loaded at power-on, where that matters.
std::vector<InputValue> RetentiveOf(CheckedProgram& checked, const Cone& cone) {
  std::vector<InputValue> stored;
  const ir::Program& program = *checked.version.program;
  const ir::HostFunctionId load = program.schedule.retentive_load;
  if (checked.options.retentive != RetentiveMemory::kAny || !load.valid()) return stored;
  const std::string& name = program.host_functions[load].name;
  const terms::TermId calls = execute::CallsAfter(checked.terms, name, checked.terms.Const(0, 64), {});
  if (const terms::TermId copy = execute::HasCopy(checked.terms, name, calls);
      cone.Has(copy) && checked.solver->ValueOf(copy) == 0)
    return stored;
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    const ir::Space& space = program.spaces[ir::SpaceId(i)];
    if (space.lifetime != ir::Lifetime::kRetentive) continue;
    for (uint32_t offset = 0; offset < space.bytes; ++offset) {
      const terms::TermId byte = execute::ByteFromHost(checked.terms, name, calls, space.name, offset);
      if (!cone.Has(byte)) continue;
      const uint64_t value = checked.solver->ValueOf(byte);
      for (uint8_t bit = 0; bit < 8; ++bit) {
        stored.push_back({checked.version.cells.OfBit(ir::SpaceId(i), offset, bit), (value >> bit & 1) != 0});
      }
    }
  }
  return stored;
}

/// What the host has written at power-on, or loaded, where that matters: in a scenario it is set before.
std::vector<InputValue> BeforePowerOn(CheckedProgram& checked, machine::Unrolled& unrolled, const Cone& cone) {
  std::vector<InputValue> values = RetentiveOf(checked, cone);
  if (!cone.has_unknown_function()) return values;  // nothing of it depends on an answer
  const ir::Program& program = *checked.version.program;
  std::map<uint32_t, std::pair<ir::SpaceId, uint32_t>> byte_of;  // by function that gives it
  for (const ir::HostFunction& host : program.host_functions) {
    for (uint32_t s = 0; s < program.spaces.size(); ++s) {
      const ir::SpaceId space(s);
      for (uint32_t offset = 0; offset < program.spaces[space].bytes; ++offset) {
        if (host.access != ir::HostAccess::kWritesState || execute::BitsMayWrite(program, host, space, offset) == 0)
          continue;
        const terms::TermId any = execute::ByteFromHost(checked.terms, host.name, checked.terms.Const(0, 64),
                                                        program.spaces[space].name, offset);
        byte_of.try_emplace(checked.terms[any].a, space, offset);
      }
    }
  }
  std::set<std::pair<ir::SpaceId, uint32_t>> done;
  for (const terms::TermId id : terms::ConeOf(checked.terms, unrolled.after_power_on())) {
    const terms::Term& term = checked.terms[id];
    const auto byte = term.kind == terms::TermKind::kApply ? byte_of.find(term.a) : byte_of.end();
    if (byte == byte_of.end() || !cone.Has(id) || !done.insert(byte->second).second) continue;
    const auto [space, offset] = byte->second;
    const uint64_t value = checked.solver->ValueOf(id);
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const bool is_set = (value >> bit & 1) != 0;
      if (is_set != machine::PowerOnBit(program.spaces[space], offset, bit))
        values.push_back({checked.version.cells.OfBit(space, offset, bit), is_set});
    }
  }
  return values;
}

}  // namespace

PropertyRun RunOf(CheckedProgram& checked, machine::Unrolled& unrolled, terms::TermId violated, uint32_t periods) {
  const Cone cone(checked.terms, violated);
  struct Input {
    uint32_t period, part;
    execute::CellId cell;
    uint32_t variable;
  };
  std::vector<Input> inputs;
  std::vector<uint64_t> values(checked.terms.variable_count());
  for (uint32_t period = 1; period <= periods; ++period) {
    for (uint32_t part = 0; part < unrolled.part_count(); ++part) {
      for (const auto& [cell, variable] : unrolled.parts(period)[part]) {
        if (!cone.Has(variable)) continue;
        inputs.push_back({period, part, cell, checked.terms[variable].a});
        values[inputs.back().variable] = checked.solver->ValueOf(variable);
      }
    }
  }
  std::vector<Input> taken_back;
  for (uint32_t period = 1; period <= periods; ++period) {
    for (uint32_t part = 0; part < unrolled.part_count(); ++part) {
      for (const auto& [cell, variable] : unrolled.takes_back(period)[part]) {
        const bool takes = cone.Has(variable) && checked.solver->ValueOf(variable) != 0;
        values[checked.terms[variable].a] = takes ? 1 : 0;
        if (takes) taken_back.push_back({period, part, cell, checked.terms[variable].a});
      }
    }
  }
  // An input that need not change does not.
  std::map<execute::CellId, uint64_t> before;
  for (const Input& input : inputs) {
    const terms::TermId start = unrolled.Value(input.cell, 0);
    before.try_emplace(input.cell, checked.terms.IsConst(start) ? checked.terms.Value(start) : 0);
    const uint64_t value = values[input.variable];
    if (value != before[input.cell] && !cone.has_unknown_function()) {
      values[input.variable] = before[input.cell];
      if (checked.Late() || cone.Evaluate(values) == 0) values[input.variable] = value;
    }
    before[input.cell] = values[input.variable];
  }
  for (const Input& request : taken_back) {
    if (cone.has_unknown_function() || checked.Late()) break;
    values[request.variable] = 0;
    if (cone.Evaluate(values) == 0) values[request.variable] = 1;
  }
  // What stays as it is behind power-on, and is no input of the machine, is not worth a word.
  std::map<execute::CellId, bool> moves;
  for (const Input& input : inputs) {
    const terms::TermId start = unrolled.Value(input.cell, 0);
    const bool moved = !checked.terms.IsConst(start) || checked.terms.Value(start) != values[input.variable];
    moves[input.cell] =
        moves[input.cell] || moved || machine::DirectionOf(checked.version, input.cell) == ir::Direction::kInput;
  }
  std::erase_if(inputs, [&moves](const Input& input) { return !moves[input.cell]; });
  PropertyRun run;
  run.before_power_on = BeforePowerOn(checked, unrolled, cone);
  run.periods.assign(periods, std::vector<std::vector<InputValue>>(unrolled.part_count()));
  std::map<execute::CellId, uint64_t> now;
  std::map<execute::CellId, uint32_t> set_in;  // by cell: the last period
  const std::vector<bool> handshakes = machine::HandshakeCells(checked.version);
  for (const Input& input : inputs) {
    if (now.try_emplace(input.cell, 0).second) run.periods[0][0].push_back({input.cell, false});
  }
  for (const Input& input : inputs) {
    // What the program writes, too, is not what it was in the period before.
    const bool may_differ = handshakes[input.cell.index] && set_in[input.cell] != input.period;
    if (values[input.variable] == now[input.cell] && !may_differ) continue;
    now[input.cell] = values[input.variable];
    set_in[input.cell] = input.period;
    std::vector<InputValue>& part = run.periods[input.period - 1][input.part];
    const auto same = std::ranges::find(part, input.cell, &InputValue::cell);
    if (same != part.end()) {
      same->value = now[input.cell] != 0;
    } else {
      part.push_back({input.cell, now[input.cell] != 0});
    }
  }
  for (const Input& request : taken_back) {
    if (values[request.variable] != 0) run.periods[request.period - 1][request.part].push_back({request.cell, false});
  }
  return run;
}

}  // namespace plcxx::prove::properties
