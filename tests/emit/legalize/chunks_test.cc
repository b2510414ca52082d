// Chunks: bounded, in order, and an inserted statement moves only its own neighbourhood.

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::legalize {
namespace {

/// A slow part of single-coil statements; `numbers` are the coils in order.
ir::Program CoilProgram(const std::vector<uint32_t>& numbers) {
  ir::Program program;
  program.name = "coils";
  const ir::SpaceId space =
      program.spaces.Add({.name = "K", .title = "memory", .bytes = 100'000, .host_visible = true});
  const ir::RegionId body = program.regions.Add({});
  program.routines.Add({.name = "slow", .kind = ir::RoutineKind::kSlow, .body = body});
  ir::Builder builder(program);
  builder.SetRegion(body);
  for (const uint32_t number : numbers) {
    const std::string name = "U" + std::to_string(number);
    const ir::PlaceId place = program.places.Add({.name = name,
                                                  .address = name,
                                                  .type = ir::Type::kBit,
                                                  .space = space,
                                                  .offset = number / 8,
                                                  .bit = static_cast<uint8_t>(number % 8)});
    ir::Statement statement;
    statement.subject = name;
    statement.id = number * 2654435761u >> 3;
    builder.Statement(program.statements.Add(statement));
    builder.Store(place, builder.Load(place));
  }
  return program;
}

std::vector<uint32_t> Sequence(uint32_t count) {
  std::vector<uint32_t> numbers;
  for (uint32_t i = 0; i < count; ++i) numbers.push_back(i);
  return numbers;
}

std::multimap<std::string, int> Lines(const std::vector<OutputFile>& files) {
  std::multimap<std::string, int> lines;
  for (const OutputFile& file : files) {
    for (size_t at = 0; at < file.text.size();) {
      const size_t end = file.text.find('\n', at);
      lines.emplace(file.text.substr(at, end - at), 0);
      at = end + 1;
    }
  }
  return lines;
}

size_t ChangedLines(const std::vector<OutputFile>& before, const std::vector<OutputFile>& after) {
  std::multimap<std::string, int> old_lines = Lines(before);
  size_t changed = 0;
  for (const auto& [line, unused] : Lines(after)) {
    const auto found = old_lines.find(line);
    if (found == old_lines.end()) {
      ++changed;
    } else {
      old_lines.erase(found);
    }
  }
  return changed + old_lines.size();
}

TEST(Chunks, AreBetweenTheLimits) {
  const ir::Program program = CoilProgram(Sequence(2000));
  const Emittable emittable = Legalize(program, {.name = "coils"});
  uint32_t total = 0;
  for (const Chunk& chunk : emittable.chunks) {
    EXPECT_LE(chunk.statements, 100u);
    total += chunk.statements;
  }
  EXPECT_EQ(total, 2000u);
  EXPECT_GE(emittable.chunks.size(), 20u);
  EXPECT_LE(emittable.chunks.size(), 81u);
}

TEST(Chunks, OfOneSubjectAreToldApartByTheirFirstStatement) {
  ir::Program program = CoilProgram(Sequence(300));
  for (ir::Statement& statement : program.statements) statement.subject = "PUMP";
  const Emittable emittable = Legalize(program, {.name = "coils"});
  ASSERT_GT(emittable.chunks.size(), 2u);
  for (size_t i = 0; i < emittable.chunks.size(); ++i) {
    const Chunk& chunk = emittable.chunks[i];
    const ir::Inst& mark = program[program.regions[chunk.region].insts[chunk.begin]];
    char id[16];
    std::snprintf(id, sizeof id, "_%08x", program.statements[ir::StatementId(mark.payload)].id);
    EXPECT_EQ(chunk.name, std::string("slow_PUMP") + (i == 0 ? "" : id));
  }
}

// A statement that was generated many times is one text: what follows it in the name is a number.
TEST(Chunks, OfOneStatementAreToldApartByNumbers) {
  const ir::Program program = CoilProgram(std::vector<uint32_t>(500, 7));
  const Emittable emittable = Legalize(program, {.name = "coils"});
  ASSERT_GT(emittable.chunks.size(), 3u);
  char id[16];
  std::snprintf(id, sizeof id, "_%08x", 7 * 2654435761u >> 3);
  EXPECT_EQ(emittable.chunks[0].name, "slow_U7");
  EXPECT_EQ(emittable.chunks[1].name, std::string("slow_U7") + id);
  EXPECT_EQ(emittable.chunks[2].name, std::string("slow_U7") + id + "_2");
  std::set<std::string> names;
  for (const Chunk& chunk : emittable.chunks) names.insert(chunk.name);
  EXPECT_EQ(names.size(), emittable.chunks.size());
}

// Of one long if the arm is cut out; what is executed otherwise stays readable as a chain where it is no longer than
// that.
TEST(Chunks, TheArmOfALongIfIsAFunctionOfItsOwn) {
  ir::Program program = CoilProgram(Sequence(140));
  const ir::RegionId body = program.routines[ir::RoutineId(0)].body;
  const ir::RegionId then = program.regions.Add({}), otherwise = program.regions.Add({});
  const std::vector<ir::InstId> insts = std::exchange(program.regions[body].insts, {});
  const auto half = insts.begin() + static_cast<std::ptrdiff_t>(insts.size() / 2);
  program.regions[then].insts.assign(insts.begin(), half);
  program.regions[otherwise].insts.assign(half, insts.end());
  ir::Builder builder(program);
  builder.SetRegion(body);
  ir::Statement head;
  head.subject = "HEAD";
  head.id = 77;
  builder.Statement(program.statements.Add(head));
  builder.If(builder.Load(ir::PlaceId(0)), then, otherwise);
  const Emittable emittable = Legalize(program, {.name = "coils"});
  EXPECT_FALSE(emittable.chunks.empty());
  for (const Chunk& chunk : emittable.chunks) EXPECT_EQ(chunk.region, then);
}

TEST(Chunks, AShortProgramIsOneFunction) {
  const ir::Program program = CoilProgram(Sequence(100));
  EXPECT_TRUE(Legalize(program, {.name = "coils"}).chunks.empty());
}

// What leaves the block stays in its function; a few statements between two such places stay with them.
TEST(Chunks, AFewStatementsBetweenTwoExitsAreNoFunction) {
  ir::Program program = CoilProgram(Sequence(130));
  const ir::RegionId body = program.routines[ir::RoutineId(0)].body, inside = program.regions.Add({});
  const std::vector<ir::InstId> coils = std::exchange(program.regions[body].insts, {});
  ir::Builder builder(program);
  builder.SetRegion(body);
  const ir::InstId block = builder.Block(inside);
  builder.SetRegion(inside);
  uint32_t count = 0;
  for (const ir::InstId id : coils) {
    const bool begins = program[id].op == ir::OpKind::kStatement;
    // In front of the 61st and of the 66th statement.
    if (begins && (count == 60 || count == 65)) {
      ir::Statement leaves;
      leaves.subject = "leaves";
      leaves.id = 7 + count;
      builder.Statement(program.statements.Add(leaves));
      builder.Exit(block, builder.Load(ir::PlaceId(count)));
    }
    count += begins ? 1 : 0;
    program.regions[inside].insts.push_back(id);
  }
  uint32_t total = 0;
  const Emittable emittable = Legalize(program, {.name = "coils"});
  for (const Chunk& chunk : emittable.chunks) {
    EXPECT_GE(chunk.statements, 25u) << chunk.name;
    total += chunk.statements;
  }
  EXPECT_EQ(total, 125u);
}

// A way back to the head of a loop stays in the loop's function, alone or in an arm.
TEST(Chunks, AWayBackStaysWithItsLoop) {
  for (const std::string back : {"repeat @1 if %0\n", "if %0 {\nrepeat @1\n}\n"}) {
    std::string text =
        "space m 4 volatile little\nspace r 4 routine little\nplace a bit m[0].0\nplace b bit m[0].1\nplace rounds i32 "
        "r[0]\n"
        "routine slow slow {\nloop @1 budget 9 rounds {\nbody {\n";
    for (uint32_t i = 0; i < 130; ++i) {
      text += "stmt s" + std::to_string(i * 7919 + 1) + "\n%0 = load a\nstore b %0\n";
      if (i == 70) text += back;
    }
    const ir::Program program = ir::ReadOrDie(text + "}\n}\n}\n");
    const Emittable emittable = Legalize(program, {.name = "p"});
    uint32_t total = 0;
    for (const Chunk& chunk : emittable.chunks) {
      total += chunk.statements;
      for (uint32_t i = chunk.begin; i < chunk.end; ++i) {
        const ir::OpKind op = program[program.regions[chunk.region].insts[i]].op;
        EXPECT_TRUE(op != ir::OpKind::kRepeat && op != ir::OpKind::kIf) << back;
      }
    }
    EXPECT_EQ(total, 129u) << back;
  }
}

TEST(Chunks, AnInsertedStatementChangesAtMostTwentyLines) {
  const source::SourceManager sources;
  std::vector<uint32_t> numbers = Sequence(10'000);
  const ir::Program program = CoilProgram(numbers);
  const auto before = print::PrintCpp(Legalize(program, {.name = "coils"}), sources);
  for (const uint32_t at : {0u, 1u, 17u, 2500u, 9'999u}) {
    std::vector<uint32_t> edited = numbers;
    edited.insert(edited.begin() + at, 500'000 + at);
    const ir::Program changed = CoilProgram(edited);
    // The new coil stands in the header as well; what may not happen is that other statements move or change.
    EXPECT_LE(ChangedLines(before, print::PrintCpp(Legalize(changed, {.name = "coils"}), sources)), 20u) << at;
  }
}

TEST(Chunks, LongProgramsAreSeveralFiles) {
  const source::SourceManager sources;
  const ir::Program program = CoilProgram(Sequence(10'000));
  const auto files = print::PrintCpp(Legalize(program, {.name = "coils"}), sources);
  EXPECT_GE(files.size(), 4u);
  EXPECT_LE(files.size(), 14u);
}

// Files begin where the contents say, too: an edit at the beginning leaves the later ones as they are.
TEST(Chunks, AnInsertedStatementMovesTheBorderOfOneFileAtMost) {
  const auto files = [](const std::vector<uint32_t>& numbers) {
    const ir::Program program = CoilProgram(numbers);
    std::set<std::string> suffixes;
    for (const Part& part : Legalize(program, {.name = "coils"}).parts) suffixes.insert(part.suffix);
    return suffixes;
  };
  std::vector<uint32_t> numbers = Sequence(20000);
  const std::set<std::string> before = files(numbers);
  EXPECT_GE(before.size(), 7u);
  for (uint32_t added = 0; added < 40; ++added) numbers.insert(numbers.begin() + 10 + added, 50000 + added);
  size_t moved = 0;
  const std::set<std::string> after = files(numbers);
  for (const std::string& suffix : before) moved += after.contains(suffix) ? 0 : 1;
  EXPECT_LE(moved, 2u);
}

}  // namespace
}  // namespace plcxx::emit::legalize
