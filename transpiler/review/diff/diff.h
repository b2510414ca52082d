// What `plcxx diff` has found out about two versions of a program, as a reader wants to know it.
//
// In: two programs, compiled. Out: one item for each named piece of state whose behaviour was compared. Not its job:
// the command line (diff_command.cc), how it is shown (diff_output.h).
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/diff/compare.h"

namespace plcxx::review::diff {

/// One side of a comparison: the program as it runs, and as it is proved about (the slow part in one piece).
struct DiffSide {
  std::string label;                        // as the user named it: "old/turret.plc", "v1.2"
  compilation::CompilationRequest request;  // for replaying scenarios
  std::string scenario_base;                // where the sources stand for scenarios; relative names are below it
  std::string hidden_prefix;                // of paths of its files, which is not shown: a copy of a revision
  std::string file_name;                    // not empty: its only source is a copy of this file
  compilation::Compilation compilation;     // as it runs
  ir::Program whole;                        // the slow part in one piece
  std::vector<std::vector<source::Range>> elsewhere;  // by statement of it: what it says in other lines
};

enum class ItemKind : uint8_t { kSchedule, kOutput, kCalls, kData, kRetentive, kInternal };
enum class ItemVerdict : uint8_t { kEqual, kDifferent, kUndecided };

struct ItemStatement {
  ir::StatementId statement;
  std::string file;
  uint32_t line = 0, column = 0;
  std::string text;      // its first line
  bool changed = false;  // the other version has no statement with this text
};

/// How a difference was seen.
enum class Replay : uint8_t {
  kSideBySide,  // both versions in the simulator; no scenario can say it, or the time was over
  kRefuted,     // the scenario does not pass on the old version, or passes on the new one
  kSimulator,   // the scenario passes on the old version and fails on the new one, in the simulator
  kCompiled     // and as generated code, compiled here
};

/// A difference that can be seen by running both versions.
struct Counterexample {
  std::string scenario;              // YAML; empty where none can say it
  std::string steps;                 // the same in one line: "I0A3=1, slow 1"; empty as above
  std::string old_value, new_value;  // of the item after the last step
  bool from_state = false;           // it begins with a state that is set; nobody knows whether the machine comes there
  Replay replay = Replay::kSideBySide;
  std::chrono::steady_clock::duration cost{};  // of running both versions beside each other
};

/// What both versions declare, in words: "10 ms" and "40 ms".
struct Declared {
  std::string old_text, new_text;
};

struct DiffItem {
  std::string name;     // "U4A8", "T5.done", "calls of fault", "period"
  std::string meaning;  // from the dialect's table or the program's comments; may be empty
  ItemKind kind{};
  ItemVerdict verdict{};
  /// Its own statements behave differently; else only what they read does.
  bool changed_itself = false;
  std::vector<ItemStatement> old_statements, new_statements;  // that write it
  std::vector<std::string> through;                           // differing items that these read
  std::string reason;                                         // of kUndecided
  std::optional<Counterexample> counterexample;
  std::optional<Declared> declared;  // of what is no behaviour: kSchedule, kData
};

struct Diff {
  std::vector<DiffItem> items;  // by their kind, each kind by address
  uint32_t equal = 0;           // items proved equal, which are not listed
  uint32_t invariants = 0;      // that their proofs needed
  /// Which items have a change of their own was found out: all others behave alike in every run in which those do.
  bool changes_are_found = false;
  std::string refusal;  // not empty: nothing was compared, and why
  /// Why what is shown was not run as generated code, where it should have been; else empty.
  std::string not_compiled;
  std::vector<ItemStatement> old_statements, new_statements;  // that the other version does not have
  /// Internal memory that one version writes and the other one does not use: it is how that version does something, and
  /// no item. A sentence of not_looked_at names it.
  std::vector<std::string> old_only, new_only;
  std::vector<std::string> of_slices;      // the same that there is only because the slow part is cut
  std::vector<std::string> not_looked_at;  // what no claim is made of, a sentence each
};

struct DiffOptions {
  std::vector<std::pair<std::string, std::string>> same;  // --map OLD=NEW, as scenarios write locations
  uint64_t time_ms = 60'000;
  /// From when on the time counts: who has read and compiled both versions has spent some of it. None: from the call.
  std::optional<std::chrono::steady_clock::time_point> begin;
  std::string scenario_directory;  // where scenarios will stand; their sources are named from there
  std::string compiler;            // what is shown is run as generated code, too; empty: in the simulator only
  std::function<void(const std::string& what)> progress;
};

/// Compiles one side; its diagnostics say what is wrong with it.
DiffSide MakeDiffSide(std::string label, const compilation::CompilationRequest& request,
                      const std::string& hidden_prefix = {});

/// Both sides compiled without errors. Wrong words of --map: `refusal`.
Diff CompareSides(DiffSide& old_side, DiffSide& new_side, const DiffOptions& options);

}  // namespace plcxx::review::diff
