// Cuts long regions into functions of 25 to 100 statements, and long programs into several files.
//
//   slow: s1 ... s900   ->   slow: slow_U4A8(m, host); slow_T5(m, host); ...
//
// A border lies behind a statement whose own text says so (its id, a hash of the text), so that inserting a statement
// moves no other border. Values never cross a statement, so any statement's end can be a border.

#include <algorithm>
#include <unordered_set>

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

struct Cutter {
  Emittable& emittable;
  const ir::Program& program;
  std::vector<uint32_t> statements;  // by RegionId, nested ones included
  std::unordered_set<std::string> names;
  std::string prefix;

  uint32_t CountStatements(ir::RegionId region);
  uint32_t StatementsOf(ir::RegionId region, const ir::Item& item) const;
  void VisitNested(ir::RegionId region, const ir::Item& item);
  void Visit(ir::RegionId region);
  void Cut(ir::RegionId region);
  void AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last, uint32_t count);
  void MakeParts();
};

uint32_t Cutter::CountStatements(ir::RegionId region) {
  uint32_t count = 0;
  for (const ir::InstId id : program.regions[region].insts) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kStatement) ++count;
    if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) count += CountStatements(owned);
  }
  statements[region.index] = count;
  return count;
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
  uint32_t count = 0;
  for (size_t i = 0; i < items.size(); ++i) {
    const uint32_t own = StatementsOf(region, items[i]);
    if (own > kMostStatements) VisitNested(region, items[i]);
    count += own;
    const bool border = items[i].statement.valid() && program.statements[items[i].statement].id % kBorderEvery == 0;
    if (i + 1 == items.size() || count >= kMostStatements || (border && count >= kLeastStatements)) {
      AddChunk(region, items, first, i, count);
      first = i + 1;
      count = 0;
    }
  }
}

void Cutter::AddChunk(ir::RegionId region, const std::vector<ir::Item>& items, size_t first, size_t last,
                      uint32_t count) {
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
  emittable.region_chunks[region.index].push_back(static_cast<uint32_t>(emittable.chunks.size()));
  emittable.chunks.push_back({name, region, items[first].begin, items[last].end, 0, count, false});
}

void Cutter::MakeParts() {
  uint32_t total = 0;
  for (const Chunk& chunk : emittable.chunks) total += chunk.top_level ? chunk.statements : 0;
  if (total <= kOneFile) return;
  uint32_t in_part = 0;
  uint32_t next = 0;  // first chunk, nested ones included, that has no part yet
  ir::RegionId region;
  for (uint32_t index = 0; index < emittable.chunks.size(); ++index) {
    const Chunk& chunk = emittable.chunks[index];
    if (!chunk.top_level) continue;
    if (in_part == 0 || chunk.region != region) {
      emittable.parts.push_back({"_" + chunk.name, "run_" + chunk.name});
      in_part = 0;
      region = chunk.region;
    }
    // The chunks cut out of this one stand before it and go into its file.
    for (; next <= index; ++next) emittable.chunks[next].part = static_cast<uint32_t>(emittable.parts.size() - 1);
    in_part += chunk.statements;
    uint32_t id = 0;
    for (const char c : chunk.name) id = id * 31 + static_cast<unsigned char>(c);
    if (in_part >= kMostPerPart || (in_part >= kLeastPerPart && id % kPartBorderEvery == 0)) in_part = 0;
  }
}

}  // namespace

void CutChunks(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.region_chunks.assign(program.regions.size(), {});
  emittable.parts.push_back({});
  Cutter cutter{emittable, program, std::vector<uint32_t>(program.regions.size(), 0), {}, {}};
  for (const std::string& name : emittable.place_names) cutter.names.insert(name);
  for (const std::string& name : emittable.state_names) cutter.names.insert(name);
  for (const ir::Routine& routine : program.routines) {
    cutter.names.insert(routine.name);
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) cutter.CountStatements(region);
    }
  }
  for (const ir::Routine& routine : program.routines) {
    if (!routine.body.valid()) continue;
    cutter.prefix = routine.name;
    const size_t first = emittable.chunks.size();
    cutter.Visit(routine.body);
    // Top-level chunks are those of the body, or of the pieces of a sliced body.
    std::vector<ir::RegionId> tops = {routine.body};
    for (const ir::InstId id : program.regions[routine.body].insts) {
      if (program[id].op != ir::OpKind::kSwitch) continue;
      for (const ir::RegionId arm : ir::OwnedRegions(program, program[id])) tops.push_back(arm);
    }
    for (size_t i = first; i < emittable.chunks.size(); ++i) {
      if (std::find(tops.begin(), tops.end(), emittable.chunks[i].region) != tops.end()) {
        emittable.chunks[i].top_level = true;
      }
    }
  }
  cutter.MakeParts();
}

}  // namespace plcxx::emit
