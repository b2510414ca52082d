// Who writes each predefined signal: the table of the control's manual against the zones of memory, from which diff,
// prove and verify take what the control may do.
//
// In: signals.csv of each dialect, whose direction and meaning are the manual's; a program of that dialect. A signal
// that the manual gives to the control and the zones do not is a hole: what depends on it would be called proved. Where
// both differ with a reason, it stands in whose_signals.txt.
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::review::diff {
namespace {

using execute::ControlWrite;

struct SignalRow {
  std::string address, name, direction, meaning;
};

/// A table with quotes around cells that have commas.
std::vector<SignalRow> SignalRows(const std::string& dialect) {
  std::ifstream in(std::string(PLCXX_ROOT) + "/transpiler/dialects/" + dialect + "/machine/signals.csv");
  EXPECT_TRUE(in.is_open()) << dialect;
  std::vector<SignalRow> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '"') {
        is_quoted = !is_quoted;
      } else if (c == ',' && !is_quoted) {
        cells.emplace_back();
      } else if (c != '\r') {
        cells.back() += c;
      }
    }
    if (cells.size() >= 5) rows.push_back({cells[0], cells[1], cells[3], cells[4]});
  }
  return rows;
}

/// As scenarios write it: "%I400" is I400, of "I21.7-4" the first bit.
std::string LocationName(const std::string& address) {
  std::string text = address.starts_with("%") ? address.substr(1) : address;
  const size_t dash = text.find('-');
  return dash == std::string::npos ? text : text.substr(0, dash);
}

/// What the manual says.
ControlWrite Expected(const SignalRow& row) {
  if (row.direction == "machine_in" || row.direction == "nc_to_plc") return ControlWrite::kValues;
  for (const char* const words : {"the NC clears the bit", "cleared by the NC", "cleared by the control",
                                  "cleared when", "cleared by the base", "clears it itself"}) {
    if (row.meaning.find(words) != std::string::npos) return ControlWrite::kClears;
  }
  if (row.meaning.find("driven by the base software") != std::string::npos) return ControlWrite::kValues;
  return ControlWrite::kNothing;
}

std::string NameOf(ControlWrite write) {
  switch (write) {
    case ControlWrite::kNothing:
      return "nothing";
    case ControlWrite::kClears:
      return "clears";
    case ControlWrite::kValues:
      return "values";
  }
  return {};
}

ControlWrite WritesTo(const ir::Space& space, const ir::Place& place) {
  if (place.bit != ir::kNoBit) return execute::WhatControlWrites(space, place.offset, place.bit);
  // Of a byte the most that is done to any bit.
  const execute::ControlBits bits = execute::BitsControlWrites(space, place.offset);
  if (bits.values != 0) return ControlWrite::kValues;
  return bits.clears != 0 ? ControlWrite::kClears : ControlWrite::kNothing;
}

struct WrittenProgram {
  std::string dialect, file, text;
};

compilation::Compilation CompiledProgram(const WrittenProgram& program,
                                         const testing_support::TemporaryDirectory& place) {
  compilation::CompilationRequest request;
  request.sources = {place.Write(program.file, program.text)};
  request.dialect = program.dialect;
  return compilation::Compile(request);
}

struct Exception {
  std::string dialect, address;  // up to its `*`
  bool is_prefix = false;
  std::string expected, found;
  bool is_used = false;
};

std::vector<Exception> KnownExceptions() {
  std::ifstream in(std::string(PLCXX_ROOT) + "/tests/diff/whose_signals.txt");
  EXPECT_TRUE(in.is_open());
  std::vector<Exception> known;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    Exception exception;
    std::string why;
    words >> exception.dialect >> exception.address >> exception.expected >> exception.found >> why;
    EXPECT_FALSE(why.empty()) << line;
    exception.is_prefix = exception.address.ends_with("*");
    if (exception.is_prefix) exception.address.pop_back();
    known.push_back(exception);
  }
  return known;
}

bool IsKnown(std::vector<Exception>& known, const std::string& dialect, const std::string& address,
             ControlWrite expected, ControlWrite found) {
  bool is_known = false;
  for (Exception& exception : known) {
    const bool is_it = exception.is_prefix ? address.starts_with(exception.address) : address == exception.address;
    if (!is_it || exception.dialect != dialect || exception.expected != NameOf(expected) ||
        exception.found != NameOf(found))
      continue;
    exception.is_used = is_known = true;
  }
  return is_known;
}

TEST(WhoseSignals, TheZonesSayWhatTheTablesOfTheControlsSay) {
  const std::vector<WrittenProgram> programs{
      {"nc110", "a.plc", "$\nU4A0=I0A0\n"},
      {"prostep", "a.plc", ":MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n"},
      {"host50", "a.il", "SLOWDIV 1\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n"},
      {"technol", "a.plc",
       "        DATA\n        DATA_END\n        MODULE_MAIN\n        MODULE_MAIN_END\n        STOP\n"},
  };
  std::vector<Exception> known = KnownExceptions();
  for (const WrittenProgram& program : programs) {
    const testing_support::TemporaryDirectory place;
    const compilation::Compilation compiled = CompiledProgram(program, place);
    ASSERT_TRUE(compiled.ok() && compiled.has_program) << program.dialect;
    const ir::NameIndex names(compiled.program);
    size_t located = 0;
    for (const SignalRow& row : SignalRows(program.dialect)) {
      std::optional<dialects::Location> at = compiled.dialect->locate(names, LocationName(row.address));
      if (!at && !row.name.empty()) at = compiled.dialect->locate(names, row.name);
      // A field of a structure, as TAB_TECHNOL.TCH_AKTIV.
      if (const size_t plus = row.address.find('+'); !at && plus != std::string::npos)
        at = compiled.dialect->locate(names, row.address.substr(0, plus) + "." + row.name);
      if (!at || at->place.is_field() || !at->place.space.valid()) continue;
      ++located;
      const ir::Space& space = compiled.program.spaces[at->place.space];
      const ControlWrite expected = Expected(row), found = WritesTo(space, at->place);
      if (expected == found) continue;
      EXPECT_TRUE(IsKnown(known, program.dialect, row.address, expected, found))
          << program.dialect << " " << row.address << " " << NameOf(expected) << " " << NameOf(found) << "  "
          << row.name << ": " << row.meaning;
    }
    EXPECT_GT(located, 100U) << program.dialect;
  }
  for (const Exception& exception : known)
    EXPECT_TRUE(exception.is_used) << exception.dialect << " " << exception.address << " is none any more";
}

}  // namespace
}  // namespace plcxx::review::diff
