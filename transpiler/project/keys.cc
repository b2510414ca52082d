#include "transpiler/project/keys.h"

#include "transpiler/compile/target.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/host/host.h"
#include "transpiler/source/source.h"

namespace plcxx::project {
namespace {

constexpr KeyRow kKeys[] = {
#define PLCXX_PROJECT_KEY(SectionOf, Id, Text, ShapeOf, Meaning, Default) \
  {Section::k##SectionOf, Key::k##Id, Text, Shape::ShapeOf, Meaning, Default},
#include "transpiler/project/keys.def"
#undef PLCXX_PROJECT_KEY
};

}  // namespace

std::span<const KeyRow> Keys() { return kKeys; }

std::vector<const KeyRow*> KeysOf(Section section) {
  std::vector<const KeyRow*> rows;
  for (const KeyRow& row : kKeys) {
    if (row.section == section || (section == Section::kFile && row.section == Section::kProgram)) rows.push_back(&row);
  }
  return rows;
}

const KeyRow* FindKey(Section section, std::string_view text) {
  for (const KeyRow* row : KeysOf(section)) {
    if (row->text == text) return row;
  }
  return nullptr;
}

std::vector<std::string> WordsOf(Shape shape) {
  std::vector<std::string> words;
  switch (shape) {
    case Shape::kDialect:
      for (const dialects::Dialect* dialect : dialects::AllDialects()) words.emplace_back(dialect->name);
      break;
    case Shape::kEncoding:
      words.emplace_back("auto");
      for (const std::string_view name : source::EncodingNames()) words.emplace_back(name);
      break;
    case Shape::kLevel:
      words = {"0", "1", "2", "3", "s", "z"};
      break;
    case Shape::kHost:
      for (const host::HostRow& row : host::Hosts()) words.emplace_back(row.text);
      break;
    case Shape::kTargets:
      for (const compile::Target& target : compile::Targets()) words.emplace_back(target.name);
      break;
    case Shape::kWord:
    case Shape::kWords:
    case Shape::kNumber:
    case Shape::kFileName:
    case Shape::kPath:
    case Shape::kPaths:
    case Shape::kGlobs:
    case Shape::kFrequency:
    case Shape::kOptions:
    case Shape::kMacros:
    case Shape::kWarningNames:
    case Shape::kWarningNamesOrAll:
    case Shape::kWarnings:
    case Shape::kPrograms:
      break;
  }
  return words;
}

}  // namespace plcxx::project
