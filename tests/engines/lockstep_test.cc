// Engines that ask their host: the first one is answered, the others get the same answers at the same calls.
#include "transpiler/engines/lockstep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/scenarios/scenario_fixture.h"

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

struct Bench {
  ir::Program program;
  ir::Program other;
  std::vector<std::unique_ptr<sim::Engine>> engines;
  std::unique_ptr<Lockstep> lockstep;
  std::vector<std::string> asked;

  explicit Bench(std::string_view text = kAsking, std::string_view first = kAsking)
      : program(ir::ReadOrDie(first)), other(ir::ReadOrDie(text)) {
    engines.push_back(std::make_unique<sim::Simulator>(program));
    engines.push_back(std::make_unique<OtherEngine>(other));
    lockstep = std::make_unique<Lockstep>(program, std::move(engines));
    lockstep->AnswerHostCalls([this](ir::HostFunctionId function, std::span<const uint64_t>) {
      asked.push_back(program.host_functions[function].name);
      if (asked.back() == "exchange") lockstep->Write(program.places[ir::PlaceId(0)], asked.size());
      return sim::HostAnswer{.result = 40 + asked.size(), .out = {}};
    });
  }

  std::string Difference() const { return lockstep->difference() ? lockstep->difference()->what : "none"; }
  uint64_t Get(uint32_t place, size_t engine) const {
    return lockstep->engines()[engine]->Read(program.places[ir::PlaceId(place)]);
  }
};

TEST(Lockstep, TheOthersGetTheAnswersOfTheFirst) {
  Bench bench;
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

TEST(Lockstep, CallsThatDifferAreTold) {
  Bench bench(Replaced(kAsking, "%two = const i8 2", "%two = const i8 3"));
  bench.lockstep->PowerOn();
  EXPECT_EQ(bench.Difference(), "none");
  bench.lockstep->RunPeriod(10);
  ASSERT_EQ(bench.Difference(), "the host calls");
  EXPECT_EQ(bench.lockstep->difference()->first, "simulator: read_port(port: 2)");
  EXPECT_EQ(bench.lockstep->difference()->second, "compiled: read_port(port: 3)");
  EXPECT_EQ(bench.lockstep->difference()->now_ms, 10u);
}

TEST(Lockstep, CallsThatAreMissingOrTooManyAreTold) {
  Bench fewer(Replaced(kAsking, "host exchange ()\n    %two", "%two"));
  fewer.lockstep->RunPeriod(10);
  EXPECT_EQ(fewer.Difference(), "the host calls");
  EXPECT_EQ(fewer.lockstep->difference()->first, "simulator: exchange()");

  Bench more(Replaced(kAsking, "store PORT %port", "store PORT %port\n    host exchange ()"));
  more.lockstep->RunPeriod(10);
  EXPECT_EQ(more.Difference(), "the host calls");
  EXPECT_EQ(more.lockstep->difference()->first, "simulator: none");
  EXPECT_EQ(more.lockstep->difference()->second, "compiled: exchange()");
}

}  // namespace
}  // namespace plcxx::engines
