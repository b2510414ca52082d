// Cuts long regions into functions of 25 to 100 statements, and long programs into several files.
//
//   slow: s1 ... s900   ->   slow: slow_U4A8(m, host); slow_T5(m, host); ...
//
// A border lies behind a statement whose own text says so (its id, a hash of the text), so that inserting a statement
// moves no other border. Values never cross a statement, so any statement's end can be a border. What leaves a block or
// loop around the region stays where it is, for no jump leads out of a function; its neighbours may be chunks.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "transpiler/emit/emittable.h"
#include "transpiler/emit/names.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/items.h"

namespace plcxx::emit {
namespace {

constexpr uint32_t kLeastStatements = 25;  // of a chunk
constexpr uint32_t kMostStatements = 100;
constexpr uint32_t kBorderEvery = 12;     // about one statement in so many is a border
constexpr uint32_t kLeastPerPart = 1000;  // statements of a file
constexpr uint32_t kMostPerPart = 4000;
constexpr uint32_t kPartBorderEvery = 8;  // about one chunk in so many
constexpr uint32_t kOneFile = 3000;       // up to so many statements the program is one file
constexpr uint32_t kNowhere = 0xFFFFFFFF;

struct Cutter {
  Emittable& emittable;
  const ir::Program& program;
  std::vector<uint32_t> statements;  // by RegionId, nested ones included
  std::vector<uint32_t> depth;       // by RegionId: 0 for the parts of a routine
  std::vector<uint32_t> reaches;     // by RegionId: the least depth that an Exit or Repeat in it leaves for
  std::vector<uint32_t> home;        // by InstId of blocks and loops: the depth of their region
  std::unordered_set<std::string> names;
  std::string prefix;

  void Measure(ir::RegionId region, uint32_t at_depth);
  uint32_t StatementsOf(ir::RegionId region, const ir::Item& item) const;
  bool Stays(ir::RegionId region, const ir::Item& item) const;
  void VisitNested(ir::RegionId region, const ir::Item& item);
  void Visit(ir::RegionId region);
  void Cut(ir::RegionId region);
  void AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last, uint32_t count,
                size_t first_nested);
  void MakeParts();
  void MakeFixedParts();
  void CallInRuns();
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

void Cutter::Cut(ir::RegionId region) {
  const std::vector<ir::Item> items = ir::Items(program, region);
  size_t first = 0;
  size_t first_nested = emittable.chunks.size();
  uint32_t count = 0;
  bool whole = true;  // nothing stays
  const auto restart = [&](size_t next) {
    first = next;
    first_nested = emittable.chunks.size();
    count = 0;
  };
  for (size_t i = 0; i < items.size(); ++i) {
    const uint32_t own = StatementsOf(region, items[i]);
    const bool stays = Stays(region, items[i]);
    if (stays) {
      // Between two that stay, a few statements are no function of their own.
      if (count >= kLeastStatements) AddChunk(region, items, first, i - 1, count, first_nested);
      whole = false;
    }
    if (own > (stays ? kLeastStatements : kMostStatements)) VisitNested(region, items[i]);
    if (stays) {
      restart(i + 1);
      continue;
    }
    count += own;
    const bool border = items[i].statement.valid() && program.statements[items[i].statement].id % kBorderEvery == 0;
    const bool last = i + 1 == items.size() && (whole || count >= kLeastStatements);
    if (last || count >= kMostStatements || (border && count >= kLeastStatements)) {
      AddChunk(region, items, first, i, count, first_nested);
      restart(i + 1);
    }
  }
}

void Cutter::AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last,
                      uint32_t count, size_t first_nested) {
  std::string name = prefix;
  uint32_t id = 0;
  for (size_t i = first; i <= last; ++i) {
    if (!items[i].statement.valid()) continue;
    const ir::Statement& statement = program.statements[items[i].statement];
    name += "_" + SafeIdentifier(statement.subject.empty() ? "part" : statement.subject);
    id = statement.id;
    break;
  }
  if (!names.insert(name).second) {
    constexpr char kHex[] = "0123456789abcdef";
    std::string hash = "_";
    for (int shift = 28; shift >= 0; shift -= 4) hash += kHex[id >> shift & 15];
    name += hash;
    for (uint32_t i = 2; !names.insert(name).second; ++i) name += "_" + std::to_string(i);
  }
  const auto index = static_cast<uint32_t>(emittable.chunks.size());
  for (size_t i = first_nested; i < index; ++i) {
    if (emittable.chunks[i].parent == Chunk::kNoParent) emittable.chunks[i].parent = index;
  }
  emittable.region_chunks[region.index].push_back(index);
  Chunk chunk;
  chunk.name = name;
  chunk.region = region;
  chunk.begin = items[first].begin;
  chunk.end = items[last].end;
  chunk.statements = count;
  emittable.chunks.push_back(std::move(chunk));
}

uint32_t HashOf(const std::string& name) {
  uint32_t hash = 0;
  for (const char c : name) hash = hash * 31 + static_cast<unsigned char>(c);
  return hash;
}

void Cutter::MakeParts() {
  std::vector<Chunk>& chunks = emittable.chunks;
  uint32_t total = 0;
  for (const Chunk& chunk : chunks) total += chunk.parent == Chunk::kNoParent ? chunk.statements : 0;
  if (total <= kOneFile) return;
  uint32_t in_part = 0;
  bool full = true;
  const Chunk* previous = nullptr;  // that a routine calls
  for (Chunk& chunk : chunks) {
    if (chunk.parent != Chunk::kNoParent) continue;
    const bool other_region = previous != nullptr && previous->region != chunk.region;
    if (full || (other_region && in_part >= kLeastPerPart)) {
      emittable.parts.push_back({"_" + chunk.name});
      in_part = 0;
      full = false;
    }
    chunk.part = static_cast<uint32_t>(emittable.parts.size() - 1);
    previous = &chunk;
    in_part += chunk.statements;
    full = in_part >= kMostPerPart || (in_part >= kLeastPerPart && HashOf(chunk.name) % kPartBorderEvery == 0);
  }
  CallInRuns();
}

/// The borders are behind the chunks with the least hashes, some distance from each other: which ones these are
/// depends on their own names, so that an edit moves at most the border that it touches.
void Cutter::MakeFixedParts() {
  std::vector<Chunk>& chunks = emittable.chunks;
  struct Candidate {
    uint32_t hash, behind;  // so many statements stand before it
    size_t chunk;           // the first one of the next file
  };
  std::vector<Candidate> candidates;
  uint32_t total = 0;
  uint32_t previous_hash = 0;
  for (size_t i = 0; i < chunks.size(); ++i) {
    if (chunks[i].parent != Chunk::kNoParent) continue;
    if (total > 0) candidates.push_back({previous_hash, total, i});
    previous_hash = HashOf(chunks[i].name);
    total += chunks[i].statements;
  }
  std::ranges::sort(candidates, {}, [](const Candidate& c) { return std::pair(c.hash, c.chunk); });
  const uint32_t distance = total / (3 * emittable.options.parts);
  std::vector<Candidate> borders;
  for (const Candidate& candidate : candidates) {
    if (borders.size() + 1 == emittable.options.parts) break;
    const auto near = [&](uint32_t at) {
      return (candidate.behind < at ? at - candidate.behind : candidate.behind - at) < distance;
    };
    if (near(0) || near(total)) continue;
    if (std::ranges::none_of(borders, [&](const Candidate& border) { return near(border.behind); }))
      borders.push_back(candidate);
  }
  std::ranges::sort(borders, {}, &Candidate::chunk);
  // Chunks of the first file are functions of the routines' own file.
  uint32_t part = 0;
  for (size_t i = 0; i < chunks.size(); ++i) {
    if (part < borders.size() && i == borders[part].chunk) ++part;
    chunks[i].part = part;
  }
  for (uint32_t number = 2; number <= emittable.options.parts; ++number)
    emittable.parts.push_back({"_" + std::to_string(number)});
  CallInRuns();
}

/// Neighbours of one file are called by one function, and a chunk stands in the file of the one that it was cut out of.
void Cutter::CallInRuns() {
  std::vector<Chunk>& chunks = emittable.chunks;
  const Chunk* previous = nullptr;
  for (uint32_t index = 0; index < chunks.size(); ++index) {
    const Chunk& chunk = chunks[index];
    if (chunk.parent != Chunk::kNoParent) continue;
    const bool follows = previous != nullptr && previous->region == chunk.region && previous->end == chunk.begin;
    if (chunk.part != 0) {
      if (!follows || chunk.part != previous->part) emittable.runs.push_back({"run_" + chunk.name, chunk.part, {}, {}});
      emittable.runs.back().chunks.push_back(index);
    }
    previous = &chunk;
  }
  for (uint32_t index = static_cast<uint32_t>(chunks.size()); index-- > 0;) {
    if (chunks[index].parent != Chunk::kNoParent) chunks[index].part = chunks[chunks[index].parent].part;
  }
}

}  // namespace

void CutChunks(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.region_chunks.assign(program.regions.size(), {});
  emittable.parts.push_back({});
  Cutter cutter{.emittable = emittable,
                .program = program,
                .statements = std::vector<uint32_t>(program.regions.size()),
                .depth = std::vector<uint32_t>(program.regions.size()),
                .reaches = std::vector<uint32_t>(program.regions.size()),
                .home = std::vector<uint32_t>(program.insts.size()),
                .names = {},
                .prefix = {}};
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
    if (!body.valid()) continue;
    cutter.prefix = emittable.routine_names[i];
    cutter.Visit(body);
  }
  if (emittable.options.parts == 0) cutter.MakeParts();
  if (emittable.options.parts > 1) cutter.MakeFixedParts();
}

}  // namespace plcxx::emit
