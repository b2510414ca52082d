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
  std::string text = Format(row.text, args);
  if (!reported_.insert(Identity(row, range, text)).second) return discarded_;

  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.row = &Lasting(row);
  diagnostic.severity = row.severity;
  const bool as_error = options_.all_errors || NamesWhole(options_.errors, row) || NamesShort(options_.errors, row);
  if (as_error) diagnostic.severity = Severity::kError;
  diagnostic.range = range;
  diagnostic.text = std::move(text);
  diagnostic.remedy = Format(row.remedy, args);
  ++(diagnostic.severity == Severity::kError ? error_count_ : warning_count_);
  return diagnostic;
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
  error_count_ = 1;
  warning_count_ = static_cast<uint32_t>(diagnostics_.size()) - 1;
  reported_.clear();
  for (const Diagnostic& kept : diagnostics_) reported_.insert(Identity(*kept.row, kept.range, kept.text));
}

}  // namespace plcxx::diag
