#include "transpiler/soak/notes.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/soak/moment_logic.h"

namespace plcxx::soak {
namespace {

constexpr uint8_t kGave0 = sim::Simulator::kGave0, kGaveOther = sim::Simulator::kGaveOther;
constexpr uint8_t kAny = kGave0 | kGaveOther;

class NoteWriter {
 public:
  explicit NoteWriter(const WatchPlan& plan) : plan_(plan), builder_(noted_.program) {
    noted_.program = plan.program();
    for (const ir::Loop& loop : noted_.program.loops) {
      if (loop.condition.valid()) conditions_.insert(loop.condition.index);
      if (loop.step.valid()) steps_.insert(loop.step.index);
    }
  }

  NotedProgram Write(const Goals& goals) {
    for (const Goal& goal : goals.all()) {
      for (const ir::InstId inst : goal.insts) AddMark(inst, goal.given);
    }
    for (const WatchPlan::Guard& guard : plan_.guards()) AddMark(guard.executed, kAny);
    const ir::Program& program = plan_.program();
    for (uint32_t i = 0; i < program.insts.size(); ++i) {
      const ir::Inst& inst = program[ir::InstId(i)];
      if (inst.op != ir::OpKind::kHostCall) continue;
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      if (!call.exchange && !program.host_functions[call.host].routine_exchange) AddMark(ir::InstId(i), kAny);
    }
    const size_t of_program = noted_.marks.size();
    for (uint32_t i = 0; i < plan_.properties().size(); ++i) {
      if (IsOfOneMoment(program, plan_.cells(), plan_.properties()[i])) noted_.marks.push_back({.property = i});
    }
    if (program.schedule.period.valid()) {
      MakeSpace();
      const auto regions = static_cast<uint32_t>(noted_.program.regions.size());
      for (uint32_t i = 0; i < regions; ++i) WriteRegion(ir::RegionId(i));
      WriteProperties(of_program);
    } else {
      noted_.marks.clear();
    }
    return std::move(noted_);
  }

 private:
  void AddMark(ir::InstId inst, uint8_t given) {
    const auto [at, is_new] = marks_of_.try_emplace({inst.index, given}, static_cast<uint32_t>(noted_.marks.size()));
    if (is_new) noted_.marks.push_back({.inst = inst, .given = given, .property = {}});
  }

  void MakeSpace() {
    ir::Space space;
    space.name = "reached";
    space.title = "what was reached";
    space.bytes = static_cast<uint32_t>(noted_.marks.size() / 8 + 1);
    space.host_visible = true;
    noted_.notes = noted_.program.spaces.Add(std::move(space));
  }

  ir::PlaceId NewPlace(uint32_t mark) { return noted_.program.places.Add(noted_.PlaceOf(mark)); }

  /// In front of an instruction, or behind a mark of a statement: whatever it gives, it was executed.
  void NoteExecuted(uint32_t mark) { builder_.Store(NewPlace(mark), builder_.Bit(1)); }
  void NoteGiven(uint32_t mark, ir::ValueId given) {
    const ir::PlaceId place = NewPlace(mark);
    builder_.Store(place, builder_.Pure(ir::OpKind::kBitOr, {builder_.Load(place), given}));
  }

  void WriteRegion(ir::RegionId region) {
    if (steps_.contains(region.index)) return;
    const std::vector<ir::InstId> insts = noted_.program.regions[region].insts;
    const bool is_condition = conditions_.contains(region.index);
    const ir::RegionId written = builder_.NewRegion();
    builder_.SetRegion(written);
    bool has_marks = false;
    for (const ir::InstId id : insts) {
      // The last value of a condition has to stay the last one.
      const bool may_follow = !is_condition || id != insts.back();
      const bool is_statement = noted_.program[id].op == ir::OpKind::kStatement;
      const auto first = marks_of_.lower_bound({id.index, 0});
      const auto end = marks_of_.upper_bound({id.index, uint8_t{0xFF}});
      const auto note_executed = [&] {
        for (auto at = first; at != end; ++at) {
          if (at->first.second == kAny) NoteExecuted(at->second);
        }
      };
      has_marks = has_marks || first != end;
      if (!is_statement) note_executed();
      noted_.program.regions[written].insts.push_back(id);
      if (is_statement) note_executed();
      for (auto at = first; at != end && may_follow; ++at) {
        if (at->first.second == kGaveOther) NoteGiven(at->second, id);
        if (at->first.second == kGave0) NoteGiven(at->second, builder_.Pure(ir::OpKind::kBitNot, {id}));
      }
    }
    if (has_marks) noted_.program.regions[region].insts = std::move(noted_.program.regions[written].insts);
    noted_.program.regions[written].insts.clear();
  }

  void WriteProperties(size_t of_program) {
    builder_.SetRegion(noted_.program.routines[noted_.program.schedule.period].body);
    for (size_t i = of_program; i < noted_.marks.size(); ++i) {
      const prove::properties::Property& property = plan_.properties()[*noted_.marks[i].property];
      const ir::ValueId holds = HoldsNow(builder_, plan_.cells(), property);
      NoteGiven(static_cast<uint32_t>(i), builder_.Pure(ir::OpKind::kBitNot, {holds}));
    }
  }

  const WatchPlan& plan_;
  NotedProgram noted_;
  ir::Builder builder_;
  std::map<std::pair<uint32_t, uint8_t>, uint32_t> marks_of_;  // by InstId and what it gave
  std::set<uint32_t> conditions_, steps_;                      // regions
};

}  // namespace

ir::Place NotedProgram::PlaceOf(size_t mark) const {
  ir::Place place;
  place.name = "reached" + std::to_string(mark);
  place.space = notes;
  place.offset = static_cast<uint32_t>(mark / 8);
  place.bit = static_cast<uint8_t>(mark % 8);
  return place;
}

NotedProgram NoteReached(const Goals& goals, const WatchPlan& plan) { return NoteWriter(plan).Write(goals); }

}  // namespace plcxx::soak
