#include "transpiler/symbolic/execute/summary.h"

#include <algorithm>
#include <map>
#include <set>

#include "transpiler/ir/accesses.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::execute {
namespace {

class Summarizer {
 public:
  Summarizer(const ir::Program& program, const Cells& cells) : program_(program), cells_(cells) {}

  LoopSummary Run(ir::InstId loop) {
    Inst(loop);
    summary_.written.assign(written_.begin(), written_.end());
    summary_.reads.resize(summary_.cells.size());
    for (const uint32_t number : read_) summary_.reads[number] = true;
    return std::move(summary_);
  }

 private:
  void Word(const std::string& word) { summary_.text += word + " "; }
  void Number(uint64_t number) { Word(std::to_string(number)); }

  void Value(uint32_t id) {
    if (const auto inside = numbers_.find(id); inside != numbers_.end()) {
      Word("v" + std::to_string(inside->second));
      return;
    }
    auto at = std::ranges::find(summary_.outside, ir::ValueId(id));
    if (at == summary_.outside.end()) {
      summary_.outside.emplace_back(id);
      at = summary_.outside.end() - 1;
    }
    Word("o" + std::to_string(at - summary_.outside.begin()));
  }

  /// The cells by their numbers, which are given at the first use, neighbours as one word: where memory lies does not
  /// count, what overlaps does.
  void Use(const std::vector<CellId>& cells, ir::Access access) {
    std::vector<std::pair<uint32_t, uint32_t>> runs;  // first number and after the last one
    for (const CellId cell : cells) {
      const auto [at, added] = cell_numbers_.try_emplace(cell, static_cast<uint32_t>(summary_.cells.size()));
      if (added) summary_.cells.push_back(cell);
      if (access != ir::Access::kRead) written_.insert(at->second);
      if (access != ir::Access::kWrite) read_.insert(at->second);
      if (!runs.empty() && runs.back().second == at->second) {
        ++runs.back().second;
      } else {
        runs.emplace_back(at->second, at->second + 1);
      }
    }
    for (const auto& [first, end] : runs) Word("c" + std::to_string(first) + "-" + std::to_string(end));
  }

  void Instance(ir::StateId state) {
    Word("instance " + std::to_string(static_cast<uint32_t>(program_.states[state].kind)));
    Use(CellsOfInstance(program_, cells_, state), ir::Access::kReadAndWrite);
  }

  void Place(ir::PlaceId id, ir::Access access) {
    const ir::Place& place = program_.places[id];
    if (place.is_field()) {
      const CellId cell(cells_.states[place.state.index] +
                        meaning::FieldTermIndex(program_.states[place.state].kind, place.field));
      Word("field " + std::to_string(static_cast<uint32_t>(program_.states[place.state].kind)));
      Number(place.field);
      Use({cell}, access);
      return;
    }
    const ir::Space& space = program_.spaces[place.space];
    const uint32_t begin = place.indexed ? place.low : place.offset;
    const uint32_t end = std::min(space.bytes, place.indexed ? place.high : place.offset + ir::Bytes(place.type));
    Word(std::string(ir::Name(place.type)));
    Word(space.order == ir::ByteOrder::kBig ? "big" : "little");
    Use(TouchedCells(program_, cells_, place), access);
    if (!place.indexed) return;
    // Where the elements lie from the one with index 0.
    for (const uint32_t at : {begin, end}) Word(std::to_string(int64_t{at} - int64_t{place.offset}));
    Number(place.stride);
  }

  void Target(uint32_t id) {
    if (const auto inside = numbers_.find(id); inside != numbers_.end()) {
      Word("to" + std::to_string(inside->second));
      return;
    }
    auto at = std::ranges::find(summary_.targets, ir::InstId(id));
    if (at == summary_.targets.end()) {
      summary_.targets.emplace_back(id);
      at = summary_.targets.end() - 1;
    }
    Word("out" + std::to_string(at - summary_.targets.begin()));
  }

  void Region(ir::RegionId region) {
    Word("{");
    if (region.valid()) {
      for (const ir::InstId id : program_.regions[region].insts) Inst(id);
    }
    Word("}");
  }

  void Host(ir::CallId id) {
    const ir::Call& call = program_.calls[id];
    const ir::HostFunction& host = program_.host_functions[call.host];
    // What it sees or writes is no cell of the summary.
    if (host.access != ir::HostAccess::kNone) summary_.opaque = true;
    Word(host.name);
    // What answers looks at the calls before; who is only told something does not.
    const bool answers = host.result != ir::Type::kNone || call.out.valid();
    const ir::Access access = answers ? ir::Access::kReadAndWrite : ir::Access::kWrite;
    for (const CellId chain : cells_.ChainsOf(call.host, call.exchange)) Use({chain}, access);
    for (const ir::ValueId argument : call.arguments) Value(argument.index);
    if (call.out.valid()) Place(call.out, ir::Access::kWrite);
  }

  void Subroutine(ir::CallId id) {
    const ir::Call& call = program_.calls[id];
    const ir::Routine& routine = program_.routines[call.routine];
    for (const ir::ValueId argument : call.arguments) Value(argument.index);
    for (const ir::PlaceId parameter : routine.parameter_places) Place(parameter, ir::Access::kWrite);
    // Its locals are its own or its caller's: the kind says so.
    Number(static_cast<uint64_t>(routine.kind));
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region);
    if (routine.result_place.valid()) Place(routine.result_place, ir::Access::kRead);
  }

  void Inst(ir::InstId id) {
    const ir::Inst& inst = program_[id];
    const ir::OpInfo& info = ir::Info(inst.op);
    if (info.shape == ir::Shape::kStatement) return;  // whose it is changes nothing
    numbers_[id.index] = static_cast<uint32_t>(numbers_.size());
    Word(std::string(info.text));
    switch (info.shape) {
      case ir::Shape::kConst:
        Word(std::string(ir::Name(inst.type)));
        Number(ir::ConstantValue(inst));
        break;
      case ir::Shape::kPure:
      case ir::Shape::kStep: {
        if (info.shape == ir::Shape::kStep) Instance(ir::StateId(inst.payload));
        uint8_t count = 0;
        for (const uint32_t operand : {inst.a, inst.b, inst.c}) {
          if (count++ < info.operand_count) Value(operand);
        }
        break;
      }
      case ir::Shape::kLoad:
        Place(ir::PlaceId(inst.payload), ir::Access::kRead);
        if (program_.places[ir::PlaceId(inst.payload)].indexed) Value(inst.a);
        break;
      case ir::Shape::kStore:
        Place(ir::PlaceId(inst.payload), ir::Access::kWrite);
        Value(inst.a);
        if (program_.places[ir::PlaceId(inst.payload)].indexed) Value(inst.b);
        break;
      case ir::Shape::kText:
        Instance(ir::StateId(inst.payload));
        Instance(ir::StateId(inst.a));
        Word(program_.texts[ir::TextId(inst.b)]);
        break;
      case ir::Shape::kIf:
        Value(inst.a);
        Region(ir::RegionId(inst.b));
        Region(ir::RegionId(inst.c));
        break;
      case ir::Shape::kSwitch:
        Value(inst.a);
        for (const ir::SwitchCase& one : program_.switches[ir::SwitchId(inst.payload)].cases) {
          for (const uint64_t value : one.values) Number(value);
          Word(one.falls_through ? "on" : "end");
          Region(one.region);
        }
        break;
      case ir::Shape::kLoop: {
        const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
        Number(static_cast<uint64_t>(loop.kind));
        Number(loop.bound);
        if (loop.budget.valid()) Place(loop.budget, ir::Access::kReadAndWrite);
        for (const ir::RegionId region : {loop.condition, loop.body, loop.step, loop.exhausted}) Region(region);
        break;
      }
      case ir::Shape::kBlock:
        Region(ir::RegionId(inst.a));
        break;
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
        // Another round of a loop around this one is no exit of it.
        if (info.shape == ir::Shape::kRepeat && !numbers_.contains(inst.payload)) summary_.opaque = true;
        Target(inst.payload);
        if (ir::ValueId(inst.a).valid()) Value(inst.a);
        if (info.shape == ir::Shape::kRepeat) Region(ir::RegionId(inst.b));
        break;
      case ir::Shape::kCall:
        Subroutine(ir::CallId(inst.payload));
        break;
      case ir::Shape::kHostCall:
        Host(ir::CallId(inst.payload));
        break;
      case ir::Shape::kStatement:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        break;
    }
  }

  const ir::Program& program_;
  const Cells& cells_;
  LoopSummary summary_;
  std::map<uint32_t, uint32_t> numbers_;  // by InstId: of what stands inside
  std::map<CellId, uint32_t> cell_numbers_;
  std::set<uint32_t> written_, read_;  // numbers
};

}  // namespace

LoopSummary SummarizeLoop(const ir::Program& program, const Cells& cells, ir::InstId loop) {
  return Summarizer(program, cells).Run(loop);
}

}  // namespace plcxx::execute
