// The YAML of scenarios: what is read, and what is refused with its place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "transpiler/scenarios/scenario.h"
#include "transpiler/yaml/words.h"

namespace plcxx::scenarios {
namespace {

using testing::ElementsAre;
using testing::Pair;

Scenario Parsed(const std::string& text) {
  ScenarioOrErrors read = ParseScenario("dir/s.yaml", text);
  if (const auto* errors = std::get_if<std::vector<ScenarioError>>(&read)) {
    for (const ScenarioError& error : *errors) ADD_FAILURE() << ToText(error);
    return {};
  }
  return std::get<Scenario>(std::move(read));
}

/// The errors, one line each.
std::vector<std::string> Errors(const std::string& text) {
  ScenarioOrErrors read = ParseScenario("s.yaml", text);
  std::vector<std::string> lines;
  if (const auto* errors = std::get_if<std::vector<ScenarioError>>(&read)) {
    for (const ScenarioError& error : *errors) lines.push_back(ToText(error));
  }
  return lines;
}

TEST(ScenarioReader, EverythingOfTheDesign) {
  const Scenario scenario = Parsed(R"(
dialect: nc110
name: turret
description: any words
sources: [turret.sym, turret.plc]
options: {cycle_ms: 10, old: on, clo: "10,2", extern: [U1A0, U1A1]}
warnings: [{line: 3, code: W356}, {code: nc110-W302, file: a.plc}]
steps:
- set: {I0A3: 1, W2K2: 0x12, OPERATOR_TEXT: "DOOR 1"}
- run: {slow: 1}
- run: {ms: 100, fast: 2, s: 1.5}
- expect: {U4A8: 1}
- force: {U4A8: 0}
- release: [U4A8, U4A9]
- release: U4A8
- expect_calls: [{fault: {kind: PARAM_RANGE, index: 20}}, {retentive_store: {}}, {store: }, load]
- expect_messages: [9, 36]
- power_cycle: {}
- power_cycle:
)");
  EXPECT_EQ(scenario.path, "dir/s.yaml");
  EXPECT_EQ(scenario.directory, "dir");
  EXPECT_EQ(scenario.dialect, "nc110");
  EXPECT_THAT(scenario.sources, ElementsAre("turret.sym", "turret.plc"));
  EXPECT_EQ(scenario.options.at("cycle_ms"), "10");
  EXPECT_EQ(scenario.options.at("old"), "on");
  EXPECT_EQ(scenario.options.at("clo"), "10,2");
  EXPECT_EQ(scenario.options.at("extern"), "U1A0,U1A1");
  ASSERT_EQ(scenario.warnings->size(), 2u);
  EXPECT_EQ((*scenario.warnings)[0].line, 3u);
  EXPECT_EQ((*scenario.warnings)[1].line, 0u);
  EXPECT_EQ((*scenario.warnings)[1].file, "a.plc");

  const std::vector<ScenarioStep>& steps = *scenario.steps;
  ASSERT_EQ(steps.size(), 11u);
  const auto& set = std::get<SetStep>(steps[0].action);
  EXPECT_EQ(set.assignments[1].location.text, "W2K2");
  EXPECT_EQ(set.assignments[1].value.text, "0x12");
  EXPECT_EQ(set.assignments[2].value.text, "DOOR 1");
  EXPECT_EQ(set.assignments[0].location.mark.line, 9u);
  EXPECT_EQ(set.assignments[0].location.mark.column, 9u);
  const auto& run = std::get<RunStep>(steps[2].action);
  ASSERT_EQ(run.parts.size(), 3u);
  EXPECT_EQ(run.parts[0].unit, RunUnit::kMilliseconds);
  EXPECT_EQ(run.parts[1].unit, RunUnit::kFastTicks);
  EXPECT_EQ(run.parts[2].count, 1500u);
  EXPECT_EQ(std::get<ReleaseStep>(steps[5].action).locations.size(), 2u);
  EXPECT_EQ(std::get<ReleaseStep>(steps[6].action).locations.size(), 1u);
  const auto& calls = std::get<ExpectCallsStep>(steps[7].action).calls;
  ASSERT_EQ(calls.size(), 4u);
  EXPECT_EQ(calls[0].arguments[1].value.text, "20");
  EXPECT_EQ(calls[3].function.text, "load");
  EXPECT_THAT(std::get<ExpectMessagesStep>(steps[8].action).messages, ElementsAre("9", "36"));
  EXPECT_EQ(steps[10].number, 11u);
  EXPECT_EQ(steps[10].name, "power_cycle");
}

TEST(ScenarioReader, StepsAreRepeated) {
  const Scenario scenario = Parsed(R"(
sources: [a.plc]
steps:
- repeat:
    times: 3
    steps:
    - set: {I0A0: 1}
    - repeat: {times: 2, steps: [{run: {slow: 5}}]}
- repeat: {times: 0, steps: [{power_cycle: {}}]}
- expect: {U4A0: 1}
)");
  std::string names;
  uint32_t number = 0;
  for (const ScenarioStep& step : *scenario.steps) {
    names += step.name + " ";
    EXPECT_EQ(step.number, ++number);
  }
  EXPECT_EQ(names, "set run run set run run set run run expect ");
}

TEST(ScenarioReader, RepeatedStepsThatAreNone) {
  EXPECT_THAT(Errors("steps:\n- repeat: {times: 2, stps: []}\n"),
              ElementsAre(testing::HasSubstr("'stps' is no key of 'repeat'; there are: times, steps")));
  EXPECT_THAT(Errors("steps:\n- repeat: {times: 2}\n"),
              ElementsAre(testing::HasSubstr("'repeat' needs 'times' and 'steps'")));
  // What is wrong in a step is said once.
  EXPECT_THAT(Errors("steps:\n- repeat: {times: 9, steps: [{wait: 1}]}\n"),
              ElementsAre(testing::HasSubstr("'wait' is no step")));
  EXPECT_THAT(Errors("steps:\n- repeat: {times: 300001, steps: [{power_cycle: {}}]}\n"),
              ElementsAre(testing::HasSubstr("at most 300000 steps")));
  std::string nested = "{power_cycle: {}}";
  for (int i = 0; i < 9; ++i) nested = "{repeat: {times: 100, steps: [" + nested + "]}}";
  EXPECT_THAT(Errors("steps: [" + nested + "]\n"), ElementsAre(testing::HasSubstr("may not in more")));
}

TEST(ScenarioReader, AProgramWithinIt) {
  const Scenario scenario = Parsed(R"(
sources:
  a.sym: |
    LAMP U4A8
  b.plc: |2-

      LAMP=I0A0
steps: []
)");
  EXPECT_THAT(scenario.sources, ElementsAre("s.yaml/a.sym", "s.yaml/b.plc"));
  EXPECT_THAT(scenario.texts, ElementsAre(Pair("s.yaml/a.sym", "LAMP U4A8\n"), Pair("s.yaml/b.plc", "\n  LAMP=I0A0")));
  EXPECT_THAT(Errors("sources:\n  x/a.plc: U4A0=1\nsteps: []\n"),
              ElementsAre("s.yaml:2:3: 'x/a.plc': a source that is written here has a name without a folder"));
  EXPECT_THAT(Errors("sources:\n  a.plc: [U4A0=1]\nsteps: []\n"),
              ElementsAre("s.yaml:2:10: the text of 'a.plc' is a single word or number"));
}

TEST(ScenarioReader, TheToolsOwnTextsAreReadAsTheyWere) {
  for (const std::string text :
       {"a\n", "a", "a\n\n\n", "\n a\n", "  a\n\tb\n\nc", "\n", "", "a\rb\n", "\x01\"\\\n", "é\n"}) {
    const Scenario scenario = Parsed("sources:\n  a.plc: " + yaml::YamlText(text, 4) + "\n  b.plc: x\nsteps: []\n");
    EXPECT_THAT(scenario.texts, ElementsAre(Pair("s.yaml/a.plc", text), Pair("s.yaml/b.plc", "x")));
  }
}

TEST(ScenarioReader, ExpectedErrors) {
  const Scenario scenario = Parsed("sources: a.plc\nexpect_error: {line: 7, contains: label, file: a.plc}\n");
  EXPECT_EQ(scenario.expect_error->line, 7u);
  EXPECT_THAT(scenario.expect_error->contains, ElementsAre("label"));
  EXPECT_EQ(scenario.expect_error->file, "a.plc");
  EXPECT_EQ(Parsed("expect_error: {contains: [a, b]}").expect_error->contains.size(), 2u);
}

TEST(ScenarioReader, UnknownKeysAreRefusedByName) {
  EXPECT_THAT(Errors("sources: [a]\nstep: []\n"),
              ElementsAre("s.yaml:2:1: 'step' is no key of a scenario; there are: dialect, program, sources, options, "
                          "plant, steps, properties, expect_error, warnings, name, description\n"
                          "  help: did you mean 'steps'"));
  EXPECT_THAT(Errors("sources: [a]\nmachine: b\n"),
              ElementsAre("s.yaml:2:1: 'machine' is no key of a scenario; there are: dialect, program, sources, "
                          "options, plant, steps, properties, expect_error, warnings, name, description",
                          "s.yaml:1:1: nothing to test: there are no 'steps', no 'expect_error' and no 'warnings'"));
  EXPECT_THAT(
      Errors("steps:\n- wait: 3\n- run: {slow: 1, hours: 2}\n"),
      ElementsAre(
          "s.yaml:2:3: 'wait' is no step; there are: set, run, expect, force, release, expect_calls, expect_messages, "
          "power_cycle, repeat",
          "s.yaml:3:18: 'hours' is no key of 'run'; there are: slow, fast, ms, s"));
  EXPECT_THAT(Errors("steps:\n- exepct: {A: 1}\n"), ElementsAre(testing::HasSubstr("did you mean 'expect'")));
  // A colon that is missing, or a blank after it, makes a key or a word of the whole step.
  for (const std::string set : {"set {A: 1}", "set:{A: 1}", "set [A]", "set A"}) {
    EXPECT_THAT(Errors("steps:\n- " + set + "\n"),
                ElementsAre(testing::AllOf(testing::StartsWith("s.yaml:2:3: 'set"), testing::HasSubstr("is no step"),
                                           testing::HasSubstr("help: write 'set: ', with a colon and a blank"))))
        << set;
  }
  EXPECT_THAT(Errors("steps:\n- power_cycle\n"), ElementsAre(testing::HasSubstr("write 'power_cycle: '")));
  EXPECT_THAT(Errors("steps:\n- settle\n"),
              ElementsAre("s.yaml:2:3: 'settle' is no step\n  help: a step is '- key: value'"));
  EXPECT_THAT(Errors("expect_error: {lines: 7}"),
              ElementsAre("s.yaml:1:16: 'lines' is no key of 'expect_error'; there are: line, contains, file\n"
                          "  help: did you mean 'line'"));
  EXPECT_THAT(Errors("warnings: [{line: 7, name: x}]"),
              ElementsAre("s.yaml:1:22: 'name' is no key of a warning; there are: line, code, file",
                          "s.yaml:1:12: a warning needs its 'code'"));
}

TEST(ScenarioReader, TheDialectAndItsOptionsAreRefusedAtTheirPlace) {
  const std::string rest = "sources: [a.plc]\nsteps:\n- run: {slow: 1}\n";
  EXPECT_THAT(Errors("dialect: nc11\n" + rest),
              ElementsAre(testing::StartsWith("s.yaml:1:10: 'nc11' is no dialect, did you mean 'nc110'; there are: ")));
  EXPECT_THAT(
      Errors("dialect: nc110\noptions: {nope: 1, slices: 99}\n" + rest),
      ElementsAre(
          testing::StartsWith("s.yaml:2:11: 'nope' is no option of dialect nc110\n  help: its options are: "),
          testing::StartsWith("s.yaml:2:28: value '99' of option 'slices' is not valid\n  help: expected 1..64")));
  EXPECT_THAT(Errors("dialect: nc110\noptions: {encoding: cp866, facts: checked}\n" + rest), testing::IsEmpty());
}

TEST(ScenarioReader, WrongShapesAreRefusedAtTheirPlace) {
  EXPECT_THAT(Errors("steps: {set: 1}"), ElementsAre("s.yaml:1:8: 'steps' is a list"));
  EXPECT_THAT(Errors("steps:\n- set: I0A3\n"), ElementsAre("s.yaml:2:8: 'set' is a map '{key: value}'"));
  EXPECT_THAT(Errors("steps:\n- set: {I0A3: }\n"),
              ElementsAre("s.yaml:2:15: the value of 'I0A3' is missing\n"
                          "  help: write it behind its key, a colon and a blank: 'KEY: 1'"));
  // Behind the key, and not where the next word is.
  EXPECT_THAT(Errors("steps:\n- set: {I0A3: 1}\n- run:\n\n# then\n- expect: {U4A0: 1}\n"),
              ElementsAre("s.yaml:3:7: 'run' is a map '{key: value}'"));
  EXPECT_THAT(Errors("steps:\n- run:  # so long\n    slow:\n"),
              ElementsAre(testing::StartsWith("s.yaml:3:10: 'slow' is missing")));
  EXPECT_THAT(Errors("steps:\n- set:\n    I0A3: &x\n    I0A4: ~\n- run: {slow: 1}\n"),
              ElementsAre(testing::StartsWith("s.yaml:3:11: the value of 'I0A3' is missing"),
                          testing::StartsWith("s.yaml:4:11: the value of 'I0A4' is missing")));
  EXPECT_THAT(
      Errors("dialect:\nsteps:\n-\n- run: {slow: 1}\n"),
      ElementsAre(testing::StartsWith("s.yaml:1:9: 'dialect' is missing"), testing::StartsWith("s.yaml:3:2: ")));
  EXPECT_THAT(Errors("steps:\n- set: {I0A3: [1]}\n"),
              ElementsAre("s.yaml:2:15: the value of 'I0A3' is a single word or number"));
  EXPECT_THAT(Errors("steps:\n- set: {I0A3: 1, I0A3: 0}\n"), ElementsAre("s.yaml:2:18: 'I0A3' is given twice"));
  EXPECT_THAT(Errors("steps:\n- run: {slow: 1}\n  expect: {U4A8: 1}\n"),
              ElementsAre("s.yaml:3:3: a step has one key; 'expect' begins another step"));
  EXPECT_THAT(Errors("steps:\n- run: {}\n"), ElementsAre("s.yaml:2:8: 'run' needs one of: slow, fast, ms, s"));
  EXPECT_THAT(Errors("steps:\n- run: {slow: -1}\n"),
              ElementsAre("s.yaml:2:15: '-1': 'slow' is a whole number from 0 to 4294967295"));
  EXPECT_THAT(
      Errors("steps:\n- run: {s: 0.0001}\n"),
      ElementsAre("s.yaml:2:12: '0.0001': 's' is a number of seconds from 0 to 4294967.295, to the millisecond"));
  EXPECT_THAT(Errors("steps:\n- power_cycle: {now: 1}\n"),
              ElementsAre("s.yaml:2:16: 'power_cycle' has no parameters: write 'power_cycle: {}'"));
  EXPECT_THAT(Errors("steps:\n- expect_messages: 9\n"),
              ElementsAre("s.yaml:2:20: 'expect_messages' is a list of numbers or texts of messages"));
  EXPECT_THAT(Errors("steps:\n- expect_calls: [{a: {}, b: {}}]\n"),
              ElementsAre("s.yaml:2:26: a call has one key; 'b' begins another call"));
  EXPECT_THAT(Errors("steps: []\nexpect_error: {line: 1}\n"),
              ElementsAre("s.yaml:2:15: 'expect_error' stands instead of 'steps', not beside them"));
}

TEST(ScenarioReader, WhatIsNotYaml) {
  EXPECT_THAT(Errors(""), ElementsAre("s.yaml: the file holds no scenario"));
  EXPECT_THAT(Errors("- a\n"), ElementsAre("s.yaml:1:1: a scenario is a map '{key: value}'"));
  EXPECT_THAT(Errors("a: 1\n---\nb: 1\n"), ElementsAre("s.yaml:2:1: the file holds more than one YAML document"));
  EXPECT_THAT(Errors("steps: [\n"), ElementsAre(testing::StartsWith("s.yaml:2:1: not YAML: ")));
  EXPECT_THAT(Errors("steps:\n- run: ms: 10\n"),
              ElementsAre("s.yaml:2:10: not YAML: illegal map value; a map in a line of another one stands in braces: "
                          "'run: {ms: 10}'"));
  EXPECT_THAT(Errors("steps: *nowhere\n"), ElementsAre(testing::StartsWith("s.yaml:1:")));
  EXPECT_THAT(Errors(std::string(100000, '[')), ElementsAre(testing::StartsWith("s.yaml:1:")));
}

TEST(ScenarioReader, FilesThatCannotBeRead) {
  const auto error = [](const std::string& path) {
    return std::get<std::vector<ScenarioError>>(ReadScenario(path)).at(0).message;
  };
  EXPECT_EQ(error("/nowhere/s.yaml"), "there is no such file");
  EXPECT_EQ(
      std::get<std::vector<ScenarioError>>(ReadScenario(PLCXX_ROOT "/samples/host50/ck6150/ck6150.il")).at(0).remedy,
      "a scenario is a file in YAML that names its program in 'sources' (docs/scenarios.md)");
  EXPECT_EQ(error("/"), "a directory: name the file in it that is the scenario");
  EXPECT_EQ(error("/dev/null"), "not a file, but a device or a pipe");
}

}  // namespace
}  // namespace plcxx::scenarios
