#include "transpiler/project/schema.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "transpiler/dialects/dialect.h"
#include "transpiler/project/keys.h"

namespace plcxx::project {
namespace {

using Json = nlohmann::ordered_json;

/// Words that YAML takes for numbers or truth values are words, too.
Json AnyWord() { return {{"type", {"string", "number", "boolean"}}}; }
Json Text() { return {{"type", "string"}, {"minLength", 1}}; }
Json OneOrList(const Json& item) { return {{"anyOf", {item, {{"type", "array"}, {"items", item}}}}}; }
Json Reference(const std::string& name) { return {{"$ref", "#/definitions/" + name}}; }

/// Of all dialects, for completion; names of options in other letters are for the reader to judge.
Json OptionsSchema() {
  std::map<std::string, std::string> meanings;
  for (const dialects::Dialect* dialect : dialects::AllDialects()) {
    for (const dialects::OptionInfo& option : dialect->options) {
      std::string& meaning = meanings[std::string(option.key)];
      if (!meaning.empty()) meaning += "; ";
      meaning += std::string(dialect->name) + ": " + std::string(option.meaning) + ": " + std::string(option.values);
    }
  }
  Json properties = Json::object();
  for (const auto& [name, meaning] : meanings)
    properties[name] = {{"allOf", {Reference("words")}}, {"description", meaning}};
  return {{"type", "object"}, {"properties", properties}, {"additionalProperties", Reference("words")}};
}

Json MacrosSchema() {
  const Json value = {{"type", {"string", "number", "boolean", "null"}}};
  const Json names = {{"type", "array"}, {"items", Text()}};
  return {{"anyOf", {{{"type", "object"}, {"additionalProperties", value}}, names, Text()}}};
}

Json TargetsSchema() {
  Json properties = Json::object();
  for (const std::string& name : WordsOf(Shape::kTargets))
    properties[name] = {{"anyOf", {Reference("target"), {{"type", "null"}}}}};
  const Json list = {{"type", "array"}, {"items", {{"enum", WordsOf(Shape::kTargets)}}}};
  return {{"anyOf",
           {{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}},
            list,
            {{"enum", WordsOf(Shape::kTargets)}}}}};
}

Json SchemaOf(Shape shape) {
  switch (shape) {
    case Shape::kWord:
      return AnyWord();
    case Shape::kWords:
      return Reference("words");
    case Shape::kNumber:
      return {{"type", "integer"}, {"minimum", 0}};
    case Shape::kFileName:
      return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_.-]*$"}};
    case Shape::kPath:
      return Text();
    case Shape::kPaths:
    case Shape::kGlobs:
    case Shape::kWarningNames:
    case Shape::kWarningNamesOrAll:
      return OneOrList(Text());
    case Shape::kDialect:
    case Shape::kEncoding:
    case Shape::kHost:
      return {{"enum", WordsOf(shape)}};
    case Shape::kLevel: {
      Json words = WordsOf(shape);
      for (const int level : {0, 1, 2, 3}) words.push_back(level);
      return {{"enum", words}};
    }
    case Shape::kFrequency:
      return {{"type", {"string", "integer"}}, {"examples", {"168MHz"}}};
    case Shape::kOptions:
      return Reference("options");
    case Shape::kMacros:
      return MacrosSchema();
    case Shape::kWarnings:
      return Reference("warnings");
    case Shape::kTargets:
      return TargetsSchema();
    case Shape::kPrograms:
      return {{"type", "array"}, {"minItems", 1}, {"items", Reference("program")}};
  }
  return {};
}

Json SchemaOf(Section section) {
  Json properties = Json::object();
  for (const KeyRow* row : KeysOf(section)) {
    if (row->section != section) {
      properties[std::string(row->text)] = Reference("program/properties/" + std::string(row->text));
      continue;
    }
    Json schema = SchemaOf(row->shape);
    // Draft 7 looks at nothing beside a reference.
    if (schema.contains("$ref")) schema = {{"allOf", {schema}}};
    schema["description"] = std::string(row->meaning) + ". If it is left out: " + std::string(row->when_absent);
    properties[std::string(row->text)] = std::move(schema);
  }
  return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

}  // namespace

std::string Schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "plcxx.yaml"},
                 {"description", "A folder of programs for the controls of machine tools, as plcxx takes it"}};
  schema.update(SchemaOf(Section::kFile));
  schema["anyOf"] = {{{"required", {"sources"}}}, {{"required", {"programs"}}}};
  schema["definitions"] = {{"program", SchemaOf(Section::kProgram)},
                           {"warnings", SchemaOf(Section::kWarnings)},
                           {"target", SchemaOf(Section::kTarget)},
                           {"options", OptionsSchema()},
                           {"words", OneOrList(AnyWord())}};
  return schema.dump(2) + "\n";
}

}  // namespace plcxx::project
