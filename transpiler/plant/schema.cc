#include "transpiler/plant/schema.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "transpiler/plant/elements.h"
#include "transpiler/plant/panel.h"

namespace plcxx::plant {
namespace {

using Json = nlohmann::ordered_json;

/// Words that YAML takes for numbers or truth values are words, too.
Json AnyWord() { return {{"type", {"string", "number", "boolean"}}}; }
Json OneOrMore(const Json& item) { return {{"anyOf", {item, {{"type", "array"}, {"items", item}, {"minItems", 1}}}}}; }
Json MapOf(const Json& value) { return {{"type", "object"}, {"additionalProperties", value}}; }
Json OneOf(const std::vector<std::string_view>& words) { return {{"enum", words}}; }
Json Whole() { return {{"type", {"integer", "string"}}}; }
Json Positive() { return {{"type", "number"}, {"exclusiveMinimum", 0}}; }

Json SchemaOf(Shape shape) {
  switch (shape) {
    case Shape::kCondition:
    case Shape::kDrive:
    case Shape::kAmount:
      return AnyWord();
    case Shape::kDrives:
      return OneOrMore(AnyWord());
    case Shape::kValues:
      return MapOf(Whole());
    case Shape::kLevels:
      return MapOf({{"type", "number"}});
    case Shape::kTime:
      return {{"type", {"string", "number"}}, {"examples", {"300 ms", "1.5 s"}}};
    case Shape::kCount:
      return {{"type", "integer"}, {"minimum", 1}};
    case Shape::kNumber:
      return {{"type", "integer"}, {"minimum", 0}};
    case Shape::kDecimal:
      return {{"type", "number"}};
    case Shape::kPositive:
      return Positive();
    case Shape::kBit:
      return {{"enum", {0, 1}}};
    case Shape::kEnd:
    case Shape::kCoding:
      return OneOf(WordsOf(shape));
  }
  return {};
}

Json SchemaOf(PanelShape shape) {
  switch (shape) {
    case PanelShape::kInputs:
      return OneOrMore(AnyWord());
    case PanelShape::kLocation:
    case PanelShape::kCondition:
    case PanelShape::kText:
      return AnyWord();
    case PanelShape::kSettings:
      return MapOf(Whole());
    case PanelShape::kTexts:
      return {{"type", "array"}, {"items", AnyWord()}, {"minItems", 2}};
    case PanelShape::kNumber:
      return {{"type", "integer"}, {"minimum", 1}};
    case PanelShape::kNumbers:
      return {{"type", "array"}, {"items", Whole()}};
    case PanelShape::kStart:
      return {{"enum", {"off", "on", false, true}}};
    case PanelShape::kContact:
    case PanelShape::kColor:
    case PanelShape::kCoding:
    case PanelShape::kBase:
      return OneOf(WordsOf(shape));
  }
  return {};
}

/// One of a list: a map with one key, whose value is a map with the keys of `rows`.
template <class Row>
Json ItemSchema(std::string_view name, std::string_view meaning, Json properties, const std::vector<const Row*>& rows,
                Json required) {
  for (const Row* row : rows) {
    Json schema = SchemaOf(row->shape);
    schema["description"] = std::string(row->meaning) + ". If it is left out: " + std::string(row->when_absent);
    properties[std::string(row->text)] = std::move(schema);
    if (row->when_absent == kNeeded) required.push_back(std::string(row->text));
  }
  Json keys = {{"type", "object"},
               {"description", std::string(meaning)},
               {"properties", properties},
               {"additionalProperties", false}};
  if (!required.empty()) keys["required"] = std::move(required);
  return {{"type", "object"},
          {"properties", {{std::string(name), std::move(keys)}}},
          {"required", {std::string(name)}},
          {"additionalProperties", false}};
}

Json Head(const char* title, const char* description) {
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", title},
          {"description", description},
          {"type", "object"}};
}

}  // namespace

std::string PlantSchema() {
  Json schema = Head("plant.yaml", "What a machine does around its PLC program, as plcxx moves it");
  Json items = Json::array();
  for (const ElementRow& row : Elements()) {
    Json properties = Json::object();
    properties["name"] = {{"type", "string"}, {"description", "what messages call it"}};
    items.push_back(ItemSchema(row.text, row.meaning, std::move(properties), KeysOf(row.kind), Json::array()));
  }
  schema["properties"] = {{"title", AnyWord()},
                          {"elements", {{"type", "array"}, {"items", {{"oneOf", std::move(items)}}}, {"minItems", 1}}}};
  schema["required"] = {"elements"};
  schema["additionalProperties"] = false;
  return schema.dump(2) + "\n";
}

std::string PanelSchema() {
  Json schema = Head("panel.yaml", "The operator's panel of a machine, as plcxx live shows it");
  Json items = Json::array();
  for (const ControlRow& row : Controls()) {
    Json properties = Json::object();
    properties["text"] = {{"type", {"string", "number"}}, {"description", "what is written at it"}};
    properties["place"] = {{"type", "array"},
                           {"items", {{"type", "integer"}, {"minimum", 1}}},
                           {"minItems", 2},
                           {"maxItems", 2},
                           {"description", "column and row. If it is left out: where there is room"}};
    properties["width"] = {{"type", "integer"}, {"minimum", 1}, {"description", "in columns. If it is left out: 1"}};
    items.push_back(ItemSchema(row.text, row.meaning, std::move(properties), KeysOf(row.kind), Json::array({"text"})));
  }
  Json group = {
      {"type", "object"},
      {"properties",
       {{"title", AnyWord()},
        {"columns", {{"type", "integer"}, {"minimum", 1}, {"description", "of its grid. If it is left out: 4"}}},
        {"controls", {{"type", "array"}, {"items", {{"oneOf", std::move(items)}}}}}}},
      {"additionalProperties", false}};
  schema["properties"] = {{"title", AnyWord()},
                          {"groups", {{"type", "array"}, {"items", std::move(group)}, {"minItems", 1}}}};
  schema["required"] = {"groups"};
  schema["additionalProperties"] = false;
  return schema.dump(2) + "\n";
}

}  // namespace plcxx::plant
