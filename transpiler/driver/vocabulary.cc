#include "transpiler/driver/vocabulary.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/editing.h"

namespace plcxx::driver {
namespace {

using Json = nlohmann::ordered_json;
using dialects::TokenRole;

/// Roles that words of a language have; the others are of texts and places.
std::string_view NameOfRole(TokenRole role) {
  switch (role) {
    case TokenRole::kKeyword:
      return "keywords";
    case TokenRole::kMnemonic:
      return "mnemonics";
    case TokenRole::kFunction:
      return "functions";
    case TokenRole::kComment:
    case TokenRole::kAddress:
    case TokenRole::kName:
    case TokenRole::kMember:
    case TokenRole::kNumber:
    case TokenRole::kText:
    case TokenRole::kOperator:
      return "others";
  }
  return "others";
}

/// By role, then by name: what is written after a word.
Json WordsOfLanguage(const dialects::Dialect& dialect) {
  std::map<std::string_view, std::map<std::string, std::vector<std::string>>> by_role = {
      {"keywords", {}}, {"mnemonics", {}}, {"functions", {}}};
  for (const dialects::Word& word : dialects::EditingOf(dialect).words()) {
    std::vector<std::string>& parameters = by_role[NameOfRole(word.role)][word.name];
    // A word of several instructions: the one with operands says more.
    if (parameters.size() < word.parameters.size()) parameters = word.parameters;
  }
  return by_role;
}

}  // namespace

std::string VocabularyText() {
  Json vocabulary = Json::object();
  for (const dialects::Dialect* dialect : dialects::AllDialects()) {
    Json& row = vocabulary[std::string(dialect->name)];
    row = {{"title", dialect->title}, {"extensions", Json::array()}};
    for (const std::string_view extension : dialect->extensions) row["extensions"].push_back(extension);
    row.update(WordsOfLanguage(*dialect));
  }
  return vocabulary.dump(2) + "\n";
}

}  // namespace plcxx::driver
