#include "transpiler/scenarios/failure.h"

#include <vector>

#include "transpiler/dialects/statement_text.h"
#include "transpiler/ir/facts.h"
#include "transpiler/scenarios/control.h"

namespace plcxx::scenarios {
namespace {

constexpr size_t kLongestStatement = 120;

/// In one line.
std::string InOneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (line.size() <= kLongestStatement) return line;
  size_t end = kLongestStatement;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 character
  return line.substr(0, end) + "...";
}

std::string Times(const sim::LastWrite& write) {
  if (write.first_ms == write.last_ms) return "at " + std::to_string(write.first_ms) + " ms";
  return "from " + std::to_string(write.first_ms) + " ms to " + std::to_string(write.last_ms) + " ms";
}

std::string WriterText(const sim::LastWrite& write, const ir::Program& program, const source::SourceManager& sources) {
  switch (write.writer) {
    case sim::Writer::kHost:
      return "the scenario or the control";
    case sim::Writer::kForce:
      return "forced by the scenario";
    case sim::Writer::kProgram:
      break;
  }
  return StatementPlace(write.statement, program, sources);
}

}  // namespace

std::string StatementPlace(ir::StatementId statement, const ir::Program& program,
                           const source::SourceManager& sources) {
  if (!statement.valid()) return "the control's schedule";
  const source::Range range = program.statements[statement].range;
  if (range == source::Range{} || sources.size() == 0) return "the program";
  const source::Position position = sources.Locate(range.begin);
  return sources.Get(position.file).path + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) +
         ": " + InOneLine(dialects::StatementText(program.dialect, sources.Text(range)));
}

std::string StepFailure(const Scenario& scenario, const ScenarioStep& step, ScenarioMark mark, uint64_t time_ms,
                        std::string_view message) {
  return ToText(ScenarioError{scenario.path, mark,
                              "step " + std::to_string(step.number) + " (" + step.name + "), at " +
                                  std::to_string(time_ms) + " ms: " + std::string(message)});
}

std::string LastWritesText(const std::string& name, const dialects::Location& location, const sim::LastWrites* writes,
                           const ir::Program& program, const source::SourceManager& sources) {
  if (writes == nullptr) return "  who wrote " + name + " last: only the simulator keeps a record of it";
  const std::vector<sim::LastWrite> last = writes->Of(location.place);
  if (last.empty()) return "  nothing has written " + name + " since power-on";
  std::string text = "  last writes to " + name + ", newest first:";
  for (const sim::LastWrite& write : last) {
    text += "\n    value " + sim::ValueDigits(location.place.type, write.value, SignOf(location)) + " " + Times(write) +
            ": " + WriterText(write, program, sources);
  }
  return text;
}

std::string FalseFactText(const sim::HostEvent& call, const ir::Program& program,
                          const source::SourceManager& sources) {
  const auto argument = [&call](ir::FalseFactArgument which) { return call.arguments[static_cast<size_t>(which)]; };
  ir::StatementId statement;
  for (uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[ir::StatementId(i)].id == argument(ir::FalseFactArgument::kStatement))
      statement = ir::StatementId(i);
  }
  return "a fact that the code rests on does not hold: " +
         std::string(ir::FactNames()[argument(ir::FalseFactArgument::kKind)]) + " of the value " +
         std::to_string(argument(ir::FalseFactArgument::kValue)) +
         "; this is a fault of plcxx, please report it\n  it belongs to " + StatementPlace(statement, program, sources);
}

std::string DifferenceText(const engines::Difference& difference) {
  const std::string first = difference.first.substr(0, difference.first.find(':'));
  const std::string second = difference.second.substr(0, difference.second.find(':'));
  return first + " and " + second + " differ in " + difference.what + " (" + difference.first + "; " +
         difference.second + ")";
}

}  // namespace plcxx::scenarios
