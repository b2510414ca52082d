// What is wrong with plant.yaml and panel.yaml, conditions, schemas, and the page of the documents.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/plant/plant_fixture.h"
#include "transpiler/plant/numbers.h"
#include "transpiler/plant/panel.h"
#include "transpiler/plant/schema.h"

namespace plcxx::plant {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string Text(const std::string& name) {
  std::ifstream file(PLCXX_ROOT "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string PanelErrors(const std::string& text) {
  const PanelOrErrors read = ParsePanel("panel.yaml", text);
  std::string all;
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    for (const yaml::Error& error : *errors) all += ToText(error) + "\n";
  }
  return all;
}

TEST(PlantFile, WhatIsWrongHasPlaceCauseAndRemedy) {
  const auto of = [](const std::string& element) { return ErrorsOf("elements:\n- " + element + "\n"); };
  EXPECT_THAT(of("swich: {input: A, follows: B}"),
              AllOf(HasSubstr("plant.yaml:2:3: 'swich' is no element"), HasSubstr("did you mean 'switch'")));
  EXPECT_THAT(of("switch: {input: A, folows: B}"),
              AllOf(HasSubstr("plant.yaml:2:22: 'folows' is no key"), HasSubstr("did you mean 'follows'")));
  EXPECT_THAT(of("switch: {input: A}"), HasSubstr("'switch' has no 'follows'"));
  EXPECT_THAT(of("switch: {follows: A}"), AllOf(HasSubstr("it has no input"), HasSubstr("write 'input: NAME'")));
  EXPECT_THAT(of("switch: {input: A, follows: B, on: 3 h}"),
              AllOf(HasSubstr("'3 h' does not fit 'on'"), HasSubstr("1.5 s")));
  EXPECT_THAT(of("switch: {input: A, follows: B, on: 0.5 ms}"), HasSubstr("does not fit"));
  EXPECT_THAT(of("switch: {input: A, follows: B, at: 2}"), HasSubstr("'2' is no value of 'at'; there are: 0, 1"));
  EXPECT_THAT(of("switch: {input: A, follows: B and}"),
              AllOf(HasSubstr("the end stands where a location is expected"), HasSubstr("help:")));
  EXPECT_THAT(of("switch: {input: A, follows: B}\n- fixed: {input: A}"),
              AllOf(HasSubstr("plant.yaml:3:18: 'A' is driven twice"), HasSubstr("line 2")));
  EXPECT_THAT(of("turret: {forward: F, positions: 9, time: 1 s, code: [A, B, C]}"),
              HasSubstr("3 inputs cannot show 9 positions"));
  EXPECT_THAT(of("turret: {forward: F, positions: 4, time: 1 s, at: 5}"), HasSubstr("there is no number 5"));
  EXPECT_THAT(of("turret: {forward: F, positions: 4, time: 1 s, window: 600 ms}"), HasSubstr("overlap"));
  EXPECT_THAT(of("turret: {forward: F, positions: 4, time: 1 s, locked: A}"), HasSubstr("there is no lock"));
  EXPECT_THAT(of("axis: {forward: F, speed: 1, from: 5, to: 5}"), HasSubstr("the way has no length"));
  EXPECT_THAT(of("axis: {forward: F, speed: -1, to: 5}"), HasSubstr("'-1' does not fit 'speed'"));
  EXPECT_THAT(of("tank: {capacity: 5, at: 6}"), HasSubstr("outside of 0 and 'capacity'"));
  EXPECT_THAT(of("cylinder: {extend: V, extend-time: 1 s, at: out}"), HasSubstr("there are: retracted, extended"));
  EXPECT_THAT(of("switch: A"), HasSubstr("is a map"));
  EXPECT_THAT(ErrorsOf("elements: {}\n"), HasSubstr("'elements' is a list"));
  EXPECT_THAT(ErrorsOf("title: none\n"), HasSubstr("there is no element in it"));
  EXPECT_THAT(ErrorsOf("elements: [\n"), HasSubstr("plant.yaml:"));
  EXPECT_NE(ErrorsOf(""), "");
}

TEST(PanelFile, WhatIsWrongHasPlaceCauseAndRemedy) {
  const auto of = [](const std::string& control) { return PanelErrors("groups:\n- controls:\n  - " + control + "\n"); };
  EXPECT_EQ(of("button: {text: START, input: S}"), "");
  EXPECT_THAT(of("buton: {text: A, input: S}"),
              AllOf(HasSubstr("panel.yaml:3:5: 'buton' is no control"), HasSubstr("did you mean 'button'")));
  EXPECT_THAT(of("button: {text: A}"), HasSubstr("'A' does nothing"));
  EXPECT_THAT(of("button: {input: S}"), HasSubstr("has no 'text'"));
  EXPECT_THAT(of("button: {text: A, input: S, color: pink}"), HasSubstr("'pink' is no value of 'color'"));
  EXPECT_THAT(of("knob: {text: A, positions: [x, y], input: S, location: W}"),
              HasSubstr("either inputs or one location"));
  EXPECT_THAT(of("knob: {text: A, positions: [x], location: W}"), HasSubstr("2 to 100 positions"));
  EXPECT_THAT(of("knob: {text: A, positions: [x, y], location: W, values: [1]}"),
              HasSubstr("2 positions and 1 values"));
  EXPECT_THAT(of("knob: {text: A, positions: [x, y], location: W, start: 3}"), HasSubstr("there is no position 3"));
  EXPECT_THAT(of("lamp: {text: A, of: '(B'}"), HasSubstr("')' is expected"));
  EXPECT_THAT(of("lamp: {text: A, of: B, place: [1]}"), HasSubstr("'place' is a column and a row"));
  EXPECT_THAT(of("messages: {text: A, width: 5}"), HasSubstr("beyond the 4 columns"));
  EXPECT_THAT(PanelErrors("groups: []\n"), HasSubstr("there is nothing on it"));
}

TEST(PanelFile, ControlsWriteWhatTheySay) {
  const PanelOrErrors read =
      ParsePanel("panel.yaml",
                 "groups:\n- controls:\n  - stop: {text: E, input: CHAIN}\n"
                 "  - button: {text: B, press: {W: 6, M: 1}, release: {M: 0}}\n"
                 "  - knob: {text: K, positions: [a, b, c], input: [X, Y], coding: gray, values: [1, 2, 3]}\n"
                 "  - toggle: {text: T, input: D, start: on}\n");
  ASSERT_TRUE(std::holds_alternative<Panel>(read));
  const Panel& panel = std::get<Panel>(read);
  const auto text = [&](size_t control, size_t position) {
    std::string all;
    for (const Setting& setting : panel.groups[0].controls[control].positions[position]) {
      all += panel.writes[setting.write].text + "=" + std::to_string(setting.value) + " ";
    }
    return all;
  };
  EXPECT_EQ(text(0, 0) + text(0, 1), "CHAIN=1 CHAIN=0 ");
  EXPECT_EQ(text(1, 0) + text(1, 1), "M=0 W=6 M=1 ");
  EXPECT_EQ(text(2, 0) + text(2, 1) + text(2, 2), "X=1 Y=0 X=1 Y=1 X=0 Y=1 ");
  EXPECT_EQ(panel.groups[0].controls[3].start, 1u);
}

TEST(Condition, Precedence) {
  const auto holds = [](const std::string& text, std::vector<int64_t> values) {
    LocationNames names;
    const auto parsed = Condition::Parse({text, {}}, names);
    if (const auto* wrong = std::get_if<std::string>(&parsed)) return *wrong;
    values.resize(std::max(values.size(), names.all().size()));
    return std::string(std::get<Condition>(parsed).Holds(values) ? "yes" : "no");
  };
  EXPECT_EQ(holds("A or B and C", {1, 0, 0}), "yes");
  EXPECT_EQ(holds("(A or B) and C", {1, 0, 0}), "no");
  EXPECT_EQ(holds("not A and B", {0, 1}), "yes");
  EXPECT_EQ(holds("not (A and B)", {1, 0}), "yes");
  EXPECT_EQ(holds("W is 5", {5}), "yes");
  EXPECT_EQ(holds("W is not 0x05", {5}), "no");
  EXPECT_EQ(holds("W >= 5 and W<10", {7}), "yes");
  EXPECT_EQ(holds("!LAMP and 'O 1.5'", {1, 1}), "yes");
  EXPECT_EQ(holds("A B", {}), "'B' stands where 'and', 'or', a comparison or the end is expected");
  EXPECT_EQ(holds("'A", {}), "a quote has no partner");
  EXPECT_EQ(holds("", {}), "the end stands where a location is expected");
  EXPECT_EQ(holds(std::string(60, '(') + "A", {}), "'(' stands where fewer than 50 nested parentheses is expected");
}

TEST(Numbers, TimesAndDecimals) {
  EXPECT_EQ(Milliseconds("300 ms"), 300u);
  EXPECT_EQ(Milliseconds("1.5s"), 1500u);
  EXPECT_EQ(Milliseconds("2 min"), 120'000u);
  EXPECT_EQ(Milliseconds("40"), 40u);
  EXPECT_EQ(Milliseconds("1.0005 s"), std::nullopt);
  EXPECT_EQ(Milliseconds("-1 s"), std::nullopt);
  EXPECT_EQ(Milliseconds("61 min"), std::nullopt);
  EXPECT_EQ(Thousandths("-2.5"), -2500);
  EXPECT_EQ(Thousandths("1.2345"), std::nullopt);
  EXPECT_EQ(Thousandths("1."), std::nullopt);
  EXPECT_EQ(WholeNumber("0x1F"), 31);
  EXPECT_EQ(WholeNumber("--1"), std::nullopt);
}

TEST(PlantSchemas, AreThoseInTheDocuments) {
  for (const auto& [file, text] : {std::pair<std::string, std::string>{"docs/plant.schema.json", PlantSchema()},
                                   {"docs/panel.schema.json", PanelSchema()}}) {
    if (std::getenv("PLCXX_UPDATE_GOLDEN") != nullptr) std::ofstream(PLCXX_ROOT "/" + file) << text;
    EXPECT_EQ(Text(file), text);
    EXPECT_EQ(nlohmann::json::parse(text)["additionalProperties"], false);
  }
}

TEST(PlantSchemas, ThePageHasEveryKey) {
  const std::string page = Text("docs/plant.md");
  const auto look = [&](const auto& rows, const auto& of) {
    for (const auto& row : rows) {
      EXPECT_THAT(page, HasSubstr("`" + std::string(row.text) + "`: " + std::string(row.meaning)));
      for (const auto* key : of(row.kind)) {
        EXPECT_THAT(page, HasSubstr("| `" + std::string(key->text) + "` | " + std::string(key->meaning) + " | " +
                                    std::string(key->when_absent) + " |"));
      }
    }
  };
  look(Elements(), [](ElementKind kind) { return KeysOf(kind); });
  look(Controls(), [](ControlKind kind) { return KeysOf(kind); });
}

}  // namespace
}  // namespace plcxx::plant
