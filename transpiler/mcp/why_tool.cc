#include "transpiler/mcp/why_tool.h"

#include <string>

namespace plcxx::mcp {

Json WhySchema() {
  return ProgramSchema(
      {{"signal", TextSchema("the location: U4A8, a symbol, a word")},
       {"scenario", TextSchema("the run whose state is asked about")},
       {"vcd", TextSchema("instead of a scenario: a recorded trace whose inputs the program is run with")},
       {"step", NumberSchema("the state after this step of it; else at its end")},
       {"at", TextSchema("the state after the last scan that begins by then: 1200ms, 3s")},
       {"can",
        {{"type", "boolean"},
         {"description", "whether it can be on at all: a run that shows it, or a proof; no scenario"}}}},
      {"signal"});
}

Json RunWhy(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "why");
  command.Add("--format=json");
  const bool can = rpc::OptionalFlag(arguments, "can").value_or(false);
  const auto scenario = rpc::OptionalText(arguments, "scenario");
  const auto trace = rpc::OptionalText(arguments, "vcd");
  if (!can && !scenario && !trace) {
    throw rpc::Error(rpc::kInvalidParams, "name a 'scenario' or a 'vcd', or ask with 'can'");
  }
  if (can) {
    command.Add("--can");
    command.AddTime(1);
  }
  if (scenario) {
    command.Add("--scenario");
    command.AddPath(*scenario);
  } else {
    command.AddProgram();
  }
  if (trace) {
    command.Add("--vcd");
    command.AddPath(*trace);
  }
  if (const auto step = rpc::OptionalNumber(arguments, "step")) {
    command.Add("--step");
    command.AddWord(std::to_string(*step));
  }
  if (const auto at = rpc::OptionalText(arguments, "at")) {
    command.Add("--at");
    command.AddWord(*at);
  }
  command.AddWord(rpc::TextOf(arguments, "signal"));
  if (!scenario || !TextsOf(arguments, "sources").empty()) command.AddSources();
  return JsonResultOf(command.Run(), "why");
}

}  // namespace plcxx::mcp
