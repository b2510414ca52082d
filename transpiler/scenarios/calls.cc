#include "transpiler/scenarios/calls.h"

#include <algorithm>
#include <iterator>

#include "transpiler/engines/lockstep.h"

namespace plcxx::scenarios {
namespace {

/// The line of the statement with this id; 0: there is none.
uint32_t LineOf(const ir::Program& program, uint64_t id) {
  const auto& statements = program.statements;
  const auto found =
      std::find_if(statements.begin(), statements.end(), [id](const ir::Statement& s) { return s.id == id; });
  return found == statements.end() ? 0 : found->line;
}

bool Matches(const ir::Program& program, const PlannedCall& call, const sim::HostEvent& event) {
  if (call.function != event.function) return false;
  const std::vector<ir::Parameter>& parameters = program.host_functions[call.function].parameters;
  return std::all_of(call.arguments.begin(), call.arguments.end(), [&](const PlannedArgument& argument) {
    if (argument.is_line && argument.index < event.arguments.size()) {
      return LineOf(program, event.arguments[argument.index]) == argument.value;
    }
    return argument.index < event.arguments.size() &&
           sim::SameValue(parameters[argument.index].type, event.arguments[argument.index], argument.value);
  });
}

std::string WrittenText(const PlannedCall& call) {
  if (call.written->none) return "no " + call.written->function.text;
  std::string text = call.written->function.text + "(";
  for (const Assignment& argument : call.written->arguments) {
    if (text.back() != '(') text += ", ";
    text += argument.location.text + ": " + argument.value.text;
  }
  return text + ")";
}

std::string WrittenText(const std::vector<PlannedCall>& calls) {
  if (calls.empty()) return "none";
  std::string text;
  for (const PlannedCall& call : calls) text += (text.empty() ? "" : ", ") + WrittenText(call);
  return text;
}

/// Why some of the expected calls can never be found.
std::string ImpossibleCalls(const ir::Program& program, const std::vector<PlannedCall>& expected) {
  std::string known;
  for (const ir::HostFunction& function : program.host_functions) known += (known.empty() ? "" : ", ") + function.name;
  std::string text;
  for (const PlannedCall& call : expected) {
    const std::string& name = call.written->function.text;
    if (!call.function.valid() && !call.written->none) {
      text += "\n  the program never calls '" + name +
              "', so the list cannot match; it may call: " + (known.empty() ? "nothing" : known);
    } else if (call.function.valid() && program.host_functions[call.function].routine_exchange) {
      text += "\n  '" + name + "' is part of the routine exchange, of which no record is kept";
    }
  }
  return text;
}

}  // namespace

std::optional<std::string> CallsMismatch(const ir::Program& program, const std::vector<PlannedCall>& expected,
                                         const std::vector<sim::HostEvent>& events) {
  std::vector<sim::HostEvent> counted;
  for (const sim::HostEvent& event : events) {
    const ir::HostFunction& function = program.host_functions[event.function];
    const bool listed = !function.polled || std::any_of(expected.begin(), expected.end(), [&](const PlannedCall& call) {
      return call.function == event.function;
    });
    if (listed && !event.exchange && !function.routine_exchange) counted.push_back(event);
  }
  std::vector<PlannedCall> calls;
  std::ranges::copy_if(expected, std::back_inserter(calls),
                       [](const PlannedCall& call) { return !call.written->none; });
  const bool equal = std::ranges::equal(calls, counted, [&](const PlannedCall& call, const sim::HostEvent& event) {
    return Matches(program, call, event);
  });
  if (equal) return std::nullopt;
  return "expected host calls " + WrittenText(expected) + ", found " + engines::ToText(program, counted) +
         ImpossibleCalls(program, expected);
}

}  // namespace plcxx::scenarios
