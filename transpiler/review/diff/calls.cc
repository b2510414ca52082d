#include "transpiler/review/diff/calls.h"

#include <algorithm>

#include "transpiler/engines/lockstep.h"
#include "transpiler/sim/same_arguments.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::review::diff {
namespace {

constexpr size_t kMostCalls = 100;

std::string ArgumentText(const ir::Parameter& parameter, uint64_t value) {
  if (value < parameter.enumerators.size()) return parameter.enumerators[value];
  return sim::IsFloat(parameter.type) ? sim::ValueDigits(parameter.type, value) : std::to_string(value);
}

std::string CallText(const ir::HostFunction& function, const sim::HostEvent& event, StatementNumbers numbers) {
  std::string arguments;
  for (size_t i = 0; i < event.arguments.size() && i < function.parameters.size(); ++i) {
    if (function.parameters[i].is_statement && numbers == StatementNumbers::kLeftOut) continue;
    arguments += (arguments.empty() ? "" : ", ") + function.parameters[i].name + ": " +
                 ArgumentText(function.parameters[i], event.arguments[i]);
  }
  return "{" + function.name + ": {" + arguments + "}}";
}

/// The regular exchange calls a function of the program's now and then: those calls, or the program's own.
enum class Callers : uint8_t { kProgram, kExchange };

std::vector<const sim::HostEvent*> CallsOf(const ir::Program& program, const std::vector<sim::HostEvent>& events,
                                           const std::string& function, Callers callers) {
  std::vector<const sim::HostEvent*> calls;
  for (const sim::HostEvent& event : events) {
    const ir::HostFunction& of = program.host_functions[event.function];
    if (event.exchange == (callers == Callers::kExchange) &&
        (of.name == function || (function.empty() && !of.routine_exchange)))
      calls.push_back(&event);
  }
  return calls;
}

}  // namespace

std::optional<std::string> ExpectedCalls(const ir::Program& program, const std::vector<sim::HostEvent>& events,
                                         const std::string& function, StatementNumbers numbers) {
  const auto called = std::ranges::find(program.host_functions, function, &ir::HostFunction::name);
  const bool of_all = function.empty();
  if (!of_all && (called == program.host_functions.end() || called->routine_exchange)) return std::nullopt;
  // A polled function counts where it is named, and is named when it is not called, too.
  const auto is_call = [&](const sim::HostEvent& event) {
    return !event.exchange && program.host_functions[event.function].name == function;
  };
  std::string list;
  if (!of_all && called->polled && std::ranges::none_of(events, is_call)) list = "{" + function + ": none}";
  size_t count = 0;
  for (const sim::HostEvent& event : events) {
    const ir::HostFunction& of = program.host_functions[event.function];
    if (event.exchange || of.routine_exchange || (of.polled && !of_all && of.name != function)) continue;
    if (++count > kMostCalls) return std::nullopt;
    list += (list.empty() ? "" : ", ") + CallText(of, event, numbers);
  }
  return "[" + list + "]";
}

namespace {

FirstDifferentCall FindDifferentCallBy(Callers callers, const ir::Program& old_program,
                                       const std::vector<sim::HostEvent>& old_events, const ir::Program& new_program,
                                       const std::vector<sim::HostEvent>& new_events, const std::string& function) {
  const std::vector<const sim::HostEvent*> old_calls = CallsOf(old_program, old_events, function, callers),
                                           new_calls = CallsOf(new_program, new_events, function, callers);
  size_t at = 0;
  const auto is_same = [&](const sim::HostEvent& one, const sim::HostEvent& other) {
    const ir::HostFunction& called = old_program.host_functions[one.function];
    return called.name == new_program.host_functions[other.function].name &&
           sim::SameArguments(called, one.arguments, other.arguments);
  };
  while (at < old_calls.size() && at < new_calls.size() && is_same(*old_calls[at], *new_calls[at])) {
    ++at;
  }
  const auto text = [at](const ir::Program& program, const std::vector<const sim::HostEvent*>& calls) {
    return at < calls.size() ? engines::ToText(program, *calls[at]) : std::string("no call");
  };
  return {.old_text = text(old_program, old_calls),
          .new_text = text(new_program, new_calls),
          .is_of_exchange = callers == Callers::kExchange};
}

}  // namespace

FirstDifferentCall FindDifferentCall(const ir::Program& old_program, const std::vector<sim::HostEvent>& old_events,
                                     const ir::Program& new_program, const std::vector<sim::HostEvent>& new_events,
                                     const std::string& function) {
  FirstDifferentCall call =
      FindDifferentCallBy(Callers::kProgram, old_program, old_events, new_program, new_events, function);
  if (call.old_text != call.new_text || function.empty()) return call;
  FirstDifferentCall other =
      FindDifferentCallBy(Callers::kExchange, old_program, old_events, new_program, new_events, function);
  return other.old_text != other.new_text ? other : call;
}

}  // namespace plcxx::review::diff
