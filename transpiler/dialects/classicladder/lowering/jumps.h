// Jumps between the rungs of a section, of which the engine takes so many a scan.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "transpiler/dialects/classicladder/lowering/faults.h"
#include "transpiler/dialects/classicladder/lowering/logic.h"
#include "transpiler/dialects/classicladder/lowering/schedule.h"

namespace plcxx::classicladder {

class Jumps : Context {
 public:
  Jumps(const Context& context, Faults& faults, Logic& logic, Places& places, Schedule& schedule)
      : Context(context), faults_(faults), logic_(logic), places_(places), schedule_(schedule) {}

  /// Where the first rung of `section` stands, whose rungs are `chain` in their order.
  void Begin(const Section& section, const std::vector<uint32_t>& chain);
  /// Where a rung of the chain begins.
  void BeginRung(uint32_t rung);
  /// Behind the last one.
  void End();
  /// False: nothing after it is executed.
  bool Jump(Signal condition, uint32_t rung);

 private:
  /// After the last jump that the engine takes: it ends the section, and stands still from the next period on.
  void Refuse();
  uint32_t LabelOf(uint32_t rung);

  Faults& faults_;
  Logic& logic_;
  Places& places_;
  Schedule& schedule_;
  uint32_t next_label_ = 0;
  /// Of the section that is lowered.
  struct Current {
    size_t position = 0;                  // of the rung
    std::map<uint32_t, size_t> order;     // rung -> position
    std::map<uint32_t, uint32_t> labels;  // rung -> label
    std::set<uint32_t> targets;
    ir::PlaceId jumps_left;  // none: no jump goes back
    uint32_t end_label = 0;
    bool end_is_used = false;
  };
  Current now_;
};

}  // namespace plcxx::classicladder
