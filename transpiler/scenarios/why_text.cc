// Explanations as indented lines.
#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/scenarios/failure.h"
#include "transpiler/scenarios/why.h"

namespace plcxx::scenarios {
namespace {

using explanation::Condition;
using explanation::ConditionKind;

/// Deeper reasons are there, but nobody reads a line that begins in the middle of the screen.
constexpr size_t kMaxIndent = 40;

std::string TimeOf(const sim::LastWrite& write) { return std::to_string(write.first_ms) + " ms"; }

/// Without what an empty line parts from the comments after it: the head of a file, the title of a section.
std::span<const source::Range> OwnComments(const ir::Statement& statement, const source::SourceManager& sources) {
  const std::span<const source::Range> all = statement.comments;
  if (all.size() < 2) return all;
  const uint32_t begin = sources.Locate(statement.range.begin).line;
  size_t first = 0;
  for (size_t i = 1; i < all.size(); ++i) {
    const uint32_t line = sources.Locate(all[i].begin).line;
    if (line <= begin && line > sources.Locate(all[i - 1].end).line + 1) first = i;
  }
  return all.subspan(first);
}

std::string CommentOf(ir::StatementId statement, const ir::Program& program, const source::SourceManager& sources) {
  if (!statement.valid() || sources.size() == 0) return {};
  for (const source::Range& range : OwnComments(program.statements[statement], sources)) {
    std::string text(sources.Text(range));
    const auto is_mark = [](unsigned char c) { return c <= ' ' || c == ';' || c == '/' || c == '*' || c == '#'; };
    while (!text.empty() && is_mark(static_cast<unsigned char>(text.front()))) text.erase(0, 1);
    while (!text.empty() && is_mark(static_cast<unsigned char>(text.back()))) text.pop_back();
    if (!text.empty()) return text;
  }
  return {};
}

std::string Written(ir::StatementId statement, const ir::Program& program, const source::SourceManager& sources) {
  const std::string comment = CommentOf(statement, program, sources);
  return StatementPlace(statement, program, sources) + (comment.empty() ? "" : "  (" + comment + ")");
}

class Writer {
 public:
  Writer(const WhyAnswer& answer, const ir::Program& program, const source::SourceManager& sources, size_t most_lines)
      : conditions_(answer.conditions),
        program_(program),
        sources_(sources),
        most_lines_(most_lines),
        shown_(answer.conditions.size()) {}

  std::string Write() {
    for (const uint32_t reason : conditions_.front().because) WriteBelow(reason, 2);
    if (left_out_ > 0) text_ += "  ... and more: plcxx why --format json has all of it\n";
    return std::move(text_);
  }

 private:
  void WriteBelow(uint32_t number, size_t indent) {
    if (explanation::IsBookkeeping(conditions_, number)) return;
    if (lines_ == most_lines_) {
      ++left_out_;
      return;
    }
    ++lines_;
    const Condition& condition = conditions_[number];
    text_ += std::string(std::min(indent, kMaxIndent), ' ') + condition.name + " " + condition.predicate + ": ";
    if (shown_[number]) {
      text_ += "see above\n";
      return;
    }
    shown_[number] = true;
    text_ += OriginText(condition, program_, sources_) + "\n";
    for (const uint32_t reason : condition.because) WriteBelow(reason, indent + 2);
  }

  const std::vector<Condition>& conditions_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  size_t most_lines_;
  std::vector<bool> shown_;
  size_t lines_ = 0, left_out_ = 0;
  std::string text_;
};

}  // namespace

std::string OriginText(const Condition& condition, const ir::Program& program, const source::SourceManager& sources) {
  const std::optional<sim::LastWrite>& write = condition.last_write;
  switch (condition.kind) {
    case ConditionKind::kWritten:
      return Written(condition.statement, program, sources);
    case ConditionKind::kInput:
      return write ? "set by the scenario or the control at " + TimeOf(*write) : "as at power-on";
    case ConditionKind::kKept:
      return "since " + TimeOf(*write) + ", by " +
             Written(condition.statement.valid() ? condition.statement : write->statement, program, sources);
    case ConditionKind::kState:
      return write && write->writer == sim::Writer::kProgram ? "kept by " + Written(write->statement, program, sources)
                                                             : "kept from the scan before";
    case ConditionKind::kForced:
      return "forced by the scenario";
    case ConditionKind::kAnswer:
      return "what the control answers";
  }
  return {};
}

std::string WhyText(const WhyAnswer& answer, const WhyQuestion& question, const compilation::Compilation& compilation,
                    size_t most_lines) {
  std::string text = question.name + " is " + answer.value + " at " + std::to_string(answer.time_ms) + " ms";
  if (!answer.has_run) return question.name + " is " + answer.value + ": nothing has run since power-on\n";
  if (!answer.refusal.empty()) return text + "; why is not known: " + answer.refusal + "\n";
  text += ": " + OriginText(answer.conditions.front(), compilation.program, *compilation.sources) + "\n";
  return text + Writer(answer, compilation.program, *compilation.sources, most_lines).Write();
}

}  // namespace plcxx::scenarios
