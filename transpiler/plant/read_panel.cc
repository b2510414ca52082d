// panel.yaml as it is written, to a panel.
#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/plant/coding.h"
#include "transpiler/plant/elements.h"
#include "transpiler/plant/numbers.h"
#include "transpiler/plant/panel.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"
#include "transpiler/yaml/document.h"
#include "transpiler/yaml/reader.h"

namespace plcxx::plant {
namespace {

constexpr size_t kMaxPanelBytes = 1u << 20;
constexpr size_t kMaxPanelWords = 50'000;
constexpr size_t kMaxControls = 500;
constexpr uint32_t kMaxColumns = 12;
constexpr uint32_t kMaxRows = 100;
constexpr size_t kMaxPositions = 100;

std::string QuotedWord(std::string_view text) { return "'" + std::string(text) + "'"; }

class PanelReader : public yaml::Reader {
 public:
  explicit PanelReader(const std::string& path) : yaml::Reader(path, kMaxPanelWords) { panel_.path = path; }

  void Read(const YAML::Node& root) {
    for (const yaml::Entry& entry : Map(root, "a panel")) {
      if (entry.key.text == "title") {
        if (const auto word = Word(entry.value, "'title'")) panel_.title = word->text;
      } else if (entry.key.text == "groups") {
        ReadGroups(entry.value);
      } else {
        RefuseKey(entry.key, "a panel", {"title", "groups"});
      }
    }
    if (errors().empty() && controls_ == 0) {
      Fail(Mark(root), "there is nothing on it", "write 'groups:', and below it '- {title: Machine, controls: [...]}'");
    }
    panel_.writes = writes_.all();
    panel_.reads = reads_.all();
  }
  Panel& panel() { return panel_; }

 private:
  /// The values of the keys of a control, as far as they are there.
  struct Given {
    std::map<std::string, std::vector<std::string>, std::less<>> words;
    std::map<std::string, std::vector<Setting>, std::less<>> settings;
    std::vector<uint32_t> inputs;
    std::optional<uint32_t> location;
    std::vector<int64_t> numbers;
    std::map<std::string, yaml::Place, std::less<>> marks;

    std::string Only(std::string_view key, const std::string& otherwise) const {
      const auto found = words.find(key);
      return found == words.end() || found->second.empty() ? otherwise : found->second.front();
    }
    bool Has(std::string_view key) const { return marks.find(key) != marks.end(); }
    yaml::Place MarkOf(std::string_view key, yaml::Place otherwise) const {
      const auto found = marks.find(key);
      return found == marks.end() ? otherwise : found->second;
    }
  };

  void ReadGroups(const YAML::Node& node) {
    if (!node.IsSequence()) {
      Fail(Mark(node), "'groups' is a list", "write '- title: Machine', and 'controls:' below it");
      return;
    }
    for (const YAML::Node& item : node) {
      PanelGroup group;
      for (const yaml::Entry& entry : Map(item, "a group")) {
        if (entry.key.text == "title") {
          if (const auto word = Word(entry.value, "'title'")) group.title = word->text;
        } else if (entry.key.text == "columns") {
          group.columns = NumberUpTo(entry.value, "'columns'", kMaxColumns);
        } else if (entry.key.text == "controls") {
          ReadControls(entry.value, group);
        } else {
          RefuseKey(entry.key, "a group", {"title", "columns", "controls"});
        }
      }
      for (const PanelControl& control : group.controls) {
        if (control.column + control.width <= group.columns + (control.column == 0 ? 0 : 1)) continue;
        Fail(control.mark,
             "'" + control.text + "' is beyond the " + std::to_string(group.columns) + " columns of its group",
             "write more 'columns', or less 'width'");
      }
      panel_.groups.push_back(std::move(group));
    }
  }

  void ReadControls(const YAML::Node& node, PanelGroup& group) {
    if (!node.IsSequence()) {
      Fail(Mark(node), "'controls' is a list", "write '- button: {text: START, input: NAME}' for each");
      return;
    }
    for (const YAML::Node& item : node) {
      if (++controls_ > kMaxControls) {
        Fail(Mark(item), "more than " + std::to_string(kMaxControls) + " controls", "leave some out");
        return;
      }
      const std::vector<yaml::Entry> entries = Map(item, "a control");
      if (entries.size() != 1) {
        if (!entries.empty())
          Fail(entries[1].key.mark, "a control is one map", "write its keys within '{ }', or further in");
        continue;
      }
      const yaml::MarkedText& name = entries.front().key;
      const auto row = std::ranges::find(Controls(), name.text, &ControlRow::text);
      if (row == Controls().end()) {
        std::vector<std::string_view> known;
        for (const ControlRow& one : Controls()) known.push_back(one.text);
        const std::string_view near = support::NearestWord(name.text, known);
        Fail(name.mark, QuotedWord(name.text) + " is no control; there are: " + support::CommaSeparated(known),
             near.empty() ? "" : "did you mean " + QuotedWord(near));
        continue;
      }
      ReadControl(*row, name.mark, entries.front().value, group);
    }
  }

  void ReadControl(const ControlRow& row, yaml::Place mark, const YAML::Node& node, PanelGroup& group) {
    const size_t errors_before = errors().size();
    PanelControl control;
    control.kind = row.kind;
    control.mark = mark;
    Given given;
    const std::vector<const ControlKeyRow*> keys = KeysOf(row.kind);
    for (const yaml::Entry& entry : Map(node, "the control " + QuotedWord(row.text))) {
      if (entry.key.text == "text") {
        if (const auto word = Word(entry.value, "'text'")) control.text = word->text;
      } else if (entry.key.text == "width") {
        control.width = NumberUpTo(entry.value, "'width'", kMaxColumns);
      } else if (entry.key.text == "place") {
        ReadPlace(entry.value, control);
      } else if (const auto key = std::ranges::find(keys, entry.key.text, &ControlKeyRow::text); key != keys.end()) {
        given.marks.emplace(entry.key.text, Mark(entry.value));
        ReadValue(entry.value, **key, given, control);
      } else {
        std::vector<std::string_view> known{"text", "place", "width"};
        for (const ControlKeyRow* one : keys) known.push_back(one->text);
        RefuseKey(entry.key, "the control " + QuotedWord(row.text), known);
      }
    }
    for (const ControlKeyRow* key : keys) {
      if (key->when_absent == kNeeded && !given.Has(key->text) && errors().size() == errors_before) {
        Fail(mark, QuotedWord(row.text) + " has no " + QuotedWord(key->text), "write it: " + std::string(key->meaning));
      }
    }
    if (control.text.empty() && errors().size() == errors_before) {
      Fail(mark, QuotedWord(row.text) + " has no 'text'",
           "write what stands at it: somebody who does not see it hears that");
    }
    if (errors().size() != errors_before) return;
    Complete(given, control);
    if (errors().size() == errors_before) group.controls.push_back(std::move(control));
  }

  uint32_t NumberUpTo(const YAML::Node& node, std::string_view what, uint32_t most) {
    const std::optional<uint32_t> number = Number(node, what);
    if (number && *number >= 1 && *number <= most) return *number;
    if (number) Fail(Mark(node), std::string(what) + " is 1 to " + std::to_string(most), "write such a number");
    return 1;
  }

  void ReadPlace(const YAML::Node& node, PanelControl& control) {
    if (!node.IsSequence() || node.size() != 2) {
      Fail(Mark(node), "'place' is a column and a row", "write it as in [1, 2]");
      return;
    }
    control.column = NumberUpTo(node[0], "a column", kMaxColumns);
    control.row = NumberUpTo(node[1], "a row", kMaxRows);
  }

  void ReadValue(const YAML::Node& node, const ControlKeyRow& row, Given& given, PanelControl& control) {
    const std::string what = QuotedWord(row.text);
    switch (row.shape) {
      case PanelShape::kInputs:
        for (const yaml::MarkedText& word : MarkedWords(node, what)) given.inputs.push_back(writes_.Add(word));
        return;
      case PanelShape::kLocation:
        if (const auto word = Word(node, what)) {
          if (row.control == ControlKind::kDisplay) {
            control.shows = reads_.Add(*word);
          } else {
            given.location = writes_.Add(*word);
          }
        }
        return;
      case PanelShape::kSettings:
        for (const yaml::Entry& entry : Map(node, what)) {
          const auto word = Word(entry.value, "the value of " + QuotedWord(entry.key.text));
          if (!word) continue;
          const std::optional<int64_t> value = WholeNumber(word->text);
          if (!value) Fail(word->mark, QuotedWord(word->text) + " is no number", "write a whole number: 12, 0x0C");
          given.settings[std::string(row.text)].push_back(
              {.write = writes_.Add(entry.key), .value = value.value_or(0)});
        }
        return;
      case PanelShape::kCondition: {
        const auto word = Word(node, what);
        if (!word) return;
        std::variant<Condition, std::string> parsed = Condition::Parse(*word, reads_);
        if (const auto* wrong = std::get_if<std::string>(&parsed)) {
          Fail(word->mark, what + ": " + *wrong, "write it as in 'LAMP and not (STOP or STATE >= 5)'");
        } else {
          control.lamp = std::move(std::get<Condition>(parsed));
        }
        return;
      }
      case PanelShape::kTexts:
        for (const yaml::MarkedText& word : MarkedWords(node, what)) control.labels.push_back(word.text);
        return;
      case PanelShape::kNumbers:
        for (const yaml::MarkedText& word : MarkedWords(node, what)) {
          const std::optional<int64_t> value = WholeNumber(word.text);
          if (!value) Fail(word.mark, QuotedWord(word.text) + " is no number", "write a whole number: 12, 0x0C");
          given.numbers.push_back(value.value_or(0));
        }
        return;
      case PanelShape::kNumber:
        control.start = NumberUpTo(node, what, kMaxPositions) - 1;
        return;
      case PanelShape::kText:
      case PanelShape::kContact:
      case PanelShape::kStart:
      case PanelShape::kColor:
      case PanelShape::kCoding:
      case PanelShape::kBase: {
        const auto word = Word(node, what);
        if (!word) return;
        const std::vector<std::string_view> words = WordsOf(row.shape);
        if (!words.empty() && std::ranges::find(words, word->text) == words.end()) {
          Fail(word->mark,
               QuotedWord(word->text) + " is no value of " + what + "; there are: " + support::CommaSeparated(words));
        }
        given.words[std::string(row.text)].push_back(word->text);
        return;
      }
    }
  }

  void Complete(Given& given, PanelControl& control) {
    control.color = given.Only("color", "white");
    control.base = given.Only("base", "");
    control.unit = given.Only("unit", "");
    switch (control.kind) {
      case ControlKind::kButton:
      case ControlKind::kToggle:
      case ControlKind::kKey:
      case ControlKind::kStop:
        CompleteSwitch(given, control);
        return;
      case ControlKind::kKnob:
        CompleteKnob(given, control);
        return;
      case ControlKind::kLamp:
      case ControlKind::kDisplay:
      case ControlKind::kMessages:
        return;
    }
  }

  void CompleteSwitch(Given& given, PanelControl& control) {
    const bool opens = given.Only("contact", control.kind == ControlKind::kStop ? "opens" : "closes") == "opens";
    std::vector<Setting> released = given.settings["release"], pressed = given.settings["press"];
    for (const uint32_t input : given.inputs) {
      released.push_back({.write = input, .value = opens ? 1 : 0});
      pressed.push_back({.write = input, .value = opens ? 0 : 1});
    }
    if (pressed.empty())
      Fail(control.mark, QuotedWord(control.text) + " does nothing", "write 'input: NAME', or 'press: {NAME: 1}'");
    control.positions = {std::move(released), std::move(pressed)};
    if (control.kind == ControlKind::kToggle || control.kind == ControlKind::kKey) {
      control.labels = {given.Only("off", "off"), given.Only("on", "on")};
    }
    control.start = given.Only("start", "off") == "on" ? 1 : 0;
  }

  void CompleteKnob(const Given& given, PanelControl& control) {
    const size_t count = control.labels.size();
    if (count < 2 || count > kMaxPositions) {
      Fail(given.MarkOf("positions", control.mark), "a knob has 2 to " + std::to_string(kMaxPositions) + " positions",
           "name each");
      return;
    }
    if (given.location.has_value() != given.inputs.empty()) {
      Fail(control.mark, "a knob writes either inputs or one location", "write 'input: [A, B]', or 'location: W'");
      return;
    }
    if (!given.numbers.empty() && given.numbers.size() != count) {
      Fail(given.MarkOf("values", control.mark),
           std::to_string(count) + " positions and " + std::to_string(given.numbers.size()) + " values",
           "write a value for each position");
      return;
    }
    if (control.start >= count) {
      Fail(given.MarkOf("start", control.mark), "there is no position " + std::to_string(control.start + 1),
           "write one from 1 to " + std::to_string(count));
      return;
    }
    const Coding coding = CodingOf(given.Only("coding", "binary"));
    for (size_t i = 0; i < count; ++i) {
      const int64_t number = given.numbers.empty() ? static_cast<int64_t>(i) : given.numbers[i];
      std::vector<Setting> settings;
      const uint64_t code = CodeOf(coding, static_cast<uint64_t>(number), i);
      for (size_t bit = 0; bit < given.inputs.size(); ++bit) {
        settings.push_back({.write = given.inputs[bit], .value = bit < 64 ? static_cast<int64_t>(code >> bit & 1) : 0});
      }
      if (given.location) settings.push_back({.write = *given.location, .value = number});
      control.positions.push_back(std::move(settings));
    }
  }

  Panel panel_;
  LocationNames writes_, reads_;
  size_t controls_ = 0;
};

}  // namespace

PanelOrErrors ReadPanel(const std::string& path) {
  std::variant<std::string, yaml::Fault> text = yaml::ReadText(path, kMaxPanelBytes, "panel");
  if (auto* fault = std::get_if<yaml::Fault>(&text))
    return std::vector<yaml::Error>{{path, fault->mark, std::move(fault->message)}};
  return ParsePanel(path, std::get<std::string>(text));
}

PanelOrErrors ParsePanel(const std::string& path, const std::string& text) {
  std::variant<YAML::Node, yaml::Fault> root = yaml::Load(text);
  if (auto* fault = std::get_if<yaml::Fault>(&root))
    return std::vector<yaml::Error>{{path, fault->mark, std::move(fault->message)}};
  PanelReader reader(path);
  reader.Read(std::get<YAML::Node>(root));
  if (!reader.errors().empty()) return std::move(reader.errors());
  return std::move(reader.panel());
}

}  // namespace plcxx::plant
