// Diagnostics: declared once in catalogue.def with typed parameters, collected by the Engine, rendered elsewhere.
//
// In: ranges and parameters from any phase. Out: a list ordered by file, line, column. Not its job: text layout.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::diag {

/// A note tells of a choice that the specification made where a control may differ; it is no reason to change a
/// program.
enum class Severity : uint8_t { kError, kWarning, kNote };

/// One row of the catalogue. Several rows may share a code (the original compilers' codes are coarse);
/// the key is unique.
struct Row {
  std::string_view key;   // "Nc110ConnectorRange"
  std::string_view code;  // "nc110-1"
  Severity severity;
  std::string_view text;    // "operand '{0}': connector {1} is outside 0 to {2}"
  std::string_view remedy;  // what to do; shown as "help:"; may use the same parameters
  bool off_by_default = false;
};

/// A row together with the types of its parameters.
template <class... Args>
struct Message {
  Row row;
};

using Text = std::string_view;
using Number = int64_t;

// Rows: PLCXX_DIAG(Key, "code", Severity, (parameter types), "text", "remedy")
#define PLCXX_DIAG_UNWRAP(...) __VA_ARGS__
#define PLCXX_DIAG(Key, Code, Sev, Params, What, Remedy) \
  inline constexpr Message<PLCXX_DIAG_UNWRAP Params> Key{{#Key, Code, Severity::Sev, What, Remedy}};
#define PLCXX_DIAG_OFF(Key, Code, Sev, Params, What, Remedy) \
  inline constexpr Message<PLCXX_DIAG_UNWRAP Params> Key{{#Key, Code, Severity::Sev, What, Remedy, true}};
#include "transpiler/diagnostics/catalogue.def"
#undef PLCXX_DIAG
#undef PLCXX_DIAG_OFF

/// All rows in the catalogue's order.
std::span<const Row> Catalogue();

struct Note {
  source::Range range;
  std::string text;
};

/// Replace `range` by `replacement` (empty: delete). Only offered where applying it compiles.
struct FixIt {
  source::Range range;
  std::string replacement;
};

struct Diagnostic {
  const Row* row = nullptr;
  Severity severity = Severity::kError;  // after -W, -Wno-, -Werror
  source::Range range;
  std::string text;
  std::string remedy;
  std::vector<Note> notes;
  std::vector<FixIt> fixits;
};

/// What -W<name>, -Wno-<name>, -Werror and -Werror=<name> ask for. A name is a code without its dialect ("W356") or
/// whole ("nc110-W356").
struct WarningOptions {
  std::set<std::string, std::less<>> enabled, disabled, errors;
  bool all_errors = false;
};

class Engine {
 public:
  explicit Engine(WarningOptions options = {}) : options_(std::move(options)) {}

  /// Reports with the smallest range that shows the fault. The result takes notes and fix-its until the next Report.
  /// The same row, range and text again is kept once.
  template <class... Args>
  Diagnostic& Report(source::Range range, const Message<Args...>& message, std::type_identity_t<Args>... args) {
    std::vector<std::string> texts;
    (texts.push_back(ToText(args)), ...);
    return Add(range, message.row, texts);
  }
  /// The same for a row with its parameters as texts: what was found where there is no engine, and is reported later.
  Diagnostic& ReportRow(source::Range range, const Row& row, const std::vector<std::string>& texts) {
    return Add(range, row, texts);
  }

  /// One that goes on from here: it knows what has been reported, and reports on its own until it is joined. For
  /// phases that read the same and run beside one another.
  Engine Fork() const;
  /// Takes what a fork of this one has reported since, behind what was reported here; the same again is kept once.
  void Join(Engine fork);

  /// Of each severity so many are kept; more are only counted, so that a file of errors does not fill the memory.
  static constexpr uint32_t kMostKept = 20'000;

  bool HasErrors() const { return error_count_ > 0; }
  uint32_t error_count() const { return error_count_; }
  uint32_t warning_count() const { return warning_count_; }
  uint32_t note_count() const { return note_count_; }
  /// Would a row be shown at all (not disabled)? For checks that cost time.
  bool Enabled(const Row& row) const;
  /// Shows a row that is off by default, as its -W would; -Wno- still wins.
  void Enable(const Row& row) { options_.enabled.emplace(row.code.substr(row.code.find('-') + 1)); }
  /// Reports a warning as an error from now on, as its -Werror= would; -Wno- still wins.
  void MakeError(const Row& row) { options_.errors.emplace(row.code.substr(row.code.find('-') + 1)); }
  /// In source order (file, line, column); ties keep the order of detection.
  void SortBySource();
  const std::vector<Diagnostic>& all() const { return diagnostics_; }
  /// Drops everything after the first error (in source order); sorts.
  void KeepFirstErrorOnly();
  /// Drops the errors after the first `most` (in source order) and says so at the last one; sorts.
  void LimitErrors(uint32_t most);
  /// Moves what has been reported to the place that `move` gives for its own; where it stood becomes a note.
  void MovePlaces(const std::function<source::Range(source::Range)>& move);

 private:
  static std::string ToText(Text text) { return std::string(text); }
  static std::string ToText(Number number) { return std::to_string(number); }
  Diagnostic& Add(source::Range range, const Row& row, const std::vector<std::string>& args);
  /// Whether one more is kept; else it is counted.
  bool HasRoom(Severity severity);
  uint32_t& CountOf(Severity severity);
  void Recount();

  WarningOptions options_;
  std::vector<Diagnostic> diagnostics_;
  std::unordered_set<std::string> reported_;  // only asked, never walked through
  Diagnostic discarded_;                      // what Report returns for a disabled warning and for a repetition
  uint32_t error_count_ = 0;
  uint32_t warning_count_ = 0;
  uint32_t note_count_ = 0;
  std::array<uint32_t, 3> not_kept_ = {};  // by severity
  // Of a fork: how many of them are its origin's.
  size_t forked_at_ = 0;
  std::array<uint32_t, 3> not_kept_at_fork_ = {};
};

/// "{0}" ... "{9}" replaced by the arguments; "{{" is a brace.
std::string Format(std::string_view pattern, const std::vector<std::string>& args);

}  // namespace plcxx::diag
