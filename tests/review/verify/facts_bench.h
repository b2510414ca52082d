// What the tests of facts (ir/facts.h) share: a program of one language in its checked flavour, one of whose facts can
// be made wrong.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/review/verify/facts.h"
#include "transpiler/scenarios/failure.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::driver {

struct FactsCase {
  const char* dialect;
  const char* file;
  const char* text;
  std::vector<std::string> kinds;  // that are in it
};

struct FactsBench {
  Workplace workplace;
  compilation::Compilation compilation;

  explicit FactsBench(const FactsCase& one) {
    workplace.Write(one.file, one.text);
    compilation::CompilationRequest request;
    request.sources = {workplace.Path(one.file)};
    request.dialect = one.dialect;
    request.options.emplace_back(compilation::kFactsOption, "checked");
    compilation = compilation::Compile(request);
    EXPECT_TRUE(compilation.ok()) << one.dialect << " " << compilation.diagnostics.all().size();
  }

  ir::Program& program() { return compilation.program; }

  std::string KindOf(ir::InstId call) {
    const ir::ValueId kind = program().calls[ir::CallId(program()[call].payload)].arguments.front();
    return std::string(ir::FactNames()[ir::ConstantValue(program()[kind])]);
  }
  std::vector<ir::InstId> Facts() {
    std::vector<ir::InstId> facts;
    for (const ir::Routine& routine : program().routines) {
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
        ir::ForEachInst(program(), region, [&](ir::InstId id) {
          if (ir::IsFalseFact(program(), program()[id])) facts.push_back(id);
        });
      }
    }
    return facts;
  }

  /// Makes the fact false where it was true, as a wrong decision would be: its condition turned, or a loop that is said
  /// to end sooner.
  void Break(ir::InstId call) {
    const auto owns = [&](const ir::Region& region) {
      return std::ranges::find(region.insts, call) != region.insts.end();
    };
    ir::RegionId region;
    for (uint32_t i = 0; i < program().regions.size(); ++i) {
      if (owns(program().regions[ir::RegionId(i)])) region = ir::RegionId(i);
    }
    for (ir::Loop& loop : program().loops) {
      if (loop.exhausted == region) loop.bound = 1;
    }
    for (ir::Inst& inst : program().insts) {
      if (inst.op != ir::OpKind::kIf || inst.b != region.index) continue;
      ir::Inst& wrong = program()[ir::ValueId(inst.a)];
      ASSERT_EQ(wrong.op, ir::OpKind::kBitNot);
      wrong.op = ir::OpKind::kBitAnd;
      wrong.b = wrong.a;
    }
  }

  /// What the first period says in which a fact does not hold; empty: all hold.
  std::string Execute() {
    std::vector<std::unique_ptr<sim::Engine>> engines;
    engines.push_back(std::make_unique<sim::Simulator>(program()));
    engines::Lockstep lockstep(program(), std::move(engines));
    sim::Clock clock(program(), {&lockstep});
    clock.PowerOn();
    clock.RunMs(200);
    if (!lockstep.false_fact()) return {};
    return scenarios::FalseFactText(*lockstep.false_fact(), program(), *compilation.sources);
  }
};

/// Executed and proved.
inline void ExpectHold(const FactsCase& one) {
  FactsBench bench(one);
  std::set<std::string> kinds;
  for (const ir::InstId fact : bench.Facts()) kinds.insert(bench.KindOf(fact));
  EXPECT_THAT(kinds, ::testing::IsSupersetOf(one.kinds)) << one.dialect;
  EXPECT_EQ(bench.Execute(), "") << one.dialect;
  const review::verify::FactsReport report = review::verify::VerifyFactsOf(bench.compilation, {}, {});
  EXPECT_TRUE(report.all_proved()) << one.dialect << "\n" << report.Text();
  EXPECT_GE(report.findings.size(), one.kinds.size());
}

/// One of each kind made wrong.
inline void ExpectFalseOnesAreFound(const FactsCase& one) {
  for (const std::string& kind : one.kinds) {
    FactsBench bench(one);
    const std::vector<ir::InstId> facts = bench.Facts();
    const auto fact = std::ranges::find(facts, kind, [&](ir::InstId id) { return bench.KindOf(id); });
    ASSERT_NE(fact, facts.end()) << one.dialect << " " << kind;
    bench.Break(*fact);
    // What the control's schedule does step by step is for those who know the time: simulations go another way.
    const bool is_executed = kind != "LOOP" || std::string(one.dialect) == "hnc";
    if (is_executed) {
      const std::string said = bench.Execute();
      EXPECT_THAT(said, ::testing::HasSubstr("does not hold: " + kind)) << one.dialect;
      EXPECT_THAT(said, ::testing::HasSubstr(std::string(one.file) + ":")) << one.dialect;
    }
    const review::verify::FactsReport report = review::verify::VerifyFactsOf(bench.compilation, {}, {});
    EXPECT_GE(report.CountOf(prove::verify::facts::FactResult::kViolated), 1U) << one.dialect << " " << kind << "\n"
                                                                               << report.Text();
    EXPECT_THAT(report.Text(), ::testing::HasSubstr(kind + ": does not hold of the value ")) << one.dialect;
  }
}

/// What is not asked for is not there.
inline void ExpectOnlyWhereAskedFor(const FactsCase& one) {
  const Workplace workplace;
  workplace.Write(one.file, one.text);
  const std::string arguments = std::string(one.file) + " --dialect " + one.dialect;
  EXPECT_EQ(workplace.Run("print cpp " + arguments).out.find("false_fact"), std::string::npos) << one.dialect;
  EXPECT_NE(workplace.Run("print cpp " + arguments + " --set facts=checked").out.find("false_fact"), std::string::npos)
      << one.dialect;
}

}  // namespace plcxx::driver
