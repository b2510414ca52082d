// plcxx report: a page about a program, its ladder pictures, or one of its tables.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "transpiler/checks/accesses.h"
#include "transpiler/cost/cost_model.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/gathered_output.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/report_page.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/emit/legalize/names.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/symbol_names.h"
#include "transpiler/report/ladder_lines.h"
#include "transpiler/report/ladder_pictures.h"
#include "transpiler/report/page.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/source/columns.h"

namespace plcxx::driver {
namespace {

constexpr const char* kReportFooter = R"(Examples:
  plcxx report turret.sym turret.plc -o review            writes review/turret.html: source, C++ and ladder side by side,
                                                          cross reference, memory map, budget
  plcxx report turret.sym turret.plc --ladder -o pictures writes pictures/turret.slow.svg ..., one for each routine
  plcxx report turret.sym turret.plc --ladder -o -        all of them as one picture, to standard output
  plcxx report turret.plc --ladder-text --signal U4A8     the rungs of one signal as text
  plcxx report turret.sym turret.plc --print-symbols      names, addresses, number of reads and writes
  plcxx report turret.sym turret.plc --cross-reference    who reads and who writes, with file and line
  plcxx report turret.sym turret.plc --cost-listing       the estimated time of each statement
  plcxx report lathe.il --resources                       what the program uses of what the control has
  plcxx report mill.cld --lists                           handlers, alarms, codes, cells, variables, limits

The page is one file that needs no network; '-o -' writes it to standard output. Tables go to standard output.
Exit codes: 0 done, 1 the program has errors, 2 wrong use, 3 a fault of plcxx.)";

struct Uses {
  std::vector<source::Range> reads, writes;
  ir::StatementId last_writer;
};

/// By the bits that a place covers.
using UsesByBits = std::map<std::pair<uint32_t, uint32_t>, Uses>;

/// The fields that a statement sets by an operation on the instance: the input that it names, where the language has
/// names for inputs, else all that can be looked at.
std::vector<uint8_t> SetFields(ir::StateKind kind, ir::OpKind step) {
  const std::string_view input = step == ir::OpKind::kResetCounter ? "reset" : "input";
  const auto fields = ir::Info(kind).fields;
  std::vector<uint8_t> open;
  for (uint8_t f = 0, count = static_cast<uint8_t>(fields.size()); f < count; ++f) {
    if (fields[f].name == input) return {f};
    if (!fields[f].hidden) open.push_back(f);
  }
  return open;
}

/// A mention counts once, however many instructions it became; the program's own schedule mentions nothing.
void AddMention(const source::Range& range, std::vector<source::Range>& uses) {
  if (range.end > range.begin && (uses.empty() || uses.back() != range)) uses.push_back(range);
}

void AddUse(bool is_read, const source::Range& range, ir::StatementId statement, Uses& uses) {
  if (is_read) return AddMention(range, uses.reads);
  // A statement writes a target once, be it in several branches of a choice.
  if (statement.valid() && uses.last_writer == statement) return;
  uses.last_writer = statement;
  AddMention(range, uses.writes);
}

UsesByBits CollectUses(const ir::Program& program) {
  const checks::BitNumbering numbering(program);
  UsesByBits uses;
  for (const checks::PartAccesses& part : checks::CollectAccesses(program)) {
    for (const checks::Access& access : part.accesses) {
      if (access.kind == checks::AccessKind::kDrive || access.kind == checks::AccessKind::kTouch) {
        const bool reads = access.step == ir::OpKind::kTimeLeft || access.step == ir::OpKind::kTimeLeftCoded;
        for (const uint8_t field : SetFields(program.states[access.state].kind, access.step)) {
          ir::Place place;
          place.state = access.state;
          place.field = field;
          const checks::BitSpan span = numbering.Of(place);
          Uses& both = uses[{span.first, span.last}];
          AddUse(reads, access.range, access.statement, both);
        }
      } else if (access.place.valid()) {
        const checks::BitSpan span = numbering.Of(program.places[access.place]);
        Uses& both = uses[{span.first, span.last}];
        AddUse(access.kind == checks::AccessKind::kRead, access.range, access.statement, both);
      }
    }
  }
  // Power-on, what the parts call, and what the host calls are in none of their lists.
  for (const ir::Routine& routine : program.routines) {
    using Kind = ir::RoutineKind;
    if (routine.kind == Kind::kFast || routine.kind == Kind::kSlow || routine.kind == Kind::kSchedule) continue;
    ir::ForEachInst(program, routine.body, [&](ir::InstId id) {
      const ir::Inst& inst = program[id];
      if (inst.op != ir::OpKind::kLoad && inst.op != ir::OpKind::kStore) return;
      const checks::BitSpan span = numbering.Of(program.places[ir::PlaceId(inst.payload)]);
      Uses& both = uses[{span.first, span.last}];
      AddUse(inst.op == ir::OpKind::kLoad, inst.range, {}, both);
    });
  }
  return uses;
}

/// Finds the uses of each documented address of a program.
class UsesByAddress {
 public:
  explicit UsesByAddress(const compilation::Compilation& compilation)
      : locate_(compilation.dialect->locate),
        names_(compilation.program),
        numbering_(compilation.program),
        uses_(CollectUses(compilation.program)) {
    for (const ir::Place& place : compilation.program.places) {
      if (!place.address.empty()) copies_[place.address].push_back(numbering_.Of(place));
    }
    const ir::Program& program = compilation.program;
    for (uint32_t i = 0; i < program.states.size(); ++i)
      instances_[program.states[ir::StateId(i)].name] = ir::StateId(i);
  }

  /// What reads a copy of the address (an input that is latched for the slow part) reads it.
  Uses Of(const std::string& address) const {
    const std::optional<checks::BitSpan> own = SpanOf(address);
    Uses uses = own ? At(*own) : OfInstance(address);
    const auto copies = copies_.find(address);
    if (copies == copies_.end()) return uses;
    for (const checks::BitSpan& copy : copies->second) {
      if (own && own->first == copy.first && own->last == copy.last) continue;
      const std::vector<source::Range> reads = At(copy).reads;
      uses.reads.insert(uses.reads.end(), reads.begin(), reads.end());
    }
    return uses;
  }

 private:
  std::optional<checks::BitSpan> SpanOf(const std::string& address) const {
    const std::optional<dialects::Location> location = locate_(names_, address);
    if (!location || location->absent || location->text_input) return std::nullopt;
    // What the control holds beside memory (an output of the machine) has no place of its own: it is the one of the
    // program with this address, if there is one.
    const bool has_own = location->place.is_field() || location->place.space.valid();
    const ir::Place* const place = has_own ? &location->place : names_.PlaceAt(address);
    if (place == nullptr) return std::nullopt;
    return numbering_.Of(*place);
  }
  /// Of a timer or counter that is named as a whole: of all its fields, each mention once.
  Uses OfInstance(const std::string& name) const {
    Uses uses;
    const auto instance = instances_.find(name);
    if (instance == instances_.end()) return uses;
    ir::Place place;
    place.state = instance->second;
    const auto fields = static_cast<uint8_t>(ir::Info(names_.program().states[place.state].kind).fields.size());
    for (place.field = 0; place.field < fields; ++place.field) {
      const Uses of_field = At(numbering_.Of(place));
      for (const auto& [from, to] :
           {std::pair(&of_field.reads, &uses.reads), std::pair(&of_field.writes, &uses.writes)}) {
        for (const source::Range& range : *from) {
          if (std::ranges::find(*to, range) == to->end()) to->push_back(range);
        }
      }
    }
    for (std::vector<source::Range>* const side : {&uses.reads, &uses.writes})
      std::ranges::stable_sort(*side, {}, &source::Range::begin);
    return uses;
  }
  Uses At(const checks::BitSpan& span) const {
    const auto found = uses_.find({span.first, span.last});
    return found == uses_.end() ? Uses() : found->second;
  }

  decltype(dialects::Dialect::locate) locate_;
  ir::NameIndex names_;
  checks::BitNumbering numbering_;
  UsesByBits uses_;
  std::map<std::string, std::vector<checks::BitSpan>> copies_;  // by address
  std::map<std::string, ir::StateId> instances_;                // by name
};

std::string RangesText(const compilation::Compilation& compilation, const std::vector<source::Range>& ranges) {
  std::string out;
  for (const source::Range& range : ranges) {
    const source::Position at = compilation.sources->Locate(range.begin);
    if (!at.file.valid()) continue;
    out += (out.empty() ? "" : " ") + diag::Escaped(compilation.sources->Get(at.file).path) + ":" +
           std::to_string(at.line);
  }
  return out.empty() ? "-" : out;
}

void PrintSymbols(const compilation::Compilation& compilation) {
  const UsesByAddress uses(compilation);
  struct Row {
    std::string address;
    size_t reads = 0, writes = 0;
  };
  std::map<std::string, Row> rows;  // sorted by name, as the control itself keeps its table
  for (const ir::Documentation& known : compilation.program.documentation) {
    const Uses used = uses.Of(known.address);
    ir::ForEachSymbolName(known, [&](std::string_view name) {
      rows[std::string(name)] = {known.address, used.reads.size(), used.writes.size()};
    });
  }
  std::cout << "symbol            operand   reads  writes\n";
  for (const auto& [name, row] : rows) {
    std::cout << source::LeftAligned(diag::Escaped(name), 17) << ' ' << source::LeftAligned(row.address, 9) << ' '
              << source::LeftAligned(std::to_string(row.reads), 6) << ' ' << row.writes << '\n';
  }
}

void PrintCrossReference(const compilation::Compilation& compilation) {
  const UsesByAddress uses(compilation);
  for (const ir::Documentation& known : compilation.program.documentation) {
    std::cout << diag::Escaped(known.address);
    if (!known.symbols.empty()) std::cout << "  " << diag::Escaped(known.symbols);
    if (!known.predefined.empty()) std::cout << "  (" << diag::Escaped(known.predefined) << ')';
    const std::string& text = known.help.empty() ? known.meaning : known.help;
    if (!text.empty()) std::cout << "  " << diag::Escaped(text);
    const Uses used = uses.Of(known.address);
    std::cout << "\n  written: " << RangesText(compilation, used.writes)
              << "\n  read:    " << RangesText(compilation, used.reads) << '\n';
  }
}

void PrintCosts(const compilation::Compilation& compilation) {
  const ir::Program& program = compilation.program;
  cost::RoutineTimes known_times;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (routine.kind != ir::RoutineKind::kFast && routine.kind != ir::RoutineKind::kSlow) continue;
    const cost::Estimate estimate = cost::EstimateRoutine(program, ir::RoutineId(i), known_times);
    std::cout << routine.name << ": " << estimate.time_us() << " us, " << estimate.total.code_bytes << " bytes\n";
    for (const cost::StatementCost& statement : estimate.statements) {
      const source::Range range = program.statements[statement.statement].range;
      const std::string_view text = compilation.sources->Text(range);
      std::cout << "  " << source::LeftAligned(std::to_string(statement.own.time_ns) + " ns", 9)
                << source::LeftAligned(std::to_string(statement.own.code_bytes) + " bytes", 11)
                << RangesText(compilation, {range}) << "  " << diag::Escaped(text.substr(0, text.find_first_of("\r\n")))
                << '\n';
    }
  }
}

/// The original's resource page; a control that has none says so.
void PrintResources(const compilation::Compilation& compilation) {
  if (compilation.summary.resources.empty()) {
    std::cout << compilation.dialect->title << " limits no resources of this kind\n";
    return;
  }
  std::cout << "resource          used    available\n";
  for (const dialects::ResourceUse& resource : compilation.summary.resources) {
    std::cout << source::LeftAligned(std::string(resource.name), 17) << ' '
              << source::LeftAligned(std::to_string(resource.used), 7) << ' ' << resource.available << '\n';
  }
}

/// What the specification of the dialect asks for beside the program.
void PrintLists(const compilation::Compilation& compilation) {
  if (compilation.summary.tables.empty()) std::cout << compilation.dialect->title << " has no further lists\n";
  for (const dialects::SummaryTable& table : compilation.summary.tables) {
    std::vector<size_t> widths;
    for (size_t i = 0; i < table.columns.size(); ++i) {
      widths.push_back(source::ColumnsOf(table.columns[i]));
      for (const auto& row : table.rows) widths[i] = std::max(widths[i], source::ColumnsOf(row[i]));
    }
    const auto line = [&widths](const std::vector<std::string>& row) {
      std::string text = " ";
      for (size_t i = 0; i < row.size(); ++i) text += ' ' + source::LeftAligned(row[i], widths[i] + 1);
      std::cout << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
    };
    std::cout << table.title << (table.rows.empty() ? ": none\n" : "\n");
    if (!table.rows.empty()) line(table.columns);
    std::ranges::for_each(table.rows, line);
  }
}

struct ReportOptions {
  CommonOptions common;
  OutputOptions output;
  bool ladder = false;
  bool ladder_text = false;
  std::string signal;
  bool symbols = false;
  bool cross_reference = false;
  bool costs = false;
  bool resources = false;
  bool lists = false;
  bool quiet = false;

  bool wants_table() const { return symbols || cross_reference || costs || resources || lists; }
};

/// The page, or the pictures: each a file, or all of it to standard output.
int WritePage(const ReportOptions& options, const compilation::CompilationRequest& request) {
  std::optional<compilation::Compilation> compiled = CompileProgram(options.common, request);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  if (compilation.ok() && !compilation.has_program) {
    return UsageError("the sources are data only: there is no program to report of");
  }
  std::string text;
  if (compilation.ok()) {
    const report::ProgramInput input = PageInput(compilation);
    OutputRequest output;
    output.directory = options.output.directory;
    const OutputKind kind = KindOfOutput(options.output.directory);
    if (kind == OutputKind::kStandardOutput) {
      text = options.ladder ? report::LadderPicture(input) : report::Page(input);
    } else if (kind == OutputKind::kFile) {
      output.directory = std::filesystem::path(options.output.directory).parent_path().string();
      output.named = {options.output.directory};
      output.files.push_back(
          {options.output.directory, options.ladder ? report::LadderPicture(input) : report::Page(input)});
    } else if (options.ladder) {
      for (report::Picture& picture : report::LadderPictures(input)) {
        const std::string name = compilation.name + "." + emit::legalize::SafeIdentifier(picture.name) + ".svg";
        output.files.push_back({PathIn(output.directory, name), std::move(picture.svg)});
      }
    } else {
      output.files.push_back({PathIn(output.directory, compilation.name + ".html"), report::Page(input)});
    }
    output.protected_paths = PathsRead(compilation, options.common);
    if (!output.files.empty()) {
      if (const auto failure = WriteAll(output)) {
        ReportCannotWrite(*failure, compilation);
      } else if (!options.quiet) {
        for (const emit::OutputFile& file : output.files) std::cerr << "wrote " << diag::Escaped(file.name) << '\n';
      }
    }
  }
  if (options.output.directory == "-") {
    PrintDiagnosticsBeside(compilation, MessagesOf(options.common));
    std::cout << text;
  } else {
    PrintDiagnostics(compilation, MessagesOf(options.common));
  }
  return ExitCodeOf(compilation);
}

/// Text to standard output, or into the file that -o names.
int WriteText(const ReportOptions& options, const compilation::Compilation& compilation, const std::string& text) {
  const std::string& path = options.output.directory;
  if (path.empty() || path == "-") {
    std::cout << text;
    return kDone;
  }
  if (const auto failure = WriteAll({{}, {{path, text}}, PathsRead(compilation, options.common), {path}})) {
    return CannotWrite(*failure);
  }
  if (!options.quiet) std::cerr << "wrote " << diag::Escaped(path) << '\n';
  return kDone;
}

int PrintLadder(const ReportOptions& options, const compilation::CompilationRequest& request) {
  const std::optional<compilation::Compilation> compiled = CompileProgram(options.common, request);
  if (!compiled) return kWrongUse;
  const compilation::Compilation& compilation = *compiled;
  PrintDiagnosticsBeside(compilation, MessagesOf(options.common));
  if (!compilation.ok() || !compilation.has_program) return ExitCodeOf(compilation);
  std::optional<report::WantedRungs> wanted;
  if (!options.signal.empty()) {
    const auto location = compilation.dialect->locate(ir::NameIndex(compilation.program), options.signal);
    wanted = {.word = options.signal, .place = {}};
    if (location) wanted->place = location->place;
  }
  const std::string rungs = report::LadderLines(PageInput(compilation), wanted);
  if (rungs.empty() && wanted) {
    if (!wanted->place)
      return UsageError(scenarios::NoSuchLocation(*compilation.dialect, compilation.program, options.signal));
    std::cerr << "note: no rung names '" << diag::Escaped(options.signal) << "'\n";
  }
  return std::max<int>(WriteText(options, compilation, diag::EscapedLines(rungs)), ExitCodeOf(compilation));
}

std::string TablesText(const ReportOptions& options, const compilation::Compilation& compilation) {
  const GatheredOutput gathered(true);
  if (options.symbols) PrintSymbols(compilation);
  if (options.cross_reference) PrintCrossReference(compilation);
  if (options.costs) PrintCosts(compilation);
  if (options.resources) PrintResources(compilation);
  if (options.lists) PrintLists(compilation);
  return gathered.text();
}

int RunReport(const ReportOptions& options) {
  std::optional<compilation::CompilationRequest> request = MakeNamedRequest(options.common, options.output);
  if (!request) return kWrongUse;
  if (options.wants_table() && options.ladder) {
    return UsageError("--ladder writes pictures: not together with a table");
  }
  if (!options.signal.empty() && !options.ladder_text) {
    return UsageError("--signal takes rungs out of the ladder as text: add --ladder-text");
  }
  if ((options.wants_table() || options.ladder_text) && KindOfOutput(options.output.directory) == OutputKind::kFolder &&
      !options.output.directory.empty()) {
    return UsageError("'-o " + options.output.directory +
                      "' is a folder, and a text is written: name a file with an extension, or leave -o out");
  }
  if (options.ladder_text) return PrintLadder(options, *request);
  if (!options.wants_table()) return WritePage(options, *request);
  const std::optional<compilation::Compilation> compiled =
      CompileProgram(options.common, *request, compilation::Stage::kChecked);
  if (!compiled) return kWrongUse;
  const compilation::Compilation& compilation = *compiled;
  if (!compilation.ok()) {
    PrintDiagnosticsBeside(compilation, MessagesOf(options.common));
    return ExitCodeOf(compilation);
  }
  return WriteText(options, compilation, TablesText(options, compilation));
}

}  // namespace

void AddReport(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("report", "A page about the program, ladder pictures, tables");
  const auto options = std::make_shared<ReportOptions>();
  AddCommonOptions(*command, options->common);
  const auto add = [&command](const char* option, std::string& value, const char* type, const char* meaning) {
    command->add_option(option, value, meaning)->type_name(type)->group("Output");
  };
  add("--name", options->output.name, "NAME", "Name of the program and its files; else from the first logic source");
  add("-o", options->output.directory, "DIR",
      "Directory of the files, else the current one; or a file; '-': standard output");
  options->output.one_file = OneFile::kYes;
  command->add_flag("-q,--quiet", options->quiet, "Do not tell which files were written")->group("Output");
  command->add_flag("--ladder", options->ladder, "Only the ladder pictures, as SVG")->group("Output");
  command->add_flag("--ladder-text", options->ladder_text, "The ladder as text, to standard output");
  command
      ->add_option("--signal", options->signal, "Of the ladder as text only the rungs that name this address or symbol")
      ->type_name("NAME");
  command->add_flag("--print-symbols", options->symbols, "The symbols by name, with the number of reads and writes");
  command->add_flag("--cross-reference", options->cross_reference, "Every operand with who writes and who reads it");
  command->add_flag("--cost-listing", options->costs, "The estimated time and size of every statement");
  command->add_flag("--resources", options->resources, "What the program uses of what the control has");
  command->add_flag("--lists", options->lists, "Further lists of the dialect: handlers, alarms, codes, cells, limits");
  command->footer(kReportFooter);
  command->callback([options, &run] {
    run = [options] {
      const bool to_output = options->output.directory.empty() || options->output.directory == "-";
      const bool as_text = (options->wants_table() || options->ladder_text) && to_output;
      return RunForPrograms(*options, RunReport, as_text ? Result::kUnnamed : Result::kNamed);
    };
  });
}

}  // namespace plcxx::driver
