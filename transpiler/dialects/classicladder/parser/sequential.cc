// Part sequential.csv: steps S, transitions T, their conditions C, comments N.

#include "transpiler/dialects/classicladder/parser/internal.h"

namespace plcxx::classicladder {
namespace {

/// After the letter.
Line WithoutLetter(Line line) {
  line.text.remove_prefix(1);
  ++line.range.begin;
  return line;
}

}  // namespace

void Parser::ParseStep(const Line& line) {
  const std::vector<Field> fields = FieldsOf(line);
  if (!HasFields(fields, 6, line, "step, initial, number, page, column, row")) return;
  Step step{.range = line.range};
  uint32_t index = 0;
  int32_t initial = 0;
  if (!ReadIndex(fields[0], "step", kSteps, index)) return;
  if (!ReadNumber(fields[1], "0 or 1, whether the step is an initial one,", initial)) return;
  if (!ReadIndex(fields[2], "number of a step", kSteps, step.number)) return;
  if (!ReadNumberIn(fields[3], "page", -1, kPages - 1, step.page)) return;
  step.initial = initial != 0;
  program_.steps[index] = step;
}

/// Ten numbers, of which those before the first -1 count.
bool Parser::ReadSteps(const std::vector<Field>& fields, size_t first, std::vector<uint32_t>& into) {
  bool counts = true;
  for (size_t i = 0; i < kSwitches; ++i) {
    int32_t step = 0;
    if (!ReadNumberIn(fields[first + i], "step", -1, kSteps - 1, step)) return false;
    counts = counts && step >= 0;
    if (counts) into.push_back(static_cast<uint32_t>(step));
  }
  return true;
}

void Parser::ParseTransition(const Line& line) {
  const std::vector<Field> fields = FieldsOf(line);
  constexpr size_t kLists = 4;
  if (!HasFields(fields, 1 + kLists * kSwitches + 3, line,
                 "transition, 10 steps to activate, 10 to deactivate, 20 links, page, column, row")) {
    return;
  }
  Transition transition{.range = line.range};
  uint32_t index = 0;
  if (!ReadIndex(fields[0], "transition", kTransitions, index)) return;
  if (!ReadSteps(fields, 1, transition.activates)) return;
  if (!ReadSteps(fields, 1 + kSwitches, transition.deactivates)) return;
  if (!ReadNumberIn(fields[1 + kLists * kSwitches], "page", -1, kPages - 1, transition.page)) return;
  const auto before = program_.transitions.find(index);
  if (before != program_.transitions.end()) transition.condition = before->second.condition;
  program_.transitions[index] = transition;
}

/// "C7,0,0/8": the engine passes over the second field.
void Parser::ParseCondition(const Line& line) {
  const std::vector<Field> fields = FieldsOf(line);
  uint32_t index = 0;
  if (!HasFields(fields, 3, line, "transition, 0, variable")) return;
  if (!ReadIndex(fields[0], "transition", kTransitions, index)) return;
  if (fields[1].text.size() != 1) {
    diagnostics_.Report(fields[1].range, diag::ClassicladderNumber, fields[1].text, "0");
    return;
  }
  Variable& condition = program_.transitions[index].condition;
  condition.range = fields[2].range;
  ReadVariable(fields[2].text, fields[2].range, condition.address);
}

void Parser::ParseSequential(const FilePart& part) {
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment) continue;
    if (line.kind == LineKind::kDirective) {
      if (!CheckVersion(part, line, 1)) return;
      continue;
    }
    const char letter = line.text.empty() ? '\0' : line.text.front();
    if (letter == 'S') {
      ParseStep(WithoutLetter(line));
    } else if (letter == 'T') {
      ParseTransition(WithoutLetter(line));
    } else if (letter == 'C') {
      ParseCondition(WithoutLetter(line));
    } else if (letter != 'N') {
      diagnostics_.Report(line.range, diag::ClassicladderLine, line.text, part.name);
    }
  }
}

}  // namespace plcxx::classicladder
