#include "transpiler/dialects/prostep/parser/label_reader.h"

#include <algorithm>

namespace plcxx::prostep {
namespace {

/// "PM", "FM20": they would collide with the calls of modules.
bool IsReserved(std::string_view name) {
  return (name.starts_with("PM") || name.starts_with("FM")) && std::ranges::all_of(name.substr(2), IsDigit);
}

}  // namespace

const Token* LabelReader::TheLabel(const Statement& statement) {
  if (statement.labels.empty()) return nullptr;
  if (std::ranges::any_of(statement.labels, &Token::faulty)) return nullptr;
  if (statement.labels.size() == 1) return &statement.labels.front();
  const source::Range range = {statement.labels.front().range.begin, statement.labels.back().range.end};
  diagnostics_.Report(range, diag::ProstepLabelWords, sources_.Text(range));
  return nullptr;
}

bool LabelReader::IsLabel(std::string_view name, source::Range range) {
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

void LabelReader::DefineLabel(const Token& token) {
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
      {.name = name, .range = token.range, .module = now_.module, .at = InstructionId(program_.instructions.size())});
  labels_.emplace(std::move(name), id);
}

const PendingJump* LabelReader::JumpOfNextInstruction() const {
  const bool jumps = !jumps_.empty() && jumps_.back().instruction.index == program_.instructions.size();
  return jumps ? &jumps_.back() : nullptr;
}

void LabelReader::EndModule(const Module& module) {
  for (const PendingJump& jump : jumps_) {
    const auto label = labels_.find(jump.name);
    if (label == labels_.end()) {
      program_.instructions[jump.instruction].faulty = true;
      // Blocks of STEP 5 and STEP 7.
      constexpr std::string_view kBlocks[] = {"PB", "FB", "SB", "OB", "FC"};
      if (std::ranges::find(kBlocks, jump.name) != std::end(kBlocks)) {
        diagnostics_.Report(jump.range, diag::ProstepLabelUndefinedHint, jump.name,
                            "modules are PM, those of the control FM: JU PM 20, with a condition JC PM 20");
      } else {
        diagnostics_.Report(jump.range, diag::ProstepLabelUndefined, jump.name);
      }
      continue;
    }
    program_.instructions[jump.instruction].target = label->second;
    ++program_.labels[label->second].uses;
  }
  // Labels in front of END stand after the last instruction: where the module ends.
  PLCXX_CHECK(module.labels.first + module.labels.count == program_.labels.size());
  labels_.clear();
  jumps_.clear();
}

}  // namespace plcxx::prostep
