#include "transpiler/passes/whole_pass.h"

#include <string>
#include <utility>

#include "transpiler/ir/builder.h"

namespace plcxx::passes {
namespace {

constexpr uint8_t kWholeByte = 0xFF;
constexpr uint32_t kBytesOfTime = 4;

struct SlicedCall {
  ir::RoutineId routine;
  ir::PlaceId counter;
};

/// The place from which `period` takes the slice that it calls; none: from no place, or it calls none.
std::optional<SlicedCall> FindSlicedCall(const ir::Program& program) {
  const ir::Routine& period = program.routines[program.schedule.period];
  std::optional<SlicedCall> found;
  for (const ir::RegionId region : {period.prologue, period.body, period.epilogue}) {
    ir::ForEachInst(program, region, [&](ir::InstId id) {
      if (program[id].op != ir::OpKind::kCall || found) return;
      const ir::Call& call = program.calls[ir::CallId(program[id].payload)];
      const ir::Routine& routine = program.routines[call.routine];
      if (!routine.sliced || routine.slices <= 1) return;
      for (size_t i = 0; i < routine.parameters.size(); ++i) {
        const ir::Inst& argument = program[call.arguments[i]];
        if (routine.parameters[i].name == "slice" && ir::Info(argument.op).shape == ir::Shape::kLoad)
          found = SlicedCall{call.routine, ir::PlaceId(argument.payload)};
      }
    });
  }
  return found;
}

ir::PlaceId AddPlace(ir::Program& program, ir::Type type, ir::SpaceId space, uint32_t offset, uint8_t bit) {
  return program.places.Add({.type = type, .space = space, .offset = offset, .bit = bit});
}

/// The inputs come in front of each slice, and not at the call that fetches them.
void RemoveFetching(ir::Program& program, ir::RegionId region) {
  if (!region.valid()) return;
  std::erase_if(program.regions[region].insts, [&](ir::InstId id) {
    const ir::Inst& inst = program[id];
    if (inst.op != ir::OpKind::kHostCall || inst.type != ir::Type::kNone) return false;
    const ir::HostFunction& host = program.host_functions[program.calls[ir::CallId(inst.payload)].host];
    return host.routine_exchange && host.access == ir::HostAccess::kWritesState && host.out.name.empty();
  });
}

class PassWriter {
 public:
  PassWriter(ir::Program& program, std::span<const ByteBetweenSlices> bytes) : builder_(program), bytes_(bytes) {}

  void Begin(ir::RegionId body) { builder_.SetRegion(body); }

  void SetCounter(ir::PlaceId counter) {
    builder_.Store(counter, builder_.Constant(builder_.program().places[counter].type, 0));
  }

  void SetTime(ir::PlaceId time, uint64_t ms) { builder_.Store(time, builder_.Constant(ir::Type::kI32, ms)); }

  void CopyInputs(ir::SpaceId from, bool is_first) {
    for (uint32_t i = 0; i < bytes_.size(); ++i) {
      const ByteBetweenSlices& byte = bytes_[i];
      if (byte.set == kWholeByte) {
        builder_.Store(AddPlace(builder_.program(), ir::Type::kI8, byte.space, byte.offset, ir::kNoBit),
                       builder_.Load(AddPlace(builder_.program(), ir::Type::kI8, from, i, ir::kNoBit)));
        continue;
      }
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if ((byte.set >> bit & 1) != 0) CopyBit(from, i, bit, false);
        if ((byte.taken_back >> bit & 1) != 0 && !is_first) CopyBit(from, i, bit, true);
      }
    }
  }

  void Call(ir::RoutineId routine) { builder_.CallRoutine(routine, {}); }

 private:
  void CopyBit(ir::SpaceId from, uint32_t index, uint8_t bit, bool only_takes_back) {
    ir::Program& program = builder_.program();
    const ir::PlaceId to = AddPlace(program, ir::Type::kBit, bytes_[index].space, bytes_[index].offset, bit);
    ir::ValueId value = builder_.Load(AddPlace(program, ir::Type::kBit, from, index, bit));
    if (only_takes_back)
      value = builder_.Pure(ir::OpKind::kBitAnd, {builder_.Load(to), builder_.Pure(ir::OpKind::kBitNot, {value})});
    builder_.Store(to, value);
  }

  ir::Builder builder_;
  std::span<const ByteBetweenSlices> bytes_;
};

/// The time of a slice is that of the pass and what has passed since: `call now` becomes `add.i32 (call now) (load
/// time)`.
void AddTimeOfSlice(ir::Program& program, ir::PlaceId time) {
  if (!program.schedule.now.valid()) return;
  for (uint32_t r = 0; r < program.regions.size(); ++r) {
    std::vector<ir::InstId> insts;
    for (const ir::InstId id : program.regions[ir::RegionId(r)].insts) {
      const ir::Inst inst = program[id];
      if (inst.op == ir::OpKind::kHostCall && inst.type == ir::Type::kI32 &&
          program.calls[ir::CallId(inst.payload)].host == program.schedule.now) {
        const ir::InstId now = program.insts.Add(inst);
        const ir::InstId since = program.insts.Add(
            {.op = ir::OpKind::kLoad, .type = ir::Type::kI32, .range = inst.range, .payload = time.index});
        program[id] = {
            .op = ir::OpKind::kAdd32, .type = ir::Type::kI32, .range = inst.range, .a = now.index, .b = since.index};
        insts.insert(insts.end(), {now, since});
      }
      insts.push_back(id);
    }
    program.regions[ir::RegionId(r)].insts = std::move(insts);
  }
}

}  // namespace

std::optional<WholePass> MakeWholePass(ir::Program& program, std::span<const ByteBetweenSlices> bytes) {
  const std::optional<SlicedCall> call = FindSlicedCall(program);
  ir::Schedule& schedule = program.schedule;
  if (!call || schedule.fast_ms != 0 || schedule.fast_done.valid()) return std::nullopt;
  WholePass pass{.slices = program.routines[call->routine].slices, .slice = call->counter, .inputs = {}};
  for (uint32_t i = 0; i < pass.slices; ++i) {
    // Inputs, so that a run tells them although they stay as they are.
    const ir::Zone zone{.begin = 0, .end = 8 * static_cast<uint32_t>(bytes.size()), .direction = ir::Direction::kInput};
    pass.inputs.push_back(program.spaces.Add({.name = "inputs of slice " + std::to_string(i),
                                              .title = {},
                                              .bytes = static_cast<uint32_t>(bytes.size()),
                                              .host_visible = true,
                                              .part_of = {},
                                              .zones = {zone},
                                              .initial = {},
                                              .constants = {}}));
  }
  const ir::SpaceId time_space = program.spaces.Add({.name = "time of slice",
                                                     .title = {},
                                                     .bytes = kBytesOfTime,
                                                     .part_of = {},
                                                     .zones = {},
                                                     .initial = {},
                                                     .constants = {}});
  const ir::PlaceId time = AddPlace(program, ir::Type::kI32, time_space, 0, ir::kNoBit);
  AddTimeOfSlice(program, time);
  const ir::Routine& period = program.routines[schedule.period];
  for (const ir::RegionId region : {period.prologue, period.body, period.epilogue}) RemoveFetching(program, region);
  PassWriter writer(program, bytes);
  const ir::RegionId body = program.regions.Add({});
  writer.Begin(body);
  writer.SetCounter(pass.slice);
  for (uint32_t i = 0; i < pass.slices; ++i) {
    writer.SetTime(time, uint64_t{i} * schedule.period_ms);
    writer.CopyInputs(pass.inputs[i], i == 0);
    writer.Call(schedule.period);
  }
  schedule.period = program.routines.Add({.name = "pass",
                                          .kind = ir::RoutineKind::kSchedule,
                                          .comment = {},
                                          .file_comment = {},
                                          .parameters = {},
                                          .parameter_places = {},
                                          .body = body});
  schedule.fast_only = schedule.period;
  schedule.period_ms *= pass.slices;
  return pass;
}

}  // namespace plcxx::passes
