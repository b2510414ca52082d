#include "transpiler/driver/traced_input.h"

#include <iostream>
#include <utility>
#include <variant>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/named_file.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/byte_order_mark.h"
#include "transpiler/support/listed.h"

namespace plcxx::driver {
namespace {

constexpr size_t kMaxNamed = 10;

}  // namespace

std::optional<sim::Vcd> ReadWaveform(const std::string& path) {
  std::optional<std::string> text = ReadNamedFile(path, "--vcd names a recorded trace");
  if (!text) return std::nullopt;
  support::RemoveByteOrderMark(*text);
  std::variant<sim::Vcd, sim::VcdError> read = sim::ReadVcd(*text);
  if (const auto* error = std::get_if<sim::VcdError>(&read)) {
    std::cerr << diag::Escaped(path) << ":" << error->line << ": error: " << diag::Escaped(error->message) << "\n";
    return std::nullopt;
  }
  return std::get<sim::Vcd>(std::move(read));
}

std::vector<std::string> TraceNotes(const scenarios::TracedRun& run,
                                    const std::vector<scenarios::Departure>& departures) {
  std::vector<std::string> notes;
  if (!run.left_out.empty()) {
    notes.push_back("left out of the trace, for the program has no such location: " +
                    support::Listed(run.left_out, kMaxNamed));
  }
  if (run.inputs.empty()) notes.emplace_back("the trace has no input of the program: nothing is set");
  std::vector<std::string> texts;
  for (const scenarios::Departure& departure : departures) {
    texts.push_back(departure.name + " (at " + std::to_string(departure.time_ms) + " ms " + departure.traced +
                    " in the trace, " + departure.run + " in the run)");
  }
  if (!texts.empty()) notes.push_back("the run is not that of the trace: " + support::Listed(texts, kMaxNamed));
  return notes;
}

void PrintTraceNotes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << "note: " << diag::Escaped(note) << "\n";
}

}  // namespace plcxx::driver
