// Where break, continue, return and goto of the generated C++ lead: random programs, executed as their regions say and
// as C++ executes what was chosen for them, functions cut out of long lists included.

#include <gtest/gtest.h>

#include <random>

#include "tests/passes/random_jumps.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::emit::legalize {
namespace {

/// Executes the text of one function as C++ does.
struct CppFollower {
  enum class Going : uint8_t { kOn, kBreak, kContinue, kReturn, kGoto };

  const Emittable& emittable;
  passes::Follower& state;  // what was stored, read and used up of the budget
  ir::RegionId cut_from = {};
  ir::InstId target = {};  // of a goto
  bool again = false;      // it leads to the head of that loop
  uint32_t rounds = 0;     // a loop that nothing ends is a failure

  const ir::Program& program() const { return *emittable.program; }

  Going Region(ir::RegionId region) {
    if (!region.valid()) return Going::kOn;
    return Range(region, 0, static_cast<uint32_t>(program().regions[region].insts.size()));
  }

  Going Range(ir::RegionId region, uint32_t begin, uint32_t end) {
    const std::vector<uint32_t>& chunks = emittable.region_chunks[region.index];
    for (uint32_t i = begin; i < end; ++i) {
      const auto called = std::ranges::find_if(
          chunks, [&](uint32_t chunk) { return emittable.chunks[chunk].begin == i && region != cut_from; });
      if (called != chunks.end()) {
        const Chunk& chunk = emittable.chunks[*called];
        CppFollower function{.emittable = emittable, .state = state, .cut_from = region};
        const Going left = function.Range(region, chunk.begin, chunk.end);
        EXPECT_TRUE(left == Going::kOn || left == Going::kReturn) << "leaves the function of another one";
        i = chunk.end - 1;
        continue;
      }
      const Going going = Inst(program().regions[region].insts[i]);
      if (going != Going::kOn) return going;
    }
    return Going::kOn;
  }

  Going Leave(ir::InstId id, ir::InstId leads_to, bool to_head) {
    switch (emittable.leaves.at(id.index)) {
      case emit::Leave::kFallsThrough:
        return Going::kOn;
      case emit::Leave::kReturn:
        return Going::kReturn;
      case emit::Leave::kBreak:
        return Going::kBreak;
      case emit::Leave::kContinue:
        return Going::kContinue;
      case emit::Leave::kGoto: {
        const Landing& landing = emittable.landings.at(leads_to.index);
        EXPECT_FALSE((to_head ? landing.again : landing.behind).empty()) << "no label";
        target = leads_to;
        again = to_head;
        return Going::kGoto;
      }
    }
    return Going::kOn;
  }

  Going Inst(ir::InstId id) {
    const ir::Inst& inst = program()[id];
    const bool condition = !ir::ValueId(inst.a).valid() || inst.a >= state.values.size() || state.values[inst.a] != 0;
    switch (inst.op) {
      case ir::OpKind::kExit:
        return condition ? Leave(id, ir::InstId(inst.payload), false) : Going::kOn;
      case ir::OpKind::kRepeat:
        if (!condition) return Going::kOn;
        if (state.rounds > 0) {
          --state.rounds;
          return Leave(id, ir::InstId(inst.payload), true);
        }
        return Region(ir::RegionId(inst.b));
      case ir::OpKind::kIf:
        return Region(ir::RegionId(condition ? inst.b : inst.c));
      case ir::OpKind::kSwitch:
        return Choose(inst);
      case ir::OpKind::kBlock:
        return Behind(id, Region(ir::RegionId(inst.a)));
      case ir::OpKind::kLoop:
        return Behind(id, Loop(id));
      default:
        state.Inst(id);
        return Going::kOn;
    }
  }

  /// A label behind a block or loop.
  Going Behind(ir::InstId id, Going going) const {
    return going == Going::kGoto && target == id && !again ? Going::kOn : going;
  }

  Going Loop(ir::InstId id) {
    const ir::Loop& loop = program().loops[ir::LoopId(program()[id].payload)];
    const Landing& landing = emittable.landings.at(id.index);
    for (uint64_t done = 0;; ++done) {
      if (++rounds > 1000) {
        ADD_FAILURE() << "nothing ends it";
        return Going::kReturn;
      }
      if (loop.condition.valid() && !state.Holds(loop.condition)) return Going::kOn;
      if (loop.kind != ir::LoopBound::kBudget && done == loop.bound) {
        const Going going = Region(loop.exhausted);
        return going == Going::kBreak ? Going::kOn : going;
      }
      const Going going = Region(loop.body);
      if (going == Going::kBreak) return Going::kOn;
      const bool at_head = going == Going::kGoto && target == id && again;
      if (going == Going::kReturn || (going == Going::kGoto && !at_head)) return going;
      if (going == Going::kOn && landing.ends_with_break) return Going::kOn;
      if (loop.step.valid()) Region(loop.step);
    }
  }

  Going Choose(const ir::Inst& inst) {
    const ir::Switch& choice = program().switches[ir::SwitchId(inst.payload)];
    const std::vector<ArmEnd>& ends = emittable.arm_ends[inst.payload];
    size_t chosen = choice.cases.size();
    for (size_t i = 0; i < choice.cases.size(); ++i) {
      if (choice.cases[i].values.empty()) chosen = i;
    }
    for (size_t i = 0; i < choice.cases.size(); ++i) {
      const std::vector<uint64_t>& values = choice.cases[i].values;
      if (std::ranges::find(values, state.values[inst.a]) != values.end()) chosen = i;
    }
    for (; chosen < choice.cases.size(); ++chosen) {
      const Going going = Region(choice.cases[chosen].region);
      if (going == Going::kBreak) return Going::kOn;
      if (going != Going::kOn) return going;
      if (ends[chosen] == ArmEnd::kBreak) return Going::kOn;
    }
    return Going::kOn;
  }
};

std::vector<uint32_t> CppTrace(const Emittable& emittable, uint32_t inputs) {
  passes::Follower state = passes::Begin(*emittable.program, inputs);
  CppFollower cpp{.emittable = emittable, .state = state};
  const CppFollower::Going left = cpp.Region(emittable.program->routines[ir::RoutineId(0)].body);
  EXPECT_TRUE(left == CppFollower::Going::kOn || left == CppFollower::Going::kReturn);
  return state.trace;
}

ir::Program Compiled(const std::string& body) {
  ir::Program program = passes::ReadFast(body);
  passes::Structure(program);
  passes::NestBlocks(program);
  passes::Optimize(program);
  return program;
}

/// Returns how many functions were cut out.
size_t ExpectSameTraces(const std::string& body) {
  const ir::Program program = Compiled(body);
  const Emittable emittable = Legalize(program, {.name = "p"});
  for (uint32_t inputs = 0; inputs < 10 && !testing::Test::HasFailure(); ++inputs) {
    EXPECT_EQ(passes::Trace(program, inputs), CppTrace(emittable, inputs)) << body << ir::Print(program);
  }
  return emittable.chunks.size();
}

passes::Ways EitherWay(uint32_t round) { return round % 3 == 0 ? passes::Ways::kForward : passes::Ways::kBoth; }

TEST(Leaves, LeadWhereTheRegionsSay) {
  std::mt19937 random(1848);
  for (uint32_t round = 0; round < 600 && !HasFailure(); ++round) {
    const uint32_t count = 1 + round % 14;
    const std::string entry = passes::RandomEntry(random, count);
    ExpectSameTraces(entry + passes::RandomBody(random, count, EitherWay(round)));
  }
}

/// Groups of statements that jump among themselves, one behind the other.
std::string Groups(std::mt19937& random, uint32_t groups, uint32_t round, uint32_t first) {
  std::string body;
  for (uint32_t i = 0; i < groups; ++i) {
    body += passes::RandomBody(random, 1 + static_cast<uint32_t>(random() % 8), EitherWay(round + i), first + 10 * i);
  }
  return body;
}

TEST(Leaves, AlsoInFunctionsThatWereCutOut) {
  std::mt19937 random(1871);
  size_t functions = 0;
  for (uint32_t round = 0; round < 40 && !HasFailure(); ++round)
    functions += ExpectSameTraces(Groups(random, 28 + round, round, 0));
  EXPECT_GT(functions, 80u);
}

TEST(Leaves, AlsoInFunctionsThatWereCutOutOfArms) {
  std::mt19937 random(1905);
  size_t functions = 0;
  for (uint32_t round = 0; round < 40 && !HasFailure(); ++round) {
    const std::string before = Groups(random, 4 + round % 20, round, 0), inner = Groups(random, 8 + round, round, 1000);
    const std::string open[] = {"%40 = load b\nif %40 {\n", "%40 = load b\nif %40 {\n} else {\n",
                                "loop @5 guard 2 {\nbody {\n",
                                "%40 = load slice\nswitch %40 {\ncase 1 {\n}\ndefault {\n"};
    functions += ExpectSameTraces(before + "stmt s2001\n" + open[round % 4] + inner +
                                  (round % 4 < 2 ? "}\n" : "}\n}\n") + "stmt s2002\n%41 = load a\nstore b %41\n");
  }
  EXPECT_GT(functions, 80u);
}

}  // namespace
}  // namespace plcxx::emit::legalize
