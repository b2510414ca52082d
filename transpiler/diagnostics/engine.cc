#include <algorithm>
#include <utility>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/support/check.h"

namespace plcxx::diag {
namespace {

/// Is the row named whole ("nc110-W356")?
bool NamesWhole(const std::set<std::string, std::less<>>& names, const Row& row) { return names.contains(row.code); }

/// Is the row named without its dialect ("W356")?
bool NamesShort(const std::set<std::string, std::less<>>& names, const Row& row) {
  return names.contains(row.code.substr(row.code.find('-') + 1));
}

/// A copy of a message may die before the diagnostic does; the catalogue's row does not.
const Row& Lasting(const Row& row) {
  const std::span<const Row> all = Catalogue();
  const auto found = std::ranges::find(all, row.key, &Row::key);
  return found == all.end() ? row : *found;
}

/// What makes a second report the same one.
std::string Identity(const Row& row, source::Range range, std::string_view text) {
  std::string identity(row.key);
  identity += ':' + std::to_string(range.begin) + ':' + std::to_string(range.end) + ':';
  return identity += text;
}

}  // namespace

std::string Format(std::string_view pattern, const std::vector<std::string>& args) {
  std::string text;
  for (size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '{') {
      text += pattern[i];
    } else if (i + 1 < pattern.size() && pattern[i + 1] == '{') {
      text += '{';
      ++i;
    } else {
      PLCXX_CHECK(i + 2 < pattern.size() && pattern[i + 2] == '}');
      const size_t index = static_cast<size_t>(pattern[i + 1]) - '0';
      PLCXX_CHECK(index < args.size());
      text += args[index];
      i += 2;
    }
  }
  return text;
}

bool Engine::Enabled(const Row& row) const {
  if (row.severity == Severity::kError) return true;
  // The whole name decides before the short one, which means the code of every dialect.
  if (NamesWhole(options_.disabled, row)) return false;
  if (NamesWhole(options_.enabled, row) || NamesWhole(options_.errors, row)) return true;
  if (NamesShort(options_.disabled, row)) return false;
  if (NamesShort(options_.enabled, row) || NamesShort(options_.errors, row)) return true;
  return !row.off_by_default;
}

Diagnostic& Engine::Add(source::Range range, const Row& row, const std::vector<std::string>& args) {
  discarded_ = {};
  if (!Enabled(row)) return discarded_;
  const bool as_error = (options_.all_errors && row.severity == Severity::kWarning) ||
                        NamesWhole(options_.errors, row) || NamesShort(options_.errors, row);
  const Severity severity = as_error ? Severity::kError : row.severity;
  if (!HasRoom(severity)) return discarded_;
  std::string text = Format(row.text, args);
  if (!reported_.insert(Identity(row, range, text)).second) return discarded_;

  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.row = &Lasting(row);
  diagnostic.severity = severity;
  diagnostic.range = range;
  diagnostic.text = std::move(text);
  diagnostic.remedy = Format(row.remedy, args);
  ++CountOf(diagnostic.severity);
  return diagnostic;
}

bool Engine::HasRoom(Severity severity) {
  uint32_t& not_kept = not_kept_[static_cast<size_t>(severity)];
  if (CountOf(severity) - not_kept < kMostKept) return true;
  ++CountOf(severity);
  ++not_kept;
  return false;
}

Engine Engine::Fork() const {
  Engine fork = *this;
  fork.forked_at_ = diagnostics_.size();
  fork.not_kept_at_fork_ = not_kept_;
  return fork;
}

void Engine::Join(Engine fork) {
  for (size_t i = fork.forked_at_; i < fork.diagnostics_.size(); ++i) {
    Diagnostic& found = fork.diagnostics_[i];
    if (!HasRoom(found.severity) || !reported_.insert(Identity(*found.row, found.range, found.text)).second) continue;
    ++CountOf(found.severity);
    diagnostics_.push_back(std::move(found));
  }
  for (const Severity severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    const auto index = static_cast<size_t>(severity);
    const uint32_t more = fork.not_kept_[index] - fork.not_kept_at_fork_[index];
    not_kept_[index] += more;
    CountOf(severity) += more;
  }
}

uint32_t& Engine::CountOf(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return error_count_;
    case Severity::kWarning:
      return warning_count_;
    case Severity::kNote:
      return note_count_;
  }
  PLCXX_UNREACHABLE();
}

void Engine::Recount() {
  error_count_ = not_kept_[static_cast<size_t>(Severity::kError)];
  warning_count_ = not_kept_[static_cast<size_t>(Severity::kWarning)];
  note_count_ = not_kept_[static_cast<size_t>(Severity::kNote)];
  reported_.clear();
  for (const Diagnostic& kept : diagnostics_) {
    ++CountOf(kept.severity);
    reported_.insert(Identity(*kept.row, kept.range, kept.text));
  }
}

void Engine::SortBySource() {
  // Offsets grow with the files in their order of loading, so one number orders file, line and column.
  std::ranges::stable_sort(diagnostics_, {}, [](const Diagnostic& diagnostic) { return diagnostic.range.begin; });
}

void Engine::KeepFirstErrorOnly() {
  SortBySource();
  const auto first = std::ranges::find(diagnostics_, Severity::kError, &Diagnostic::severity);
  if (first == diagnostics_.end()) return;
  diagnostics_.erase(first + 1, diagnostics_.end());
  not_kept_ = {};
  Recount();
}

void Engine::MovePlaces(const std::function<source::Range(source::Range)>& move) {
  for (Diagnostic& diagnostic : diagnostics_) {
    const source::Range place = move(diagnostic.range);
    if (place == diagnostic.range) continue;
    diagnostic.notes.push_back({diagnostic.range, "it is here"});
    diagnostic.range = place;
  }
  Recount();
}

void Engine::LimitErrors(uint32_t most) {
  PLCXX_CHECK(most > 0);
  if (error_count_ <= most) return;
  SortBySource();
  std::vector<Diagnostic> kept;
  size_t last = 0;  // the last error in `kept`
  uint32_t errors = 0;
  for (Diagnostic& diagnostic : diagnostics_) {
    const bool error = diagnostic.severity == Severity::kError;
    if (error && ++errors > most) {
      if (errors == most + 1) kept[last].notes.push_back({diagnostic.range, "errors from here on are not shown"});
      continue;
    }
    if (error) last = kept.size();
    kept.push_back(std::move(diagnostic));
  }
  diagnostics_ = std::move(kept);
  not_kept_[static_cast<size_t>(Severity::kError)] = 0;
  Recount();
}

}  // namespace plcxx::diag
