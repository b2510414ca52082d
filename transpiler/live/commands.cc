#include "transpiler/live/commands.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "transpiler/live/command_words.h"
#include "transpiler/live/recording.h"
#include "transpiler/live/why.h"
#include "transpiler/live/wishes.h"
#include "transpiler/support/system_words.h"

namespace plcxx::live {
namespace {

using Json = nlohmann::ordered_json;

struct Context {
  Session& session;
  const RecordingPlace& place;
  Words words;
  Json answer;
};

ir::StatementId StatementIn(Context& context) {
  const size_t count = context.session.program().statements.size();
  return ir::StatementId(static_cast<uint32_t>(context.words.Number("statement", count == 0 ? 0 : count - 1)));
}

std::optional<StepKind> StepKindOf(const std::string& word) {
  if (word == "period") return StepKind::kPeriod;
  if (word == "fast") return StepKind::kFast;
  if (word == "slow") return StepKind::kSlow;
  if (word == "slice") return StepKind::kSlice;
  if (word == "statement") return StepKind::kStatement;
  return std::nullopt;
}

Refusal StepCommand(Context& context) {
  const std::string word = context.words.Text("what");
  if (!context.words.wrong().empty()) return context.words.wrong();
  const std::optional<StepKind> kind = StepKindOf(word);
  if (!kind) return "a step is a 'statement', 'period', 'fast', 'slice' or 'slow'";
  return context.session.Step(*kind);
}

Refusal WhyCommand(Context& context) {
  const std::string name = context.words.Text("name");
  if (!context.words.wrong().empty()) return context.words.wrong();
  const Reasons reasons = WhyNow(context.session, name);
  context.answer["text"] = reasons.text;
  return reasons.refusal;
}

Refusal ScenarioCommand(Context& context) {
  const Recording recording = WriteRecording(*context.place.compilation, *context.place.request,
                                             context.session.timeline(), context.place.directory);
  context.answer["yaml"] = recording.yaml;
  return recording.refusal;
}

/// A new file, whole or not at all: one that is there is somebody's work.
Refusal WriteNew(const std::string& path, const std::string& name, const std::string& text) {
  std::FILE* const file = std::fopen(path.c_str(), "wx");
  if (file == nullptr && errno == EEXIST) return "'" + name + "' is there already";
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = errno;
  if (file != nullptr && std::fclose(file) != 0) {
    if (written) error = errno;
    written = false;
  }
  if (written) return {};
  if (file != nullptr) std::remove(path.c_str());
  return "'" + name + "' cannot be written: " + support::SystemWords(error);
}

Refusal SaveCommand(Context& context) {
  const std::string name = context.words.Text("file");
  if (!context.words.wrong().empty()) return context.words.wrong();
  if (!IsScenarioName(name)) return "a scenario's name has letters, digits, '-' and '_', and ends with .yaml";
  const Recording recording = CheckedRecording(*context.place.compilation, *context.place.request,
                                               context.session.timeline(), context.place.directory, name);
  if (!recording.refusal.empty()) return recording.refusal;
  const std::string path = (std::filesystem::path(context.place.directory) / name).generic_string();
  Refusal refusal = WriteNew(path, name, recording.yaml);
  if (refusal.empty()) context.answer["file"] = name;
  return refusal;
}

Refusal TriggerCommand(Context& context) {
  const TriggerWish wish = TriggerWishOf(context.words);
  return context.words.IfRight([&] { return Arm(context.session, wish); });
}

struct CommandRow {
  const char* name;
  Refusal (*run)(Context& context);
};

constexpr uint32_t kMostNumber = 0xFFFFFFFF;

constexpr CommandRow kCommands[] = {
    {"run", [](Context& context) { return context.session.Run(); }},
    {"pause",
     [](Context& context) {
       context.session.Pause("");
       return Refusal();
     }},
    {"speed",
     [](Context& context) -> Refusal {
       const double times = context.words.Real("times");
       return context.words.IfRight([&] { return context.session.SetSpeed(times); });
     }},
    {"step", StepCommand},
    {"back",
     [](Context& context) -> Refusal {
       const uint64_t periods = context.words.Number("periods", kMostBack);
       return context.words.IfRight([&] { return context.session.Back(periods); });
     }},
    {"backStatement", [](Context& context) { return context.session.BackStatement(); }},
    {"goTo",
     [](Context& context) -> Refusal {
       const uint64_t period = context.words.Number("period", uint64_t{1} << 53);
       return context.words.IfRight([&] { return context.session.GoTo(period); });
     }},
    {"restart",
     [](Context& context) {
       context.session.BeginAnew();
       return Refusal();
     }},
    {"set",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name"), value = context.words.Text("value");
       return context.words.IfRight([&] { return Set(context.session, name, value); });
     }},
    {"toggle",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name");
       return context.words.IfRight([&] { return Toggle(context.session, name); });
     }},
    {"panelPress",
     [](Context& context) -> Refusal {
       const uint64_t control = context.words.Number("control", kMostNumber);
       return context.words.IfRight([&] { return context.session.hands().Press(control); });
     }},
    {"panelRelease",
     [](Context& context) -> Refusal {
       const uint64_t control = context.words.Number("control", kMostNumber);
       return context.words.IfRight([&] { return context.session.hands().Release(control); });
     }},
    {"panelTurn",
     [](Context& context) -> Refusal {
       const uint64_t control = context.words.Number("control", kMostNumber);
       const uint64_t position = context.words.Number("position", kMostNumber);
       return context.words.IfRight([&] { return context.session.hands().Turn(control, position); });
     }},
    {"force",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name"), value = context.words.Text("value");
       return context.words.IfRight([&] { return Force(context.session, name, value); });
     }},
    {"release",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name");
       return context.words.IfRight([&] { return Release(context.session, name); });
     }},
    {"releaseAll", [](Context& context) { return ReleaseAll(context.session); }},
    {"switch",
     [](Context& context) -> Refusal {
       const ir::StatementId statement = StatementIn(context);
       const bool on = context.words.Truth("on");
       return context.words.IfRight([&] { return SwitchStatement(context.session, statement, on); });
     }},
    {"switchAllOn", [](Context& context) { return SwitchAllOn(context.session); }},
    {"powerOff", [](Context& context) { return context.session.PowerOff(); }},
    {"powerOn", [](Context& context) { return context.session.PowerOn(); }},
    {"breakStatement",
     [](Context& context) -> Refusal {
       const ir::StatementId statement = StatementIn(context);
       const bool on = context.words.Truth("on");
       return context.words.IfRight([&] { return context.session.breakpoints().AtStatement(statement, on); });
     }},
    {"breakChange",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name");
       return context.words.IfRight([&] { return BreakAtChange(context.session, name); });
     }},
    {"breakCondition",
     [](Context& context) -> Refusal {
       const std::string text = context.words.Text("text");
       return context.words.IfRight([&] { return BreakAtCondition(context.session, text); });
     }},
    {"breakRemove",
     [](Context& context) -> Refusal {
       const uint64_t number = context.words.Number("number", kMostNumber);
       return context.words.IfRight(
           [&] { return context.session.breakpoints().Remove(static_cast<uint32_t>(number)); });
     }},
    {"watch",
     [](Context& context) -> Refusal {
       const std::string name = context.words.Text("name");
       return context.words.IfRight([&] { return Watch(context.session, name); });
     }},
    {"unwatch",
     [](Context& context) -> Refusal {
       const uint64_t number = context.words.Number("number", kMostWatched);
       return context.words.IfRight([&] { return Unwatch(context.session, number); });
     }},
    {"trigger", TriggerCommand},
    {"triggerOff",
     [](Context& context) {
       context.session.chart().Disarm();
       return Refusal();
     }},
    {"why", WhyCommand},
    {"expect",
     [](Context& context) -> Refusal {
       const std::vector<std::string> names = context.words.Texts("names", kMostNotes);
       return context.words.IfRight([&] { return Expect(context.session, names); });
     }},
    {"expectMessages", [](Context& context) { return ExpectMessages(context.session); }},
    {"scenario", ScenarioCommand},
    {"save", SaveCommand},
};

}  // namespace

CommandResult RunCommand(Session& session, const RecordingPlace& place, const Json& command) {
  if (!command.is_object()) return {"a command is a JSON object", {}};
  Context context{.session = session, .place = place, .words = Words(command), .answer = Json::object()};
  const std::string name = context.words.Text("do");
  if (!context.words.wrong().empty()) return {context.words.wrong(), {}};
  for (const CommandRow& row : kCommands) {
    if (name != row.name) continue;
    Refusal refusal = row.run(context);
    return {std::move(refusal), std::move(context.answer)};
  }
  return {"there is no command '" + name + "'", {}};
}

std::vector<std::string> CommandNames() {
  std::vector<std::string> names;
  for (const CommandRow& row : kCommands) names.emplace_back(row.name);
  return names;
}

}  // namespace plcxx::live
