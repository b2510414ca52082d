// Which function each statement is in, and in which file that is.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/passes/random_jumps.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/builder.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::emit::legalize {
namespace {

/// Subroutines and parts of so many groups of statements each.
ir::Program WithGroups(const std::vector<std::pair<std::string, uint32_t>>& routines) {
  std::mt19937 random(1789);
  std::string text;
  uint32_t first = 0;
  for (const auto& [head, groups] : routines) {
    text += "routine " + head + " {\n";
    for (uint32_t i = 0; i < groups; ++i, first += 10) {
      text += passes::RandomBody(random, 1 + static_cast<uint32_t>(random() % 8), passes::Ways::kBoth, first);
    }
    if (head.starts_with("slow") || head.starts_with("outer"))
      text += "stmt s" + std::to_string(first + 9) + "\ncall inner ()\n";
    if (head.starts_with("fast")) text += "stmt s" + std::to_string(first + 9) + "\ncall outer ()\n";
    text += "}\n";
  }
  ir::Program program = passes::ReadRoutines(text);
  passes::Structure(program);
  passes::NestBlocks(program);
  passes::Optimize(program);
  return program;
}

uint32_t StatementsIn(const ir::Program& program, ir::RegionId region, uint32_t begin, uint32_t end) {
  uint32_t count = 0;
  for (uint32_t i = begin; i < end; ++i) {
    const ir::Inst& inst = program[program.regions[region].insts[i]];
    count += inst.op == ir::OpKind::kStatement ? 1 : 0;
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
      count += StatementsIn(program, owned, 0, static_cast<uint32_t>(program.regions[owned].insts.size()));
    }
  }
  return count;
}

/// All instructions of a list, nested ones included.
std::set<uint32_t> Within(const ir::Program& program, ir::RegionId region, uint32_t begin, uint32_t end) {
  std::set<uint32_t> all;
  for (uint32_t i = begin; i < end; ++i) {
    const ir::InstId id = program.regions[region].insts[i];
    all.insert(id.index);
    for (const ir::RegionId owned : ir::OwnedRegions(program, program[id])) {
      ir::ForEachInst(program, owned, [&all](ir::InstId inner) { all.insert(inner.index); });
    }
  }
  return all;
}

std::set<uint32_t> Within(const ir::Program& program, const Chunk& chunk) {
  return Within(program, chunk.region, chunk.begin, chunk.end);
}

TEST(Functions, NeedNothingOfWhatIsAroundThem) {
  const ir::Program program =
      WithGroups({{"inner subroutine", 40}, {"outer subroutine", 3}, {"slow slow", 60}, {"fast fast", 2}});
  const Emittable emittable = Legalize(program, {.name = "p"});
  ASSERT_GT(emittable.chunks.size(), 4u);
  std::set<std::string> names;
  for (uint32_t k = 0; k < emittable.chunks.size(); ++k) {
    const Chunk& chunk = emittable.chunks[k];
    EXPECT_TRUE(names.insert(chunk.name).second) << chunk.name;
    EXPECT_LT(chunk.begin, chunk.end);
    EXPECT_LE(chunk.statements, 125u) << chunk.name;
    const std::set<uint32_t> inside = Within(program, chunk);
    for (const uint32_t index : inside) {
      const ir::Inst& inst = program[ir::InstId(index)];
      if (inst.op == ir::OpKind::kExit || inst.op == ir::OpKind::kRepeat) {
        EXPECT_TRUE(inside.contains(inst.payload)) << chunk.name;
      }
      for (const ir::ValueId value : ir::UsedValues(program, inst))
        EXPECT_TRUE(inside.contains(value.index)) << chunk.name;
    }
    // Cut out of the function that calls it, which comes behind it.
    for (uint32_t other = 0; other < emittable.chunks.size(); ++other) {
      if (other == k) continue;
      const std::set<uint32_t> around = Within(program, emittable.chunks[other]);
      const bool is_inside = std::ranges::includes(around, inside);
      if (chunk.parent == other) {
        EXPECT_TRUE(is_inside && other > k) << chunk.name;
      }
      if (is_inside) {
        EXPECT_NE(chunk.parent, Chunk::kNoParent) << chunk.name;
      }
      if (!is_inside && !std::ranges::includes(inside, around)) {
        for (const uint32_t index : inside) EXPECT_FALSE(around.contains(index)) << chunk.name;
      }
    }
  }
  for (uint32_t r = 0; r < program.regions.size(); ++r) {
    uint32_t behind = 0;
    for (const uint32_t chunk : emittable.region_chunks[r]) {
      EXPECT_EQ(emittable.chunks[chunk].region.index, r);
      EXPECT_GE(emittable.chunks[chunk].begin, behind);
      behind = emittable.chunks[chunk].end;
    }
  }
}

/// So many statements are in each file.
std::vector<uint32_t> StatementsOfParts(const ir::Program& program, const Emittable& emittable) {
  std::vector<uint32_t> statements(emittable.parts.size());
  for (const Chunk& chunk : emittable.chunks) {
    if (chunk.parent != Chunk::kNoParent || program.routines[chunk.routine].kind == ir::RoutineKind::kSubroutine)
      continue;
    statements[chunk.part] += StatementsIn(program, chunk.region, chunk.begin, chunk.end);
  }
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (routine.kind != ir::RoutineKind::kSubroutine) continue;
    statements[emittable.routine_parts[i]] +=
        StatementsIn(program, routine.body, 0, static_cast<uint32_t>(program.regions[routine.body].insts.size()));
  }
  return statements;
}

void CheckParts(const ir::Program& program, const Emittable& emittable) {
  std::vector<uint32_t> runs_of(emittable.chunks.size());
  for (const ChunkRun& run : emittable.runs) {
    ASSERT_FALSE(run.chunks.empty());
    EXPECT_NE(run.part, 0u) << run.name;
    EXPECT_EQ(run.name, "run_" + emittable.chunks[run.chunks.front()].name);
    for (size_t i = 0; i < run.chunks.size(); ++i) {
      const Chunk& chunk = emittable.chunks[run.chunks[i]];
      ++runs_of[run.chunks[i]];
      EXPECT_EQ(chunk.part, run.part) << run.name;
      if (i == 0) continue;
      const Chunk& before = emittable.chunks[run.chunks[i - 1]];
      EXPECT_TRUE(before.region == chunk.region && before.end == chunk.begin) << run.name;
    }
  }
  for (uint32_t k = 0; k < emittable.chunks.size(); ++k) {
    const Chunk& chunk = emittable.chunks[k];
    ASSERT_LT(chunk.part, emittable.parts.size());
    const bool of_subroutine = program.routines[chunk.routine].kind == ir::RoutineKind::kSubroutine;
    if (of_subroutine) {
      EXPECT_EQ(chunk.part, emittable.routine_parts[chunk.routine.index]) << chunk.name;
    }
    if (chunk.parent != Chunk::kNoParent) {
      EXPECT_EQ(chunk.part, emittable.chunks[chunk.parent].part) << chunk.name;
    }
    const bool called_from_elsewhere = chunk.part != 0 && !of_subroutine && chunk.parent == Chunk::kNoParent;
    EXPECT_EQ(runs_of[k], called_from_elsewhere ? 1u : 0u) << chunk.name;
  }
  // Each file declares the subroutines that its functions call, and no others.
  std::vector<std::vector<bool>> calls(emittable.parts.size(), std::vector<bool>(program.routines.size()));
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RegionId body = program.routines[ir::RoutineId(i)].body;
    const std::set<uint32_t> all = Within(program, body, 0, static_cast<uint32_t>(program.regions[body].insts.size()));
    for (const uint32_t index : all) {
      const ir::Inst& inst = program[ir::InstId(index)];
      if (inst.op != ir::OpKind::kCall) continue;
      uint32_t part = emittable.routine_parts[i];
      for (const Chunk& chunk : emittable.chunks) {
        if (Within(program, chunk).contains(index)) part = chunk.part;
      }
      calls[part][program.calls[ir::CallId(inst.payload)].routine.index] = true;
    }
  }
  for (size_t part = 0; part < calls.size(); ++part) EXPECT_EQ(emittable.parts[part].called, calls[part]) << part;
}

TEST(Parts, OfLongProgramsAreFilesOfAboutOneSize) {
  const ir::Program program =
      WithGroups({{"inner subroutine", 450}, {"outer subroutine", 3}, {"slow slow", 900}, {"fast fast", 300}});
  const Emittable emittable = Legalize(program, {.name = "p"});
  CheckParts(program, emittable);
  const std::vector<uint32_t> statements = StatementsOfParts(program, emittable);
  ASSERT_GT(statements.size(), 2u);
  EXPECT_EQ(statements[0], 0u) << "what schedules is in the first file";
  for (size_t part = 1; part < statements.size(); ++part) {
    EXPECT_GE(statements[part], 750u) << emittable.parts[part].suffix;
    EXPECT_LE(statements[part], 3100u) << emittable.parts[part].suffix;
  }
}

TEST(Parts, AProgramOfThreeThousandStatementsIsOneFile) {
  const ir::Program program =
      WithGroups({{"inner subroutine", 3}, {"outer subroutine", 3}, {"slow slow", 400}, {"fast fast", 100}});
  EXPECT_EQ(Legalize(program, {.name = "p"}).parts.size(), 1u);
  const ir::Program of_a_subroutine =
      WithGroups({{"inner subroutine", 400}, {"outer subroutine", 3}, {"slow slow", 3}, {"fast fast", 100}});
  EXPECT_EQ(Legalize(of_a_subroutine, {.name = "p"}).parts.size(), 1u);
}

TEST(Parts, AreAsManyAsWereAskedFor) {
  const ir::Program program =
      WithGroups({{"inner subroutine", 60}, {"outer subroutine", 3}, {"slow slow", 200}, {"fast fast", 60}});
  for (const uint32_t parts : {1u, 2u, 3u, 5u}) {
    const Emittable emittable = Legalize(program, {.name = "p", .parts = parts});
    ASSERT_EQ(emittable.parts.size(), parts);
    CheckParts(program, emittable);
    const std::vector<uint32_t> statements = StatementsOfParts(program, emittable);
    uint32_t all = 0;
    for (const uint32_t count : statements) all += count;
    for (uint32_t part = 0; part < parts; ++part) {
      EXPECT_GE(statements[part], all / (3 * parts)) << part << " of " << parts;
      if (part > 0) {
        EXPECT_EQ(emittable.parts[part].suffix, "_" + std::to_string(part + 1));
      }
    }
  }
}

}  // namespace
}  // namespace plcxx::emit::legalize
