// Cuts long regions into functions of 25 to 100 statements.
//
//   slow: s1 ... s900   ->   slow: slow_U4A8(m, host); slow_T5(m, host); ...
//
// Which statements a border lies after follows from the statements' own texts (their ids), so that inserting one moves
// the borders next to it at most. Values never cross a statement, so any statement's end can be a border. What leaves a
// block or loop around the region stays where it is, for no jump leads out of a function; its neighbours may be chunks.
// The statements of a slice are functions of their own however few they are: what is called tells what a slice
// executes.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "transpiler/emit/legalize/content_borders.h"
#include "transpiler/emit/legalize/names.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/items.h"
#include "transpiler/ir/slices.h"
#include "transpiler/support/hex.h"

namespace plcxx::emit::legalize {
namespace {

constexpr uint32_t kLeastStatements = 25;  // of a chunk
constexpr uint32_t kMostStatements = 100;
constexpr uint32_t kBorderSeed = 0;
constexpr uint32_t kNowhere = 0xFFFFFFFF;

struct Cutter {
  Emittable& emittable;
  const ir::Program& program;
  std::vector<uint32_t> statements;  // by RegionId, nested ones included
  std::vector<uint32_t> depth;       // by RegionId: 0 for the parts of a routine
  std::vector<uint32_t> reaches;     // by RegionId: the least depth that an Exit or Repeat in it leaves for
  std::vector<uint32_t> home;        // by InstId of blocks and loops: the depth of their region
  std::unordered_set<std::string> names;
  ir::RoutineId routine;  // the one being cut

  void Measure(ir::RegionId region, uint32_t at_depth);
  uint32_t StatementsOf(ir::RegionId region, const ir::Item& item) const;
  bool Stays(ir::RegionId region, const ir::Item& item) const;
  void VisitNested(ir::RegionId region, const ir::Item& item);
  void Visit(ir::RegionId region);
  enum class Stretches : uint8_t { kLongOnes, kAll };  // which become functions between two that stay
  void Cut(ir::RegionId region, Stretches which = Stretches::kLongOnes);
  std::vector<bool> BordersOf(ir::RegionId region, const std::vector<ir::Item>& items, const std::vector<bool>& stays,
                              Stretches which);
  void AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last, uint32_t count,
                size_t first_nested);
  void CutPiece(ir::RegionId region);
};

void Cutter::Measure(ir::RegionId region, uint32_t at_depth) {
  uint32_t count = 0, reached = kNowhere;
  depth[region.index] = at_depth;
  for (const ir::InstId id : program.regions[region].insts) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kStatement) ++count;
    if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
    home[id.index] = at_depth;
    if (inst.op == ir::OpKind::kExit || inst.op == ir::OpKind::kRepeat) reached = std::min(reached, home[inst.payload]);
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
      Measure(owned, at_depth + 1);
      count += statements[owned.index];
      reached = std::min(reached, reaches[owned.index]);
    }
  }
  statements[region.index] = count;
  reaches[region.index] = reached;
}

uint32_t Cutter::StatementsOf(ir::RegionId region, const ir::Item& item) const {
  uint32_t count = 1;
  for (uint32_t i = item.begin; i < item.end; ++i) {
    for (const ir::RegionId owned : ir::OwnedRegions(program, program[program.regions[region].insts[i]])) {
      count += statements[owned.index];
    }
  }
  return count;
}

/// Whether it has to be in the function of its region: it leaves a block or loop around that, or it is the rest of a
/// statement outside, whose values it may use.
bool Cutter::Stays(ir::RegionId region, const ir::Item& item) const {
  const uint32_t own = depth[region.index];
  if (own > 0 && !item.statement.valid()) return true;
  for (uint32_t i = item.begin; i < item.end; ++i) {
    const ir::Inst& inst = program[program.regions[region].insts[i]];
    if (inst.op == ir::OpKind::kExit || inst.op == ir::OpKind::kRepeat) return true;
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
      if (reaches[owned.index] < own) return true;
    }
  }
  return false;
}

void Cutter::VisitNested(ir::RegionId region, const ir::Item& item) {
  for (uint32_t i = item.begin; i < item.end; ++i) {
    const ir::Inst& inst = program[program.regions[region].insts[i]];
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
      const bool otherwise = inst.op == ir::OpKind::kIf && ir::RegionId(inst.c) == owned;
      const bool condition = inst.op == ir::OpKind::kLoop && program.loops[ir::LoopId(inst.payload)].condition == owned;
      if (condition) continue;
      // The bodies of a long chain become functions; the chain itself stays readable as else-if.
      if (!otherwise && statements[owned.index] > kLeastStatements && inst.op != ir::OpKind::kSwitch) {
        Cut(owned);
      } else {
        Visit(owned);
      }
    }
  }
}

void Cutter::Visit(ir::RegionId region) {
  if (statements[region.index] <= kMostStatements) return;
  const std::vector<ir::Item> items = ir::Items(program, region);
  size_t with_statement = 0;
  for (const ir::Item& item : items) with_statement += item.statement.valid() ? 1 : 0;
  if (with_statement > 1) {
    Cut(region);
  } else {
    for (const ir::Item& item : items) VisitNested(region, item);
  }
}

/// By item: whether a function ends with it.
std::vector<bool> Cutter::BordersOf(ir::RegionId region, const std::vector<ir::Item>& items,
                                    const std::vector<bool>& stays, Stretches which) {
  std::vector<bool> borders(items.size());
  for (size_t first = 0; first < items.size();) {
    std::vector<BorderCandidate> stretch;
    uint32_t weight = 0;
    for (size_t i = first; i < items.size() && !stays[i]; ++i) {
      const bool named = items[i].statement.valid();
      const uint32_t hash = named ? program.statements[items[i].statement].id : kNowhere;
      stretch.push_back({StatementsOf(region, items[i]), SpreadHash(hash, kBorderSeed), true});
      weight += stretch.back().weight;
    }
    // Between two that stay, a few statements are no function of their own; a whole list is longer.
    if (weight > 0 && (which == Stretches::kAll || weight >= kLeastStatements)) {
      for (const size_t i : ContentBorders(stretch, {.least = kLeastStatements, .most = kMostStatements}))
        borders[first + i] = true;
      borders[first + stretch.size() - 1] = true;
    }
    first += stretch.size() + 1;
  }
  return borders;
}

void Cutter::Cut(ir::RegionId region, Stretches which) {
  const std::vector<ir::Item> items = ir::Items(program, region);
  std::vector<bool> stays;
  for (const ir::Item& item : items) stays.push_back(Stays(region, item));
  const std::vector<bool> borders = BordersOf(region, items, stays, which);
  size_t first = 0;
  size_t first_nested = emittable.chunks.size();
  uint32_t count = 0;
  for (size_t i = 0; i < items.size(); ++i) {
    const uint32_t own = StatementsOf(region, items[i]);
    if (own > (stays[i] ? kLeastStatements : kMostStatements)) VisitNested(region, items[i]);
    count += own;
    if (borders[i]) AddChunk(region, items, first, i, count, first_nested);
    if (!borders[i] && !stays[i]) continue;
    first = i + 1;
    first_nested = emittable.chunks.size();
    count = 0;
  }
}

void Cutter::AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last,
                      uint32_t count, size_t first_nested) {
  std::string name = emittable.routine_names[routine.index];
  std::vector<ir::StatementId> statements_in;
  for (size_t i = first; i <= last; ++i)
    if (items[i].statement.valid()) statements_in.push_back(items[i].statement);
  // Without one: what the control does in front of the first one of a routine.
  ir::Statement none;
  const ir::Statement& head = statements_in.empty() ? none : program.statements[statements_in.front()];
  if (!statements_in.empty()) name += "_" + SafeIdentifier(head.subject.empty() ? "part" : head.subject);
  if (!names.insert(name).second) {
    name += "_" + support::HexDigits(head.id, 8);
    for (uint32_t i = 2; !names.insert(name).second; ++i) name += "_" + std::to_string(i);
  }
  const auto index = static_cast<uint32_t>(emittable.chunks.size());
  for (size_t i = first_nested; i < index; ++i) {
    if (emittable.chunks[i].parent == Chunk::kNoParent) emittable.chunks[i].parent = index;
  }
  emittable.region_chunks[region.index].push_back(index);
  Chunk chunk;
  chunk.name = name;
  chunk.routine = routine;
  chunk.last_id = statements_in.empty() ? 0 : program.statements[statements_in.back()].id;
  chunk.region = region;
  chunk.begin = items[first].begin;
  chunk.end = items[last].end;
  chunk.statements = count;
  emittable.chunks.push_back(std::move(chunk));
}

/// A piece of a sliced routine; and what it calls beside the functions of its statements.
void Cutter::CutPiece(ir::RegionId region) {
  Cut(region, Stretches::kAll);
  const std::vector<ir::InstId>& insts = program.regions[region].insts;
  const auto note = [&](ir::InstId id) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kCall)
      emittable.called_by_slice[program.calls[ir::CallId(inst.payload)].routine.index] = true;
  };
  uint32_t at = 0;
  const auto note_until = [&](uint32_t end) {
    for (; at < end; ++at) {
      note(insts[at]);
      for (const ir::RegionId owned : ir::OwnedRegions(program, program[insts[at]])) {
        ir::ForEachInst(program, owned, note);
      }
    }
  };
  for (const uint32_t chunk : emittable.region_chunks[region.index]) {
    note_until(emittable.chunks[chunk].begin);
    at = emittable.chunks[chunk].end;
  }
  note_until(static_cast<uint32_t>(insts.size()));
}

}  // namespace

void CutChunks(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.region_chunks.assign(program.regions.size(), {});
  emittable.called_by_slice.assign(program.routines.size(), false);
  Cutter cutter{.emittable = emittable,
                .program = program,
                .statements = std::vector<uint32_t>(program.regions.size()),
                .depth = std::vector<uint32_t>(program.regions.size()),
                .reaches = std::vector<uint32_t>(program.regions.size()),
                .home = std::vector<uint32_t>(program.insts.size()),
                .names = {},
                .routine = {}};
  for (const std::string& name : emittable.place_names) cutter.names.insert(name);
  for (const std::string& name : emittable.state_names) cutter.names.insert(name);
  for (const std::string& name : emittable.routine_names) cutter.names.insert(name);
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) cutter.Measure(region, 0);
    }
  }
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RegionId body = program.routines[ir::RoutineId(i)].body;
    cutter.routine = ir::RoutineId(i);
    const std::vector<ir::SlicePiece> pieces = ir::SlicePieces(program, cutter.routine);
    for (const ir::SlicePiece& piece : pieces) {
      if (emittable.region_chunks[piece.region.index].empty()) cutter.CutPiece(piece.region);
    }
    if (pieces.empty()) cutter.Visit(body);
  }
}

}  // namespace plcxx::emit::legalize
