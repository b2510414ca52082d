#include "transpiler/prove/diff/one_sided.h"

#include "transpiler/prove/machine/transition.h"

namespace plcxx::prove::diff {

bool IsPrivate(const machine::Version& version, execute::CellId cell) {
  return machine::DirectionOf(version, cell) == ir::Direction::kInternal && !machine::IsRetentive(version, cell);
}

bool OneSidedMemory::Has(execute::CellId old_cell) const {
  const execute::CellId new_cell = match_.new_of_old[old_cell.index];
  const bool old_uses = old_uses_.reads[old_cell.index] || old_uses_.writes[old_cell.index];
  const bool new_uses = new_uses_.reads[new_cell.index] || new_uses_.writes[new_cell.index];
  return old_uses != new_uses && machine::PowerOnValue(old_, old_cell) == machine::PowerOnValue(new_, new_cell) &&
         IsPrivate(old_, old_cell);
}

OneSided OneSidedMemory::Find() const {
  OneSided found;
  for (uint32_t i = 0; i < old_.cells.count; ++i) {
    const execute::CellId old_cell(i), new_cell = match_.new_of_old[i];
    if (!machine::IsState(old_, old_cell)) continue;
    if (new_cell.valid() ? !Has(old_cell) : !IsPrivate(old_, old_cell)) continue;
    if (old_uses_.writes[i]) {
      found.old_only.push_back(old_cell);
    } else if (!new_cell.valid() && machine::PowerOnValue(old_, old_cell) != 0) {
      found.old_values.push_back(old_cell);
    }
    if (new_cell.valid() && new_uses_.writes[new_cell.index]) found.new_only.push_back(new_cell);
  }
  for (uint32_t i = 0; i < new_.cells.count; ++i) {
    const execute::CellId new_cell(i);
    if (match_.old_of_new[i].valid() || !machine::IsState(new_, new_cell) || !IsPrivate(new_, new_cell)) continue;
    if (new_uses_.writes[i]) {
      found.new_only.push_back(new_cell);
    } else if (machine::PowerOnValue(new_, new_cell) != 0) {
      found.new_values.push_back(new_cell);
    }
  }
  return found;
}

}  // namespace plcxx::prove::diff
