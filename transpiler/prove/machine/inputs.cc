#include "transpiler/prove/machine/inputs.h"

#include "transpiler/prove/machine/sets.h"

namespace plcxx::prove::machine {
bool IsInbox(const Version& version, execute::CellId id) {
  const ir::StateId inbox = version.program->text_inbox;
  if (!inbox.valid()) return false;
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kField && cell.state == inbox;
}

std::vector<bool> InputsOf(const Version& version) {
  const ir::Program& program = *version.program;
  const std::vector<bool> own = SetCells(version);
  std::vector<bool> inputs(version.cells.count);
  for (uint32_t i = 0; i < version.cells.calls; ++i) {
    const execute::CellId id(i);
    const execute::Cell cell = execute::CellAt(program, version.cells, id);
    if (cell.kind != execute::CellKind::kBit || !IsState(version, id)) continue;
    // What the program's side never writes, or only takes back, anybody may set, an output, too.
    inputs[i] =
        WhatControlWrites(version, id) == execute::ControlWrite::kValues || (MayBeSetByHost(version, id) && !own[i]);
  }
  return inputs;
}

}  // namespace plcxx::prove::machine
