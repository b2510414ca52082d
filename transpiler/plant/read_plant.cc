// plant.yaml as it is written, to a model.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "transpiler/plant/numbers.h"
#include "transpiler/plant/plant.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"
#include "transpiler/yaml/document.h"
#include "transpiler/yaml/reader.h"

namespace plcxx::plant {
namespace {

constexpr size_t kMaxPlantBytes = 1u << 20;
constexpr size_t kMaxPlantWords = 50'000;
constexpr size_t kMaxElements = 2000;

std::string InQuotes(std::string_view text) { return "'" + std::string(text) + "'"; }

}  // namespace

class PlantReader : public yaml::Reader {
 public:
  explicit PlantReader(const std::string& path) : yaml::Reader(path, kMaxPlantWords) {}

  void Read(const YAML::Node& root, Model& model) {
    model.path_ = path();
    model_ = &model;
    for (const yaml::Entry& entry : Map(root, "a plant")) {
      if (entry.key.text == "title") {
        static_cast<void>(Word(entry.value, "'title'"));
      } else if (entry.key.text == "elements") {
        ReadElements(entry.value);
      } else {
        RefuseKey(entry.key, "a plant", {"title", "elements"});
      }
    }
    if (errors().empty() && model.elements_.empty()) {
      Fail(Mark(root), "there is no element in it",
           "write 'elements:', and below it '- switch: {input: PRESSURE, follows: PUMP}'");
    }
    model.reads_ = reads_.all();
  }

 private:
  void ReadElements(const YAML::Node& node) {
    if (!node.IsSequence()) {
      Fail(Mark(node), "'elements' is a list", "write '- switch: {...}' for each");
      return;
    }
    if (node.size() > kMaxElements) {
      Fail(Mark(node), "more than " + std::to_string(kMaxElements) + " elements", "leave some out");
      return;
    }
    for (const YAML::Node& item : node) ReadElement(item);
  }

  void ReadElement(const YAML::Node& node) {
    const std::vector<yaml::Entry> entries = Map(node, "an element");
    if (entries.size() != 1) {
      if (!entries.empty())
        Fail(entries[1].key.mark, "an element is one map", "write its keys within '{ }', or further in");
      return;
    }
    const yaml::MarkedText& name = entries.front().key;
    for (const ElementRow& row : Elements()) {
      if (name.text != row.text) continue;
      ReadKeys(row, name.mark, entries.front().value);
      return;
    }
    std::vector<std::string_view> known;
    for (const ElementRow& row : Elements()) known.push_back(row.text);
    const std::string_view near = support::NearestWord(name.text, known);
    Fail(name.mark, InQuotes(name.text) + " is no element; there are: " + support::CommaSeparated(known),
         near.empty() ? "" : "did you mean " + InQuotes(near));
  }

  void ReadKeys(const ElementRow& element, yaml::Place mark, const YAML::Node& node) {
    const size_t errors_before = errors().size();
    Fields fields;
    fields.mark = mark;
    const std::vector<const ElementKeyRow*> keys = KeysOf(element.kind);
    const std::vector<yaml::Entry> entries = Map(node, "the element " + InQuotes(element.text));
    element_ = std::string(element.text);
    for (const yaml::Entry& entry : entries) {
      if (entry.key.text != "name") continue;
      if (const auto word = Word(entry.value, "'name'")) element_ += " " + InQuotes(word->text);
    }
    for (const yaml::Entry& entry : entries) {
      if (entry.key.text == "name") continue;
      const auto row = std::ranges::find(keys, entry.key.text, &ElementKeyRow::text);
      if (row == keys.end()) {
        std::vector<std::string_view> known{"name"};
        for (const ElementKeyRow* key : keys) known.push_back(key->text);
        RefuseKey(entry.key, "the element " + InQuotes(element.text), known);
        continue;
      }
      Field field;
      field.mark = Mark(entry.value);
      ReadValue(entry.value, **row, field);
      fields.all.emplace(entry.key.text, std::move(field));
    }
    for (const ElementKeyRow* key : keys) {
      if (key->when_absent == kNeeded && fields.Find(key->text) == nullptr && errors().size() == errors_before) {
        Fail(mark, InQuotes(element.text) + " has no " + InQuotes(key->text),
             std::string("write it: ") + std::string(key->meaning));
      }
    }
    if (errors().size() != errors_before) return;
    MadeElement made = MakeElement(element.kind, fields);
    if (made.fault) {
      const Field* const field = fields.Find(made.fault->key);
      const std::string subject = InQuotes(made.fault->key.empty() ? std::string(element.text) : made.fault->key);
      Fail(field == nullptr ? mark : field->mark, subject + ": " + made.fault->message, made.fault->remedy);
      return;
    }
    const uint32_t size = made.element->size();
    model_->elements_.push_back({.element = std::move(made.element), .begin = model_->size_});
    model_->size_ += size;
  }

  void ReadValue(const YAML::Node& node, const ElementKeyRow& row, Field& field) {
    const std::string what = InQuotes(row.text);
    switch (row.shape) {
      case Shape::kDrive:
        if (const auto word = Word(node, what)) field.drives.push_back(Drive(*word));
        if (field.drives.empty()) field.drives.push_back(0);  // reported
        return;
      case Shape::kDrives:
        for (const yaml::MarkedText& word : MarkedWords(node, what)) field.drives.push_back(Drive(word));
        if (field.drives.empty()) Fail(field.mark, what + " names no input", "leave it out");
        return;
      case Shape::kValues:
      case Shape::kLevels:
        for (const yaml::Entry& entry : Map(node, what)) {
          const auto word = Word(entry.value, "the value of " + InQuotes(entry.key.text));
          if (!word) continue;
          const std::optional<int64_t> number =
              row.shape == Shape::kValues ? WholeNumber(word->text) : Thousandths(word->text);
          if (!number) Fail(word->mark, InQuotes(word->text) + " is no number", NumberRemedy(row.shape));
          field.values.emplace_back(Drive(entry.key), number.value_or(0));
        }
        return;
      case Shape::kCondition: {
        const auto word = Word(node, what);
        if (!word) return;
        std::variant<Condition, std::string> parsed = Condition::Parse(*word, reads_);
        if (const auto* wrong = std::get_if<std::string>(&parsed)) {
          Fail(word->mark, what + ": " + *wrong, "write it as in 'PUMP and not (STOP or LEVEL >= 5)'");
        } else {
          field.condition = std::move(std::get<Condition>(parsed));
        }
        return;
      }
      case Shape::kAmount:
      case Shape::kTime:
      case Shape::kCount:
      case Shape::kNumber:
      case Shape::kDecimal:
      case Shape::kPositive:
      case Shape::kBit:
      case Shape::kEnd:
      case Shape::kCoding:
        if (const auto word = Word(node, what)) ReadWord(*word, row, field);
        return;
    }
  }

  static std::string NumberRemedy(Shape shape) {
    switch (shape) {
      case Shape::kTime:
        return "write a time of at most an hour in whole milliseconds: 300 ms, 1.5 s";
      case Shape::kCount:
        return "write a whole number from 1";
      case Shape::kNumber:
      case Shape::kValues:
        return "write a whole number: 12, 0x0C";
      case Shape::kPositive:
        return "write a number above 0 with at most three decimals";
      case Shape::kDecimal:
      case Shape::kLevels:
      case Shape::kAmount:
        return "write a number with at most three decimals";
      case Shape::kBit:
      case Shape::kEnd:
      case Shape::kCoding:
      case Shape::kCondition:
      case Shape::kDrive:
      case Shape::kDrives:
        return "";
    }
    return "";
  }

  void ReadWord(const yaml::MarkedText& word, const ElementKeyRow& row, Field& field) {
    const std::vector<std::string_view> words = WordsOf(row.shape);
    if (!words.empty()) {
      if (std::ranges::find(words, word.text) == words.end()) {
        Fail(word.mark, InQuotes(word.text) + " is no value of " + InQuotes(row.text) +
                            "; there are: " + support::CommaSeparated(words));
      }
      field.word = word.text;
      field.number = word.text == "1" ? 1 : 0;
      return;
    }
    std::optional<int64_t> number;
    switch (row.shape) {
      case Shape::kTime:
        if (const auto ms = Milliseconds(word.text)) number = static_cast<int64_t>(*ms);
        break;
      case Shape::kCount:
      case Shape::kNumber:
        number = WholeNumber(word.text);
        if (number && (*number < (row.shape == Shape::kCount ? 1 : 0) || *number > kMaxCount)) number.reset();
        break;
      case Shape::kPositive:
        number = Thousandths(word.text);
        if (number && *number <= 0) number.reset();
        break;
      case Shape::kDecimal:
        number = Thousandths(word.text);
        break;
      case Shape::kAmount:
        number = Thousandths(word.text);
        if (!number) {
          field.amount.read = reads_.Add(word);
          return;
        }
        if (*number < 0) number.reset();
        field.amount.thousandths = number.value_or(0);
        break;
      case Shape::kCondition:
      case Shape::kDrive:
      case Shape::kDrives:
      case Shape::kValues:
      case Shape::kLevels:
      case Shape::kBit:
      case Shape::kEnd:
      case Shape::kCoding:
        return;
    }
    if (!number) Fail(word.mark, InQuotes(word.text) + " does not fit " + InQuotes(row.text), NumberRemedy(row.shape));
    field.number = number.value_or(0);
  }

  /// The number of a location that the plant writes.
  uint32_t Drive(const yaml::MarkedText& name) {
    std::vector<Driven>& drives = model_->drives_;
    const auto known = std::ranges::find(drives, name.text, [](const Driven& driven) { return driven.name.text; });
    if (known != drives.end()) {
      Fail(name.mark, InQuotes(name.text) + " is driven twice",
           "the " + known->element + " in line " + std::to_string(known->name.mark.line) +
               " drives it, too: delete one of them");
    }
    drives.push_back({.name = name, .element = element_});
    return static_cast<uint32_t>(drives.size()) - 1;
  }

  static constexpr int64_t kMaxCount = 1'000'000;
  Model* model_ = nullptr;
  LocationNames reads_;
  std::string element_;  // that is being read
};

ModelOrErrors ReadPlant(const std::string& path) {
  std::variant<std::string, yaml::Fault> text = yaml::ReadText(path, kMaxPlantBytes, "plant");
  if (auto* fault = std::get_if<yaml::Fault>(&text))
    return std::vector<yaml::Error>{{path, fault->mark, std::move(fault->message)}};
  return ParsePlant(path, std::get<std::string>(text));
}

ModelOrErrors ParsePlant(const std::string& path, const std::string& text) {
  std::variant<YAML::Node, yaml::Fault> root = yaml::Load(text);
  if (auto* fault = std::get_if<yaml::Fault>(&root))
    return std::vector<yaml::Error>{{path, fault->mark, std::move(fault->message)}};
  PlantReader reader(path);
  const auto model = std::make_shared<Model>();
  reader.Read(std::get<YAML::Node>(root), *model);
  if (!reader.errors().empty()) return std::move(reader.errors());
  return std::shared_ptr<const Model>(model);
}

}  // namespace plcxx::plant
