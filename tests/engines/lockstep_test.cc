// Engines that ask their host: the first one is answered, the others get the same answers at the same calls, one in
// this process when it asks, and compiled code with the command.
#include "transpiler/engines/lockstep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/scenarios/scenario_fixture.h"
#include "transpiler/engines/compiled_engine.h"

namespace plcxx::engines {
namespace {

using scenarios::OtherEngine;
using scenarios::Replaced;
using testing::ElementsAre;

/// IN is the host's; PORT is what read_port(2) gives, COPY what IN was behind the exchange.
constexpr std::string_view kAsking = R"(
  space M 8 volatile little host_visible
  place IN i8 M[0]
  place PORT i8 M[1]
  place COPY i8 M[2]
  place STARTED i8 M[3]
  place NUMBER f32 M[4]
  host exchange () writes_state routine_exchange
  host read_port (port : i8) -> i8
  routine init init {
    %nine = const i8 9
    %started = host read_port (%nine) exchange
    store STARTED %started
  }
  routine period schedule {
    %in = load IN
    store COPY %in
    host exchange ()
    %two = const i8 2
    %port = host read_port (%two)
    store PORT %port
  }
  schedule init init
  schedule period period
)";

enum class Second { kHere, kCompiled };

std::shared_ptr<CompiledProgram> Compiled(const ir::Program& program) {
  const source::SourceManager sources;
  const PlatformOrFailure platform = MakeHostPlatform(FindCompiler());
  const CompiledOrFailure compiled =
      CompileFor(std::get<std::shared_ptr<const Platform>>(platform), program, sources, emit::Flavour::kRelease);
  if (const auto* failure = std::get_if<CompileFailure>(&compiled)) ADD_FAILURE() << failure->message;
  return std::get<std::shared_ptr<CompiledProgram>>(compiled);
}

std::unique_ptr<sim::Engine> EngineOf(const std::shared_ptr<CompiledProgram>& compiled) {
  return std::get<std::unique_ptr<sim::Engine>>(StartCompiled(compiled));
}

struct Bench {
  ir::Program program;
  ir::Program other;
  std::vector<std::unique_ptr<sim::Engine>> engines;
  std::unique_ptr<Lockstep> lockstep;
  std::vector<std::string> asked;

  explicit Bench(std::string_view text = kAsking, std::string_view first = kAsking, Second second = Second::kHere)
      : program(ir::ReadOrDie(first)), other(ir::ReadOrDie(text)) {
    engines.push_back(std::make_unique<sim::Simulator>(program));
    engines.push_back(second == Second::kHere ? std::make_unique<OtherEngine>(other) : EngineOf(Compiled(other)));
    lockstep = std::make_unique<Lockstep>(program, std::move(engines));
    lockstep->AnswerHostCalls([this](ir::HostFunctionId function, std::span<const uint64_t>) {
      asked.push_back(program.host_functions[function].name);
      if (asked.back() == "exchange") lockstep->Write(program.places[ir::PlaceId(0)], asked.size());
      return sim::HostAnswer{.result = 40 + asked.size(), .out = {}};
    });
  }

  std::string Difference() const { return lockstep->difference() ? lockstep->difference()->what : "none"; }
  uint64_t Get(uint32_t place, size_t engine) {
    return lockstep->engines()[engine]->Read(program.places[ir::PlaceId(place)]);
  }
};

class LockstepOf : public testing::TestWithParam<Second> {};
INSTANTIATE_TEST_SUITE_P(, LockstepOf, testing::Values(Second::kHere, Second::kCompiled),
                         [](const auto& second) { return second.param == Second::kHere ? "Here" : "Compiled"; });

TEST_P(LockstepOf, TheOthersGetTheAnswersOfTheFirst) {
  Bench bench(kAsking, kAsking, GetParam());
  bench.lockstep->PowerOn();
  bench.lockstep->RunPeriod(10);
  bench.lockstep->RunPeriod(20);
  EXPECT_THAT(bench.asked, ElementsAre("read_port", "exchange", "read_port", "exchange", "read_port"));
  EXPECT_EQ(bench.Difference(), "none");
  for (const size_t engine : {0u, 1u}) {
    EXPECT_EQ(bench.Get(0, engine), 4u);
    EXPECT_EQ(bench.Get(1, engine), 45u);
    EXPECT_EQ(bench.Get(2, engine), 2u) << "memory changes behind the call, not before the period";
    EXPECT_EQ(bench.Get(3, engine), 41u);
  }
}

TEST(Lockstep, OneNaNIsAsGoodAsAnother) {
  Bench bench;
  const ir::Place number = bench.program.places[ir::PlaceId(4)];
  bench.lockstep->engines()[0]->Write(number, 0xFFC00000);
  bench.lockstep->engines()[1]->Write(number, 0x7FC00001);
  bench.lockstep->RunPeriod(10);
  EXPECT_EQ(bench.Difference(), "none");
  bench.lockstep->engines()[1]->Write(number, 0x7F800000);
  bench.lockstep->RunPeriod(20);
  EXPECT_EQ(bench.Difference(), "NUMBER");
}

TEST(Lockstep, OneNaNAsAnArgumentIsAsGoodAsAnother) {
  constexpr std::string_view kWeighing = R"(
  space M 8 volatile little host_visible
  place NUMBER f32 M[4]
  host weigh (mass : f32)
  routine init init {
  }
  routine period schedule {
    %number = load NUMBER
    host weigh (%number)
  }
  schedule init init
  schedule period period
)";
  for (const bool answers : {true, false}) {
    Bench bench(kWeighing, kWeighing);
    if (!answers) bench.lockstep->AnswerHostCalls({});
    const ir::Place number = bench.program.places[ir::PlaceId(0)];
    bench.lockstep->engines()[0]->Write(number, 0xFFC00000);
    bench.lockstep->engines()[1]->Write(number, 0x7FC00001);
    bench.lockstep->RunPeriod(10);
    EXPECT_EQ(bench.Difference(), "none") << answers;
    bench.lockstep->engines()[1]->Write(number, 0x7F800000);
    bench.lockstep->RunPeriod(20);
    EXPECT_NE(bench.Difference(), "none") << answers;
  }
}

TEST_P(LockstepOf, CallsThatDifferAreTold) {
  Bench bench(Replaced(kAsking, "%two = const i8 2", "%two = const i8 3"), kAsking, GetParam());
  bench.lockstep->PowerOn();
  EXPECT_EQ(bench.Difference(), "none");
  bench.lockstep->RunPeriod(10);
  ASSERT_EQ(bench.Difference(), "the host calls");
  EXPECT_EQ(bench.lockstep->difference()->first, "simulator: read_port(port: 2)");
  EXPECT_EQ(bench.lockstep->difference()->second, "compiled: read_port(port: 3)");
  EXPECT_EQ(bench.lockstep->difference()->now_ms, 10u);
}

TEST_P(LockstepOf, CallsThatAreMissingOrTooManyAreTold) {
  Bench fewer(Replaced(kAsking, "host exchange ()\n    %two", "%two"), kAsking, GetParam());
  fewer.lockstep->RunPeriod(10);
  EXPECT_EQ(fewer.Difference(), "the host calls");
  EXPECT_EQ(fewer.lockstep->difference()->first, "simulator: exchange()");

  fewer.lockstep->RunPeriod(20);
  EXPECT_EQ(fewer.lockstep->difference()->now_ms, 10u);

  Bench more(Replaced(kAsking, "store PORT %port", "store PORT %port\n    host exchange ()"), kAsking, GetParam());
  more.lockstep->RunPeriod(10);
  more.lockstep->RunPeriod(20);
  EXPECT_EQ(more.Difference(), "the host calls");
  EXPECT_EQ(more.lockstep->difference()->first, "simulator: none");
  EXPECT_EQ(more.lockstep->difference()->second, "compiled: exchange()");
}

// Answers and changes that fill the pipes in both directions, and calls that are more than that.
TEST(Lockstep, ManyCallsInOnePeriodWaitForNobody) {
  constexpr std::string_view kCounting = R"(
  space M 4096 volatile little host_visible
  place LEFT i16 M[0]
  host tell (left : i16)
  routine init init {
  }
  routine period schedule {
    %many = const i16 20000
    store LEFT %many
    loop @1 guard 30000 {
      body {
        %left = load LEFT
        host tell (%left)
        %one = const i16 1
        %next = sub.i16 %left %one
        store LEFT %next
        %zero = const i16 0
        %ends = eq.i16 %next %zero
        exit @1 if %ends
      }
    }
  }
  schedule init init
  schedule period period
)";
  Bench bench(kCounting, kCounting, Second::kCompiled);
  bench.lockstep->AnswerHostCalls([&bench](ir::HostFunctionId, std::span<const uint64_t> arguments) {
    for (uint32_t i = 0; i < 4; ++i) bench.lockstep->Write(bench.program.places[ir::PlaceId(0)], arguments[0]);
    return sim::HostAnswer{};
  });
  bench.lockstep->PowerOn();
  bench.lockstep->RunPeriod(10);
  EXPECT_EQ(bench.Difference(), "none");
}

// More periods than may be open at a time; each asks, and in each the host writes.
TEST(LockstepBehind, WhoFollowsLaterIsToldAndDoesTheSame) {
  Bench bench(kAsking, kAsking, Second::kCompiled);
  bench.lockstep->FollowLater();
  bench.lockstep->PowerOn();
  for (uint32_t period = 1; period <= 300; ++period) bench.lockstep->RunPeriod(10 * period);
  bench.lockstep->CatchUp();
  EXPECT_EQ(bench.Difference(), "none");
  EXPECT_EQ(bench.asked.size(), 601u);
  for (uint32_t place = 0; place < 4; ++place) EXPECT_EQ(bench.Get(place, 0), bench.Get(place, 1)) << place;
}

/// N counts periods; the last value that it has is to be told.
std::string Counting(const std::string& most) {
  return R"(
  space M 2 volatile little host_visible
  space V 4 volatile little host_visible
  place N i8 M[0]
  routine init init {
  }
  routine period schedule {
    %n = load N
    %one = const i8 1
    %next = add.i8 %n %one
    %most = const i8 )" +
         most + R"(
    %is = eq.i8 %n %most
    if %is {
    } else {
      store N %next
    }
  }
  schedule init init
  schedule period period
)";
}

TEST(LockstepBehind, ADifferenceHasTheMomentAtWhichItCame) {
  for (const bool later : {false, true}) {
    Bench bench(Counting("5"), Counting("200"), Second::kCompiled);
    if (later) bench.lockstep->FollowLater();
    bench.lockstep->PowerOn();
    for (uint32_t period = 1; period <= 20; ++period) bench.lockstep->RunPeriod(10 * period);
    bench.lockstep->CatchUp();
    ASSERT_TRUE(bench.lockstep->difference());
    EXPECT_EQ(bench.lockstep->difference()->now_ms, 60u);
    EXPECT_EQ(bench.lockstep->went_on(), later);
  }
}

// What the host writes between periods is no part of the memory of the periods before.
TEST(LockstepBehind, WhatIsWrittenWaitsForThePeriodsBefore) {
  Bench bench(Counting("200"), Counting("200"), Second::kCompiled);
  bench.lockstep->FollowLater();
  bench.lockstep->PowerOn();
  ir::Place unused = bench.program.places[ir::PlaceId(0)];
  unused.space = ir::SpaceId(1);
  for (uint32_t period = 1; period <= 50; ++period) {
    bench.lockstep->RunPeriod(10 * period);
    if (period % 7 == 0) bench.lockstep->Write(unused, period);
    if (period % 9 == 0) bench.lockstep->Write(bench.program.places[ir::PlaceId(0)], period);
  }
  bench.lockstep->CatchUp();
  EXPECT_EQ(bench.Difference(), "none");
  EXPECT_EQ(bench.lockstep->engines()[1]->Read(unused), 49u);
  EXPECT_EQ(bench.Get(0, 1), 50u);
}

TEST(LockstepBehind, CallsThatNobodyExpectedEndInADifference) {
  std::string more(kAsking);
  const std::string exchange = "    host exchange ()\n";
  more.insert(more.find(exchange), exchange);
  for (const auto& [text, first] : {std::pair<std::string, std::string>(more, kAsking), {std::string(kAsking), more}}) {
    Bench bench(text, first, Second::kCompiled);
    bench.lockstep->FollowLater();
    bench.lockstep->PowerOn();
    for (uint32_t period = 1; period <= 5; ++period) bench.lockstep->RunPeriod(10 * period);
    bench.lockstep->CatchUp();
    EXPECT_EQ(bench.Difference(), "the host calls");
    EXPECT_EQ(bench.lockstep->difference()->now_ms, 10u);
  }
}

// A process that has served an engine serves the next one as if it were new.
TEST(Lockstep, TheNextEngineOfAProcessBeginsAnew) {
  const ir::Program program = ir::ReadOrDie(kAsking);
  const auto compiled = Compiled(program);
  for (int run = 0; run < 3; ++run) {
    const auto engine = EngineOf(compiled);
    engine->RunPeriod(10);
    EXPECT_EQ(engine->Read(program.places[ir::PlaceId(1)]), 0u) << "of the engine before";
    EXPECT_EQ(engine->Read(program.places[ir::PlaceId(2)]), 0u) << "of the engine before";
    engine->AnswerHostCalls(
        [](ir::HostFunctionId, std::span<const uint64_t>) { return sim::HostAnswer{.result = 7, .out = {}}; });
    engine->Write(program.places[ir::PlaceId(0)], 5);
    engine->RunPeriod(20);
    EXPECT_EQ(engine->Read(program.places[ir::PlaceId(1)]), 7u);
    EXPECT_EQ(engine->Read(program.places[ir::PlaceId(2)]), 5u);
  }
}

}  // namespace
}  // namespace plcxx::engines
