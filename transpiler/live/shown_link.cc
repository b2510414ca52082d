#include "transpiler/live/shown_link.h"

#include <algorithm>
#include <utility>

#include "transpiler/engines/lockstep.h"
#include "transpiler/live/fault_statement.h"

namespace plcxx::live {

void ShownLink::TakeSample(uint32_t scan, const std::vector<uint64_t>& values) {
  // A scan of an earlier number is that of a machine which was started anew.
  if (!chart_.samples().empty() && chart_.samples().back().period >= scan) chart_.Clear();
  const sim::ReadWatched read = [&](const sim::Watched& watched) -> uint64_t {
    for (size_t i = 0; i < values.size() && i < chart_.watched().size(); ++i) {
      if (chart_.watched()[i].name == watched.name) return values[i];
    }
    return 0;
  };
  Machine& machine = timeline_.machine();
  chart_.Record(scan, uint64_t{scan} * sim::UnitMs(program_.schedule), read, machine.simulator(), machine.last_part());
}

void ShownLink::TakeFaults(const std::vector<sim::HostEvent>& faults) {
  std::vector<std::string> texts;
  for (const sim::HostEvent& fault : faults) {
    std::string text = engines::ToText(program_, fault);
    if (std::ranges::find(faults_, text) == faults_.end()) {
      const uint64_t scan = status_ ? status_->scans : 0;
      notes_.Add({scan, scan * sim::UnitMs(program_.schedule), NoteKind::kFault,
                  text + " (computed again from what was read)",
                  FaultStatement(program_, fault).value_or(ir::StatementId())});
    }
    texts.push_back(std::move(text));
  }
  faults_ = std::move(texts);
}

void ShownLink::AddNote(std::string text) {
  const uint64_t scan = status_ ? status_->scans : 0;
  notes_.Add({scan, scan * sim::UnitMs(program_.schedule), NoteKind::kLink, std::move(text), {}});
}

}  // namespace plcxx::live
