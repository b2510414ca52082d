// From names of files to a program that can be emitted or run: the phases of the design in their order.
//
// In: what the command line or a scenario asks for. Out: everything that a subcommand prints, writes or executes.
// All that is wrong with the sources is in `diagnostics`; nothing here prints, and nothing ends the process.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::compilation {

inline constexpr uint64_t kNsPerUs = 1000;

struct CompilationRequest {
  std::vector<std::string> sources;  // the program, in the user's order; "-" is standard input
  /// Files that stand in memory and not on the disk, by their paths relative to base_directory, as in `sources`.
  std::map<std::string, std::string> texts;
  std::string dialect;                       // empty: by extension, then by content
  std::optional<source::Encoding> encoding;  // none: detected
  /// --set key=value, then `options:` of a scenario: of two with one name the later one counts.
  std::vector<std::pair<std::string, std::string>> options;
  diag::WarningOptions warnings;
  /// Where relative paths of `sources` and of options stand; empty: the current directory.
  std::string base_directory;
  std::vector<std::string> include_directories;  // -I, searched for the files that options name, after base_directory
  std::vector<std::string> system_include_directories;  // --system-include
  std::vector<dialects::MacroOption> macros;            // -D and -U
  std::string name;                                     // of the program; empty: from the first logic source
  dialects::Lists lists = dialects::Lists::kAll;
  std::unique_ptr<dialects::Kept>* kept = nullptr;  // as in dialects::Request
  /// Called before each phase with its name, for a progress line; may be empty.
  std::function<void(std::string_view phase)> progress;
};

/// Compile stops after this phase: what comes later is for emitting and running only.
enum class Stage : uint8_t {
  kLoaded,      // dialect known, files read, options checked
  kLowered,     // ir
  kStructured,  // ir-structured; the checks have not run
  kChecked,     // all diagnostics are there, budgets included
  kOptimized    // ir-optimized: slices cut, ready for emit::legalize::Legalize and the simulator
};

/// What one partition costs, as the cost model sees it.
struct PartitionEstimate {
  std::string name;  // "fast", "slow"
  ir::RoutineKind kind{};
  uint64_t time_ns = 0;
  uint64_t code_bytes = 0;
};

/// The compile report, without what only the diagnostics know.
struct Estimates {
  std::vector<PartitionEstimate> partitions;  // fast before slow; only those that the program has
  uint32_t slices = 1;
  uint32_t slow_period_ms = 0;  // of a whole slow part; 0: none that is the same for each
};

struct Compilation {
  std::unique_ptr<source::SourceManager> sources;
  diag::Engine diagnostics;                    // sorted by source
  const dialects::Dialect* dialect = nullptr;  // none when it could not be told
  std::map<std::string, std::string> options;  // each once, its name as the dialect writes it
  std::vector<source::FileId> files;           // of the program; what options name is in `sources` only
  std::string name;                            // of the program and its output files, made safe
  ir::Program program;                         // as far as `reached` says
  dialects::SourceSummary summary;
  std::vector<dialects::DataFile> data_files;
  bool has_program = true;       // false: the sources are data only
  Estimates estimates;           // from kChecked on
  std::optional<Stage> reached;  // the last stage without errors
  bool wrong_use = false;        // the errors are of the command line, not of the program

  bool ok() const { return !diagnostics.HasErrors(); }
  /// For the dialect's printing functions.
  dialects::Request MakeRequest();

  dialects::FileLoader load;  // paths of options; refers to `sources`
  std::optional<source::Encoding> encoding;
  std::vector<std::string> include_directories, system_include_directories;
  std::vector<dialects::MacroOption> macros;
  ir::Facts facts = ir::Facts::kTrusted;  // by the option kFactsOption
};

/// Of --set and of scenarios, for every dialect: "trusted" or "checked".
inline constexpr std::string_view kFactsOption = "facts";

/// Never fails as a call: after an error the later stages are left out.
Compilation Compile(const CompilationRequest& request, Stage until = Stage::kOptimized);

/// A compilation that stopped at Stage::kChecked without errors goes on to kOptimized.
void OptimizeProgram(Compilation& compilation);

/// A name for a program, its files and its namespace, made of any text.
std::string NameFrom(std::string_view text);

}  // namespace plcxx::compilation
