#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/live/live_fixture.h"
#include "tests/temporary_directory.h"
#include "transpiler/live/commands.h"
#include "transpiler/live/guard.h"
#include "transpiler/live/opened.h"
#include "transpiler/live/program_view.h"
#include "transpiler/live/recording.h"
#include "transpiler/live/state_view.h"

namespace plcxx::live {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Recording, WhatWasDoneIsAScenarioThatPasses) {
  LiveBench bench;
  bench.Periods(2);
  Set(*bench.session, "I0A3", "1");
  Set(*bench.session, "I0A5", "1");
  bench.Periods(3);
  Force(*bench.session, "U4A8", "1");
  bench.Periods(1);
  Release(*bench.session, "U4A8");
  EXPECT_EQ(Expect(*bench.session, {"U4A8", "U4A9", "W3K0"}), "");
  bench.session->PowerOff();
  bench.session->PowerOn();  // what was set is forgotten, as in any scenario
  bench.Periods(1);
  EXPECT_EQ(Expect(*bench.session, {"U4A8"}), "");
  const Recording recording =
      CheckedRecording(bench.compilation, bench.request, bench.session->timeline(), "", "recorded.yaml");
  EXPECT_EQ(recording.refusal, "");
  EXPECT_THAT(recording.yaml, HasSubstr("steps:\n"
                                        "- run: {ms: 20}\n"
                                        "- set: {I0A3: 1, I0A5: 1}\n"
                                        "- run: {ms: 30}\n"
                                        "- force: {U4A8: 1}\n"
                                        "- run: {ms: 10}\n"
                                        "- release: [U4A8]\n"
                                        "- expect: {U4A8: 1, U4A9: 0, W3K0: 6}\n"
                                        "- power_cycle: {}\n"
                                        "- run: {ms: 10}\n"
                                        "- expect: {U4A8: 0}\n"));
}

TEST(Recording, EndsAtThePresentAndSaysWhatItCannot) {
  LiveBench bench;
  EXPECT_THAT(WriteRecording(bench.compilation, bench.request, bench.session->timeline(), "").refusal,
              HasSubstr("nothing has been done"));
  Set(*bench.session, "I0A3", "1");
  bench.Periods(5);
  Set(*bench.session, "I0A3", "0");
  bench.Periods(5);
  bench.session->Back(7);
  const Recording early = WriteRecording(bench.compilation, bench.request, bench.session->timeline(), "");
  EXPECT_THAT(early.yaml, HasSubstr("steps:\n- set: {I0A3: 1}\n- run: {ms: 30}\n"));
  EXPECT_THAT(early.yaml, testing::Not(HasSubstr("I0A3: 0")));
  bench.session->Step(StepKind::kStatement);
  EXPECT_THAT(WriteRecording(bench.compilation, bench.request, bench.session->timeline(), "").refusal,
              HasSubstr("half done"));
  SwitchStatement(*bench.session, bench.Statement("U4A8"), false);
  EXPECT_THAT(WriteRecording(bench.compilation, bench.request, bench.session->timeline(), "").refusal,
              HasSubstr("switched off"));
}

TEST(Recording, NamesOfFilesStayInTheFolder) {
  EXPECT_TRUE(IsScenarioName("tool-change_2.yaml"));
  for (const char* name :
       {"", ".yaml", "../x.yaml", "a/b.yaml", "x.yml", "x.yaml ", "-x.yaml", "a b.yaml", "x\n.yaml"}) {
    EXPECT_FALSE(IsScenarioName(name)) << name;
  }
}

Opened Open(LiveBench& bench, const std::string& steps) {
  auto read = scenarios::ParseScenario("found/lamp.yaml", "dialect: nc110\nsources:\n  lamp.plc: |\n    x\n" + steps);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    return {{}, ToText(errors->front())};
  }
  const auto& scenario = std::get<scenarios::Scenario>(read);
  const auto plan = scenarios::PlanScenario(scenario, *bench.compilation.dialect, bench.compilation.program);
  return OpenScenario(*bench.session, scenario, std::get<scenarios::ScenarioPlan>(plan));
}

TEST(Opened, StandsWhereAnExpectationFailsFirst) {
  LiveBench bench;
  const Opened opened = Open(bench,
                             "steps:\n- run: {ms: 20}\n- set: {I0A3: 1}\n- run: {slow: 2}\n- expect: {U4A8: 1}\n"
                             "- run: {ms: 25}\n- expect: {U4A9: 0}\n- run: {ms: 500}\n");
  EXPECT_EQ(opened.refusal, "");
  EXPECT_EQ(opened.text, "found/lamp.yaml:11: step 6 (expect): U4A9 is 1, expected 0");
  EXPECT_EQ(bench.session->opened(), opened.text);
  EXPECT_EQ(bench.Value("U4A9"), 1u);
  const uint64_t period = bench.session->timeline().period();
  EXPECT_EQ(bench.session->GoTo(2), "");
  EXPECT_EQ(bench.Value("U4A9"), 0u);
  EXPECT_EQ(bench.session->GoTo(period), "");
  EXPECT_EQ(bench.Value("U4A9"), 1u);
}

TEST(Opened, StandsWhereAPropertyIsViolated) {
  LiveBench bench;
  const Opened opened =
      Open(bench, "properties: [never U4A9]\nsteps:\n- run: {ms: 50}\n- set: {I0A3: 1}\n- run: {ms: 500}\n");
  EXPECT_THAT(opened.text, HasSubstr("property 'never U4A9' does not hold"));
  EXPECT_EQ(bench.session->timeline().period(), 6u);
}

class CommandsTest : public testing::Test {
 protected:
  std::string Run(const std::string& command) {
    return RunCommand(*bench_.session, {&bench_.compilation, &bench_.request, folder_.path().string()},
                      nlohmann::ordered_json::parse(command, nullptr, false))
        .refusal;
  }
  LiveBench bench_;
  testing_support::TemporaryDirectory folder_;
};

TEST_F(CommandsTest, NothingOfThemIsBelieved) {
  EXPECT_EQ(Run(R"({"do":"set","name":"I0A3","value":"1"})"), "");
  for (const char* wrong :
       {"[]",
        "3",
        "null",
        R"({"do":3})",
        R"({"do":"nothing"})",
        R"({"do":"set"})",
        R"({"do":"set","name":["I0A3"],"value":"1"})",
        R"({"do":"set","name":"I0A3","value":1})",
        R"({"do":"back","periods":-1})",
        R"({"do":"back","periods":1e30})",
        R"({"do":"back","periods":0})",
        R"({"do":"goTo","period":99999})",
        R"({"do":"switch","statement":77,"on":false})",
        R"({"do":"switch","statement":0})",
        R"({"do":"speed","times":"fast"})",
        R"({"do":"speed","times":1e99})",
        R"({"do":"step","what":"leap"})",
        R"({"do":"save","file":"../../x.yaml"})",
        R"({"do":"expect","names":[1]})",
        R"({"do":"unwatch","number":3})",
        R"({"do":"trigger","edge":"up","text":"I0A3","baseMs":1,"delayMs":0,"samples":9,"before":0})",
        "{\"do\":\"set\",\"name\":\"I0A3\\u0000\",\"value\":\"1\"}"}) {
    EXPECT_NE(Run(wrong), "") << wrong;
  }
  EXPECT_NE(Run("{\"do\":\"watch\",\"name\":\"" + std::string(100'000, 'x') + "\"}"), "");
}

// What is wrong with a condition is told in the words that were written.
TEST_F(CommandsTest, ConditionsAreToldAsTheyWereWritten) {
  const auto refused = [&](const std::string& text) {
    return Run(R"({"do":"breakCondition","text":")" + text + "\"}");
  };
  EXPECT_THAT(refused("U4A8 and"), StartsWith("the end of the line stands where a location, a number or '('"));
  EXPECT_THAT(refused(""), StartsWith("the end of the line stands where"));
  EXPECT_THAT(refused("U4A8) or (I0A3"), StartsWith("')' stands where"));
  EXPECT_EQ(refused("U4A8 is never stuck"), "whether something is stuck cannot be seen in one run");
  EXPECT_EQ(refused("U4A8 or I0A3 and not I0A4 for 20 ms"), "");
}

// On a full disk nothing is left that would be in the way when there is room again.
TEST_F(CommandsTest, AScenarioIsSavedWholeOrNotAtAll) {
  bench_.Periods(2);
  const std::string save = R"({"do":"save","file":"kept.yaml"})";
  const std::filesystem::path path = folder_.path() / "kept.yaml";
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto on_excess = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit nothing = {0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &nothing), 0);
  const std::string refusal = Run(save);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, on_excess);
  EXPECT_EQ(refusal, "'kept.yaml' cannot be written: file too large");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(Run(save), "");
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(Run(save), "'kept.yaml' is there already");
}

TEST_F(CommandsTest, EachOneIsThereOnce) {
  std::vector<std::string> names = CommandNames();
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_GT(names.size(), 25u);
}

TEST_F(CommandsTest, SixteenAreWatched) {
  for (int i = 0; i < 16; ++i) EXPECT_EQ(Run(R"({"do":"watch","name":"I0A)" + std::to_string(i) + "\"}"), "") << i;
  EXPECT_THAT(Run(R"({"do":"watch","name":"U4A8"})"), HasSubstr("16"));
}

TEST(Chart, ATriggerKeepsWhatLiesAroundIt) {
  LiveBench bench;
  Session& session = *bench.session;
  Watch(session, "I0A3");
  Watch(session, "W3K0");
  EXPECT_EQ(Arm(session,
                {.edge = "rising", .text = "I0A3", .base_ms = 20, .delay_ms = 0, .samples = 10, .before_percent = 30}),
            "");
  bench.Periods(50);
  EXPECT_EQ(session.chart().trigger()->state, TriggerState::kArmed);
  Set(session, "I0A3", "1");
  bench.Periods(30);
  const Chart::Trigger& trigger = *session.chart().trigger();
  EXPECT_EQ(trigger.state, TriggerState::kComplete);
  ASSERT_EQ(trigger.kept.size(), 10u);
  EXPECT_EQ(trigger.kept[2].values[0], 0u);
  EXPECT_EQ(trigger.kept[3].values[0], 1u);
  EXPECT_EQ(trigger.kept[3].time_ms, trigger.at_ms);
  EXPECT_EQ(trigger.kept[4].time_ms - trigger.kept[3].time_ms, 20u);
  EXPECT_EQ(
      Arm(session,
          {.edge = "condition", .text = "W3K0 = 90", .base_ms = 10, .delay_ms = 50, .samples = 5, .before_percent = 0}),
      "");
  bench.Periods(30);
  EXPECT_EQ(session.chart().trigger()->state, TriggerState::kComplete);
  EXPECT_EQ(session.chart().trigger()->kept.front().values[1], 95u);
}

TEST(StateView, TellsWhatIsDifferentOnly) {
  LiveBench bench;
  const ProgramView program(*bench.session);
  StateView view(*bench.session, program);
  const auto first = view.Changes();
  EXPECT_TRUE(first.contains("values") && first.contains("at") && first.contains("mode"));
  EXPECT_EQ(view.Changes().dump(), "{}");
  Set(*bench.session, "I0A3", "1");
  const auto second = view.Changes();
  EXPECT_EQ(second["values"].size(), 1u) << second.dump();
  EXPECT_FALSE(second.contains("mode"));
}

/// The flow of power as the page has it: net by net.
std::vector<bool> Flow(const nlohmann::ordered_json& nets, const std::vector<bool>& power) {
  std::vector<bool> on;
  for (const auto& net : nets) {
    const std::string kind = net["kind"];
    const bool lets = !net.contains("bit") || power[net["bit"].get<size_t>()] != net["inverted"].get<bool>();
    bool any = false;
    for (const auto& from : net["from"]) any = any || on[from.get<size_t>()];
    on.push_back(kind == "rail" || (kind == "through" && any && lets) || (kind == "output" && lets) ||
                 (kind == "inverted" && !any) || (kind == "any" && any));
  }
  return on;
}

/// For all inputs of a network with contacts in series and in parallel, the net at the coil is the coil.
TEST(ProgramView, PowerReachesACoilExactlyWhereItIsOn) {
  LiveBench bench("$\nU4A8=(I0A3+/I0A4)*(I0A5+I0A6*/I0A7)+/(I0A3*I0A7)\n");
  const ProgramView program(*bench.session);
  const auto rows = program.Rows(0, program.rows());
  const nlohmann::ordered_json* ladder = nullptr;
  for (const auto& row : rows) {
    if (!row["statements"].empty() && row.contains("ladder")) ladder = &row["ladder"];
  }
  ASSERT_NE(ladder, nullptr);
  const size_t coil = (*ladder)["symbols"].back()["net"];
  for (int inputs = 0; inputs < 32; ++inputs) {
    for (int bit = 0; bit < 5; ++bit) {
      Set(*bench.session, "I0A" + std::to_string(bit + 3), std::to_string(inputs >> bit & 1));
    }
    bench.Periods(4);
    std::vector<bool> power;
    for (const ir::ValueId value : program.power()) {
      power.push_back((bench.session->timeline().machine().simulator().ValueOf(value) & 1) != 0);
    }
    EXPECT_EQ(Flow((*ladder)["nets"], power)[coil], bench.Value("U4A8") != 0) << inputs;
  }
}

HttpRequest Request(const std::string& method, const std::string& path) {
  return {.method = method,
          .path = path,
          .body = {},
          .query = {},
          .host = "127.0.0.1:8420",
          .origin = {},
          .fetch_site = {},
          .content_type = method == "POST" ? "application/json" : "",
          .token = {}};
}

TEST(Guard, OtherPagesAreRefused) {
  const GuardOptions local{.port = 8420, .token = {}};
  EXPECT_EQ(RefusedFor(Request("POST", "/api/command"), local), "");
  HttpRequest request = Request("POST", "/api/command");
  request.host = "evil.example:8420";  // a name that leads to the loopback
  EXPECT_NE(RefusedFor(request, local), "");
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:80", "localhost.evil.example:8420"}) {
    request.host = host;
    EXPECT_NE(RefusedFor(request, local), "") << host;
  }
  request = Request("POST", "/api/command");
  request.origin = "http://127.0.0.1:8420";
  EXPECT_EQ(RefusedFor(request, local), "");
  for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1:8420", "http://127.0.0.1:84200"}) {
    request.origin = origin;
    EXPECT_NE(RefusedFor(request, local), "") << origin;
  }
  request = Request("GET", "/api/events");
  request.fetch_site = "cross-site";
  EXPECT_NE(RefusedFor(request, local), "");
  request = Request("POST", "/api/command");
  request.content_type = "text/plain";
  EXPECT_NE(RefusedFor(request, local), "");
}

// Browsers leave port 80 out, and a name is one in either case.
TEST(Guard, OneHostHasSeveralSpellings) {
  const GuardOptions local{.port = 80, .token = {}}, other{.port = 8420, .token = {}};
  HttpRequest request = Request("POST", "/api/command");
  for (const char* host : {"127.0.0.1", "127.0.0.1:80", "localhost", "[::1]", "[::1]:80", "LOCALHOST"}) {
    request.host = host;
    request.origin = "http://" + request.host;
    EXPECT_EQ(RefusedFor(request, local), "") << host;
    EXPECT_NE(RefusedFor(request, other), "") << host;
  }
  for (const char* host : {"", "evil.example", "127.0.0.1:8420", "[::1]:"}) {
    request.host = host;
    EXPECT_NE(RefusedFor(request, local), "") << host;
  }
  request.host = "LocalHost:8420";
  request.origin = "http://localhost:8420";
  EXPECT_EQ(RefusedFor(request, other), "");
  request.origin = "http://localhost";
  EXPECT_NE(RefusedFor(request, other), "");
}

TEST(Guard, BeyondTheLoopbackATokenIsKnown) {
  const GuardOptions open{.port = 8420, .token = "0123456789abcdef"};
  HttpRequest request = Request("GET", "/api/events");
  request.host = "plc.example:8420";
  EXPECT_NE(RefusedFor(request, open), "");
  request.query = {{"token", "0123456789abcdef"}};
  EXPECT_EQ(RefusedFor(request, open), "");
  request.query = {{"token", "0123456789abcdeX"}};
  EXPECT_NE(RefusedFor(request, open), "");
  request.token = "0123456789abcdef";
  EXPECT_EQ(RefusedFor(request, open), "");
  EXPECT_EQ(RefusedFor(Request("GET", "/app.js"), open), "") << "the page itself has no secrets";
}

}  // namespace
}  // namespace plcxx::live
