#include "transpiler/live/linked_commands.h"

#include <utility>

#include "transpiler/live/command_words.h"

namespace plcxx::live {
namespace {

using Json = nlohmann::ordered_json;

struct LinkedRow {
  std::string_view name;
  Refusal (*run)(LinkedMachine& machine, Words& words);
};

constexpr LinkedRow kDone[] = {
    {"set",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const std::string name = words.Text("name"), value = words.Text("value");
       return words.IfRight([&] { return machine.Write(name, value); });
     }},
    {"toggle",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const std::string name = words.Text("name");
       return words.IfRight([&] { return machine.Toggle(name); });
     }},
    {"force",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const std::string name = words.Text("name"), value = words.Text("value");
       return words.IfRight([&] { return machine.Force(name, value); });
     }},
    {"release",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const std::string name = words.Text("name");
       return words.IfRight([&] { return machine.Release(name); });
     }},
    {"releaseAll", [](LinkedMachine& machine, Words&) { return machine.ReleaseAll(); }},
    {"watch",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const std::string name = words.Text("name");
       return words.IfRight([&] { return machine.Watch(name); });
     }},
    {"unwatch",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const uint64_t number = words.Number("number", kMostWatched);
       return words.IfRight([&] { return machine.Unwatch(number); });
     }},
    {"trigger",
     [](LinkedMachine& machine, Words& words) -> Refusal {
       const TriggerWish wish = TriggerWishOf(words);
       return words.IfRight([&] { return machine.Arm(wish); });
     }},
    {"triggerOff", [](LinkedMachine& machine, Words&) { return machine.Disarm(); }},
};

constexpr std::string_view kRuns = "the machine runs as it does: only a simulation pauses, steps, or changes its speed";
constexpr std::string_view kNoWayBack = "what the machine did before is not kept: only a simulation goes back";
constexpr std::string_view kNoPower = "its power is switched at the machine";
constexpr std::string_view kNoSwitch = "statements are switched off in a simulation only: force what they write";
constexpr std::string_view kNoStop = "a running machine does not stop for a breakpoint: watch it, with a trigger";
constexpr std::string_view kNoPanel = "its panel is at the machine: force what has to be so";
constexpr std::string_view kNoReasons = "reasons are found by running the last periods again, which a simulation keeps";
constexpr std::string_view kNoScenario = "a scenario is recorded in the simulation";

struct RefusedRow {
  std::string_view name, reason;
};
constexpr RefusedRow kRefused[] = {
    {"run", kRuns},
    {"pause", kRuns},
    {"speed", kRuns},
    {"step", kRuns},
    {"back", kNoWayBack},
    {"backStatement", kNoWayBack},
    {"goTo", kNoWayBack},
    {"restart", kNoScenario},
    {"powerOff", kNoPower},
    {"powerOn", kNoPower},
    {"switch", kNoSwitch},
    {"switchAllOn", kNoSwitch},
    {"breakStatement", kNoStop},
    {"breakChange", kNoStop},
    {"breakCondition", kNoStop},
    {"breakRemove", kNoStop},
    {"panelPress", kNoPanel},
    {"panelRelease", kNoPanel},
    {"panelTurn", kNoPanel},
    {"why", kNoReasons},
    {"expect", kNoScenario},
    {"expectMessages", kNoScenario},
    {"scenario", kNoScenario},
    {"save", kNoScenario},
};

}  // namespace

std::string_view RefusedOverLink(std::string_view command) {
  for (const RefusedRow& row : kRefused) {
    if (row.name == command) return row.reason;
  }
  return {};
}

CommandResult RunLinkedCommand(LinkedMachine& machine, const Json& command) {
  if (!command.is_object()) return {"a command is a JSON object", {}};
  Words words(command);
  const std::string name = words.Text("do");
  if (!words.wrong().empty()) return {words.wrong(), {}};
  for (const LinkedRow& row : kDone) {
    if (row.name == name) return {row.run(machine, words), Json::object()};
  }
  const std::string_view refused = RefusedOverLink(name);
  return {refused.empty() ? "there is no command '" + name + "'" : Refusal(refused), {}};
}

}  // namespace plcxx::live
