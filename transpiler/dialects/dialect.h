// What the driver knows of a dialect: names, options, and the functions from source to IR.
//
// One Dialect object per dialect, listed in registry.cc. Everything a later phase needs is in the ir::Program that
// Lower gives; the other functions serve the command line (printing phases, naming locations, simulating the control).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/lints.h"
#include "transpiler/ir/facts.h"
#include "transpiler/ir/name_index.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::dialects {

/// One `--set key=value`; the table of a dialect's options feeds --help, validation and scenario files.
struct OptionInfo {
  std::string_view key;
  std::string_view values;         // "P,S in ms", "on|off", "file"
  std::string_view default_value;  // as text; empty: none
  std::string_view meaning;
  bool is_of_simulation = false;  // of the simulated control: no part of the program
  /// Options that each set a part of what this one sets: where it stands behind them, they say nothing more.
  std::span<const std::string_view> replaces = {};
};

/// Reads a file that an option or an include names; the place where it is named is the caller's to report.
using FileLoader = std::function<std::variant<source::FileId, source::LoadError>(const std::string& path)>;

/// -D NAME[=TEXT] or -U NAME.
struct MacroOption {
  std::string name;
  std::optional<std::string> text;  // none: -U
};

/// Whether the lists of a report are made (SourceSummary::tables), which nobody reads while a program is being typed.
enum class Lists : uint8_t { kNone, kAll };

/// What a dialect keeps of one run for the next one of nearly the same program. Only the dialect knows what it is.
class Kept {
 public:
  virtual ~Kept() = default;
};

struct Request {
  source::SourceManager* sources = nullptr;
  std::vector<source::FileId> files;           // the program, in the user's order
  std::map<std::string, std::string> options;  // validated keys; values as written
  FileLoader load;                             // paths of options, already relative to where the option stands
  diag::Engine* diagnostics = nullptr;
  std::optional<source::Encoding> encoding;             // that the user chose, also for the files that sources include
  std::vector<std::string> include_directories;         // -I
  std::vector<std::string> system_include_directories;  // --system-include
  std::vector<MacroOption> macros;                      // -D and -U in their order
  ir::Facts facts = ir::Facts::kTrusted;                // whether what decisions rest on becomes assertions
  Lists lists = Lists::kAll;
  /// Of the last run with the same object, and then of this one; null: nothing is kept. The result is the same.
  std::unique_ptr<Kept>* kept = nullptr;
};

/// What the program uses of what the control has.
struct ResourceUse {
  std::string_view name;
  uint32_t used = 0;
  uint32_t available = 0;
};

/// A number under which the program reports an error to the operator, and one statement that does.
struct RaisedError {
  uint32_t main = 0, sub = 0;
  source::Range range;
};

/// A list that the specification of a dialect asks for beside the program: handlers, alarms, limits.
struct SummaryTable {
  std::string name;  // a word: "handlers"
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as `columns`
};

/// What the compile report tells of the source.
struct SourceSummary {
  uint32_t lines = 0;
  uint32_t statements = 0;
  std::vector<RaisedError> raised_errors = {};  // by number, then by place
  std::vector<ResourceUse> resources;           // in the order of the control's own page; empty: it has none
  std::vector<SummaryTable> tables = {};
};

/// What emit writes beside the C++.
struct DataFile {
  std::string name;  // without directory
  std::string bytes;
};

struct Lowered {
  ir::Program program;
  SourceSummary summary;
  std::vector<DataFile> data_files;
  bool has_program = true;  // false: the sources are data only, and there is no C++ to write
};

/// A place in a scenario or a watch list: memory, a field of an instance, a port of the simulated control, or the
/// operator's keyboard.
struct Location {
  ir::Place place;          // need not be one of the program's places; a field place names an instance of the program
  bool text_input = false;  // `set` sends a text; nothing can be read
  /// An instance that the program does not use: always 0, cannot be written. `place.type` still tells its type.
  bool absent = false;
  /// No memory but the simulated control's own, a number that its stub gives a meaning: `place` has a name and a type
  /// only, ControlStub::ReadCell and WriteCell are what `expect` and `set` do. Cannot be forced.
  std::optional<uint32_t> cell;
  bool has_sign = false;  // people read the integer as two's complement
  /// Not empty: an integer of so many bits (a bit-field), each at a place of its own, the lowest first. `place` is the
  /// whole number that they are a part of.
  std::vector<ir::Place> bits;
};

/// Reads and writes the bytes that a control exchanges with the PLC program.
class ImagePort {
 public:
  virtual ~ImagePort() = default;
  virtual uint8_t Get(ir::SpaceId space, uint32_t offset) const = 0;
  virtual void Set(ir::SpaceId space, uint32_t offset, uint8_t value) = 0;
  /// Set for each of them, from `offset` on: a control hands over whole areas, of which nearly nothing has changed.
  virtual void SetAll(ir::SpaceId space, uint32_t offset, std::span<const uint8_t> values) {
    for (const uint8_t value : values) Set(space, offset++, value);
  }
  /// The control takes the retentive memory into its store.
  virtual void StoreRetentive() = 0;
  /// The control looks at the message bits now; it does so at the end of each period in any case.
  virtual void LookAtMessages() = 0;
};

/// A simulated control that answers the program's requests. It lives as long as a scenario: a power cycle is a call.
class ControlStub {
 public:
  virtual ~ControlStub() = default;
  /// The same control at the same moment: a simulation that goes back to it goes on with this one, maybe that of
  /// another machine. So a control keeps no image beyond a call.
  virtual std::unique_ptr<ControlStub> Clone() const = 0;
  /// Whether it is at the same moment as another one of the same control: both go on alike. False: or it cannot tell.
  virtual bool IsAtMomentOf(const ControlStub& /*other*/) const { return false; }
  /// Power fails: before the init of a power cycle, not before the first one. What the machine holds (inputs) stays.
  virtual void PowerOff() {}
  /// Right after init, at the first power-on, too. Host calls of init have come before.
  virtual void PowerOn(ImagePort&) {}
  /// Right before a period: what the control writes.
  virtual void BeforePeriod(uint32_t /*now_ms*/, ImagePort&) {}
  /// Right after a period: what the control sees. `slow_cycles` counts completed slow cycles.
  virtual void AfterPeriod(uint32_t /*now_ms*/, uint32_t /*slow_cycles*/, ImagePort&) {}

  /// A host call while the program runs, the regular exchange included; not the time and the store of retentive memory,
  /// which the simulation keeps. Gives the call's result, and in `out` its second result (none: the program's place
  /// keeps its value); floats as their bits. The image is that of this moment, and what is written into it the program
  /// sees after the call: only a function with HostAccess::kWritesState may write.
  virtual uint64_t Call(const ir::HostFunction& /*function*/, std::span<const uint64_t> /*arguments*/, ImagePort&,
                        std::optional<uint64_t>& /*out*/) {
    return 0;
  }
  /// A scenario is about to set a place. True: the control takes the value, and memory keeps its own until the control
  /// delivers it.
  virtual bool Takes(const ir::Place&, uint64_t /*value*/) { return false; }
  /// A scenario has set a place, and the image holds the value. True: the control goes on writing this place (an input
  /// whose new level it delivers from now on). False: it leaves the place to the scenario until the next power-on.
  virtual bool Written(const ir::Place&, uint64_t /*value*/, ImagePort&) { return false; }

  /// What Location::cell names.
  virtual uint64_t ReadCell(uint32_t /*cell*/, const ImagePort&) { return 0; }
  virtual void WriteCell(uint32_t /*cell*/, uint64_t /*value*/, ImagePort&) {}
};

enum class Budget : uint8_t { kFastUs, kSlowMs, kCodeKb };

struct Dialect {
  std::string_view name;                         // "nc110"
  std::string_view title;                        // "Balt-System NC-110 ... NC-400"
  std::span<const std::string_view> extensions;  // ".plc"
  std::span<const OptionInfo> options;
  source::LoadOptions load;  // how its sources are read
  /// Does the text look like this dialect? For sources without a telling extension.
  bool (*recognize)(std::string_view text);
  /// Reports a source that cannot be read, by the dialect's own code.
  void (*report_load_error)(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics);
  /// Checks keys and values without reading sources; reports what is wrong.
  void (*check_options)(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
  std::string (*print_tokens)(Request& request);
  std::string (*print_syntax)(Request& request);
  /// Parses and lowers. Always gives a program; it is only meaningful when nothing was reported as an error.
  Lowered (*lower)(Request& request);
  /// The location that a scenario names; none when the text is no location of this dialect. Who asks often keeps the
  /// index.
  std::optional<Location> (*locate)(const ir::NameIndex& names, std::string_view text);
  /// A value in the dialect's own spelling ("33H"); none when it is none.
  std::optional<uint64_t> (*parse_value)(std::string_view text);
  /// The simulated control; none when there is none, or the options want none.
  std::unique_ptr<ControlStub> (*make_stub)(const ir::Program& program,
                                            const std::map<std::string, std::string>& options);
  /// Reports a part that costs more than the budget of its option; `options` holds the limits.
  void (*report_over_budget)(Budget budget, uint64_t needed, uint64_t limit, source::FileId first,
                             const source::SourceManager& sources, diag::Engine& diagnostics);
  diag::Lints lints;  // the dialect's codes for the checks of checks/
  /// Names of options mean the same in upper and lower case; `options` of a Request has them as `options` above.
  bool options_ignore_case = false;
  bool options_take_underscores = false;  // '-' in their names may be written as '_'
  /// Do -D and -U mean something to it?
  bool reads_empty_files = false;      // an empty source is a text without lines, not a fault of the world
  bool takes_system_includes = false;  // --system-include means something to it
  bool takes_macros = false;
  bool values_wrap = false;    // a scenario's whole number is meant modulo 2^width of its location
  bool whole_periods = false;  // `run: {ms: n}` takes multiples of the period only
  /// The text of a message that has just become active, where memory is a part of it (numbers); empty: "message N".
  /// None: the text is that of Program::messages.
  std::string (*message_text)(const ir::Program& program, uint32_t number, const ImagePort& image) = nullptr;
};

/// All dialects, by name.
std::span<const Dialect* const> AllDialects();
const Dialect* DialectByName(std::string_view name);

}  // namespace plcxx::dialects
