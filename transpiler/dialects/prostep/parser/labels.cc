// Labels (specification 2.3).
#include <algorithm>

#include "transpiler/dialects/prostep/parser/internal.h"

namespace plcxx::prostep {
namespace {

/// "PM", "FM20": they would collide with the calls of modules.
bool IsReserved(std::string_view name) {
  return (name.starts_with("PM") || name.starts_with("FM")) && std::ranges::all_of(name.substr(2), IsDigit);
}

}  // namespace

const Token* Parser::TheLabel(const Statement& statement) {
  if (statement.labels.empty()) return nullptr;
  if (std::ranges::any_of(statement.labels, &Token::faulty)) return nullptr;
  if (statement.labels.size() == 1) return &statement.labels.front();
  const source::Range range = {statement.labels.front().range.begin, statement.labels.back().range.end};
  diagnostics_.Report(range, diag::ProstepLabelWords, sources_.Text(range));
  return nullptr;
}

bool Parser::IsLabel(std::string_view name, source::Range range) {
  if (!IsLetter(name.front())) {
    diagnostics_.Report(range, diag::ProstepLabelStart, name);
    return false;
  }
  constexpr std::string_view kNotInLabels = ",:";
  if (const size_t at = name.find_first_of(kNotInLabels); at != std::string_view::npos) {
    diagnostics_.Report(range, diag::ProstepLabelCharacter, name, name.substr(at, 1));
    return false;
  }
  if (name.size() > kLabelLength) {
    diagnostics_.Report(range, diag::ProstepLabelLength, name, static_cast<int64_t>(name.size()));
    return false;
  }
  return true;
}

void Parser::DefineLabel(const Token& token) {
  const std::string_view text = TextOf(token);
  std::string name = Upper(text);
  if (IsReserved(name)) {
    diagnostics_.Report(token.range, diag::ProstepLabelReserved, text);
    return;
  }
  if (!IsLabel(text, token.range)) return;
  brackets_.Label(text, token.range);
  const auto known = labels_.find(name);
  if (known != labels_.end()) {
    diagnostics_.Report(token.range, diag::ProstepLabelTwice, text)
        .notes.push_back({program_.labels[known->second].range, "first defined here"});
    return;
  }
  const LabelId id = program_.labels.Add(
      {.name = name, .range = token.range, .module = module_, .at = InstructionId(program_.instructions.size())});
  labels_.emplace(std::move(name), id);
}

}  // namespace plcxx::prostep
