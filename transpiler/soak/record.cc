#include "transpiler/soak/record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "transpiler/ir/printer.h"
#include "transpiler/support/counted.h"
#include "transpiler/support/fnv1a.h"
#include "transpiler/support/hex.h"

namespace plcxx::soak {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr size_t kLongestText = 100;

std::string Hash64(std::string_view text) { return support::HexDigits(support::HashOf64(text), 16); }

constexpr std::string_view kGoalLetters = "sck";  // by GoalKind
constexpr std::string_view kCauseWords[] = {"property", "fault",   "loop",
                                            "stuck",    "endless", "message"};  // by CauseKind

std::string FirstLine(std::string_view text) {
  std::string line(text.substr(0, text.find_first_of("\r\n")));
  if (line.size() <= kLongestText) return line;
  size_t end = kLongestText;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
  return line.substr(0, end) + "...";
}

void AddOutputs(const scenarios::ProveMachine& machine, const OutputLife& life, const WatchPlan& plan, Record& record) {
  std::vector<execute::CellId> cells;
  std::map<execute::CellId, std::pair<bool, bool>> seen;  // 1, 0
  for (size_t i = 0; i < plan.outputs().size(); ++i) {
    const WatchPlan::OutputByte& byte = plan.outputs()[i];
    for (uint8_t bit = 0; bit < 8; ++bit) {
      if ((byte.mask >> bit & 1) == 0) continue;
      cells.push_back(plan.cells().OfBit(byte.space, byte.offset, bit));
      seen[cells.back()] = {(life.ones[i] >> bit & 1) != 0, (life.zeros[i] >> bit & 1) != 0};
    }
  }
  for (const scenarios::InputWord& word : scenarios::WordsOf(machine, cells)) {
    OutputRecord output{.name = word.name};
    if (output.name.empty()) {
      ++record.nameless_outputs;
      continue;
    }
    output.width = static_cast<uint8_t>(std::min<size_t>(64, word.cells.size()));
    for (size_t i = 0; i < output.width; ++i) {
      const auto found = seen.find(word.cells[i]);
      if (found == seen.end()) continue;
      output.ones |= uint64_t{found->second.first} << i;
      output.zeros |= uint64_t{found->second.second} << i;
    }
    record.outputs.push_back(std::move(output));
  }
}

Json JsonOf(const Record& record) {
  Json json;
  json["plcxx_soak"] = kVersion;
  json["program"] = record.program;
  json["program_hash"] = record.hash;
  json["seed"] = record.seed;
  json["machines"] = record.machines;
  json["shards"] = record.shards;
  json["works"] = record.works;
  json["machine_ms"] = record.machine_ms;
  json["scans"] = record.parts;
  json["scans_in_fleet"] = record.wide_parts;
  json["steps"] = record.steps;
  json["ended_by_time"] = record.out_of_time;
  json["ended_by_signal"] = record.was_asked_to_end;
  json["inputs"] = record.inputs;
  json["inputs_without_name"] = record.nameless;
  if (!record.plant.empty()) {
    json["plant"] = record.plant;
    json["inputs_of_plant"] = record.driven;
  }
  json["outputs_without_name"] = record.nameless_outputs;
  json["properties"] = record.properties;
  for (const auto& [name, kind] : {std::pair{"statements", GoalKind::kStatement},
                                   {"conditions", GoalKind::kCondition},
                                   {"cases", GoalKind::kCase}}) {
    const Count count = CountOf(record, kind);
    json["coverage"][name] = {{"reached", count.reached}, {"of", count.all}};
  }
  json["findings"] = Json::array();
  for (const FindingRecord& finding : record.findings) {
    Json one{{"kind", kCauseWords[static_cast<size_t>(finding.kind)]}, {"cause", finding.key}, {"text", finding.text}};
    if (finding.kind == CauseKind::kMessage) one["message"] = finding.number;
    one["steps"] = finding.steps;
    one["file"] = finding.file;
    if (!finding.not_shown.empty()) one["not_shown"] = finding.not_shown;
    json["findings"].push_back(std::move(one));
  }
  json["more_findings"] = record.more;
  json["not_repeated"] = record.not_repeated;
  json["outputs"] = Json::array();
  for (const OutputRecord& output : record.outputs) {
    json["outputs"].push_back({{"name", output.name},
                               {"width", output.width},
                               {"moved", output.moved()},
                               {"ones", output.ones},
                               {"zeros", output.zeros}});
  }
  json["messages"] = Json::array();
  for (const auto& [number, message] : record.messages) {
    json["messages"].push_back({{"number", number},
                                {"text", message.text},
                                {"came", message.life.came},
                                {"went", message.life.went},
                                {"stood_ms", message.life.stood_ms},
                                {"steps", message.life.steps}});
  }
  json["statements"] = Json::array();
  for (const StatementRecord& statement : record.statements) {
    std::string letters;
    for (const GoalKind goal : statement.goals) letters += kGoalLetters[static_cast<size_t>(goal)];
    json["statements"].push_back(
        {{"file", statement.file}, {"line", statement.line}, {"text", statement.text}, {"goals", letters}});
  }
  json["reached"] = record.reached.ToHex();
  json["corpus"] = Json::object();
  for (const auto& [name, goals] : record.corpus) json["corpus"][name] = goals.ToHex();
  return json;
}

std::string SeedAndMachines(const Record& record) {
  std::string text = "seed " + std::to_string(record.seed) + ", " + support::Counted(record.machines, "machine");
  for (const std::string& shard : record.shards) text += ", shard " + shard;
  return text;
}

std::string WorkCounted(const Record& record) {
  return SeedAndMachines(record) + ", " + std::to_string(record.machine_ms) + " ms, " + std::to_string(record.parts) +
         " scans, " + std::to_string(record.steps) + " steps";
}

/// Throws what nlohmann_json throws; not empty: what is wrong.
std::string ReadFrom(const Json& json, Record& record) {
  if (json.at("plcxx_soak") != kVersion) return std::string(kOfAnotherVersion);
  record.program = json.at("program");
  record.hash = json.at("program_hash");
  record.seed = json.at("seed");
  record.machines = json.at("machines");
  record.shards = json.at("shards").get<std::set<std::string>>();
  record.machine_ms = json.at("machine_ms");
  record.parts = json.at("scans");
  record.wide_parts = json.value("scans_in_fleet", uint64_t{0});
  record.steps = json.at("steps");
  record.out_of_time = json.at("ended_by_time");
  record.was_asked_to_end = json.value("ended_by_signal", false);
  record.inputs = json.at("inputs");
  record.nameless = json.at("inputs_without_name");
  record.plant = json.value("plant", "");
  record.driven = json.value("inputs_of_plant", size_t{0});
  record.nameless_outputs = json.at("outputs_without_name");
  record.properties = json.at("properties");
  // Earlier records do not have it: there the same is only what is equal in all that was counted.
  record.works = json.value("works", std::set<std::string>{WorkCounted(record)});
  record.more = json.at("more_findings").get<std::set<std::string>>();
  record.not_repeated = json.at("not_repeated").get<std::vector<std::string>>();
  for (const Json& one : json.at("findings")) {
    FindingRecord finding;
    const std::string kind = one.at("kind");
    const auto word = std::ranges::find(kCauseWords, kind);
    if (word == std::end(kCauseWords)) return "a finding is of no known kind";
    finding.kind = static_cast<CauseKind>(word - std::begin(kCauseWords));
    finding.number = one.value("message", 0U);
    finding.key = one.at("cause");
    finding.text = one.at("text");
    finding.steps = one.at("steps");
    finding.file = one.at("file");
    finding.not_shown = one.value("not_shown", "");
    if (finding.file.find_first_of("/\\") != std::string::npos) return "the file of a finding is not in the folder";
    record.findings.push_back(std::move(finding));
  }
  for (const Json& one : json.at("outputs")) {
    record.outputs.push_back(
        {.name = one.at("name"), .width = one.at("width"), .ones = one.at("ones"), .zeros = one.at("zeros")});
  }
  for (const Json& one : json.at("messages")) {
    MessageRecord& message = record.messages[one.at("number").get<uint32_t>()];
    message.text = one.at("text");
    message.life = {
        .came = one.at("came"), .went = one.at("went"), .stood_ms = one.at("stood_ms"), .steps = one.at("steps")};
  }
  for (const Json& one : json.at("statements")) {
    StatementRecord statement{.file = one.at("file"), .line = one.at("line"), .text = one.at("text"), .goals = {}};
    for (const char letter : one.at("goals").get<std::string>()) {
      const size_t kind = kGoalLetters.find(letter);
      if (kind == std::string_view::npos) return "a goal is of no known kind";
      statement.goals.push_back(static_cast<GoalKind>(kind));
    }
    record.statements.push_back(std::move(statement));
  }
  const size_t goals = record.GoalCount();
  if (!record.reached.FromHex(json.at("reached"), goals)) return "'reached' does not fit 'statements'";
  for (const auto& [name, digits] : json.at("corpus").items()) {
    if (name.find_first_of("/\\") != std::string::npos) return "a run is not in the folder";
    if (!record.corpus[name].FromHex(digits, goals)) return "'corpus' does not fit 'statements'";
  }
  return {};
}

}  // namespace

size_t Record::GoalCount() const {
  size_t count = 0;
  for (const StatementRecord& statement : statements) count += statement.goals.size();
  return count;
}

std::string CorpusName(const Stimuli& stimuli) {
  review::diff::WrittenSteps steps;
  for (const Stimulus& stimulus : stimuli) {
    if (stimulus.power_cycle) steps.AddPowerCycle();
    steps.Add(stimulus);
  }
  return "run-" + Hash64(steps.scenario) + ".yaml";
}

Record MakeRecord(const scenarios::ProveMachine& machine, const Soaked& soaked, const Goals& goals,
                  const Inputs& inputs, const WatchPlan& plan) {
  Record record;
  record.program = machine.compilation.name;
  record.hash = Hash64(ir::Print(plan.program()));
  record.machine_ms = soaked.machine_ms;
  record.parts = soaked.parts;
  record.wide_parts = soaked.wide_parts;
  record.steps = soaked.steps;
  record.out_of_time = soaked.out_of_time;
  record.was_asked_to_end = soaked.was_asked_to_end;
  record.inputs = inputs.all().size();
  record.nameless = inputs.nameless();
  record.driven = inputs.driven();
  record.properties = plan.properties().size();
  const source::SourceManager& sources = *machine.compilation.sources;
  ir::StatementId last;
  for (const Goal& goal : goals.all()) {
    if (record.statements.empty() || goal.statement != last) {
      const source::Range range = plan.program().statements[goal.statement].range;
      const source::Position position = sources.Locate(range.begin);
      StatementRecord statement;
      if (position.line != 0) {
        statement = {.file = sources.Get(position.file).path,
                     .line = position.line,
                     .text = FirstLine(sources.Text(range)),
                     .goals = {}};
      }
      record.statements.push_back(std::move(statement));
      last = goal.statement;
    }
    record.statements.back().goals.push_back(goal.kind);
  }
  record.reached = soaked.reached;
  for (const KeptRun& run : soaked.corpus) record.corpus.emplace(CorpusName(run.stimuli), run.goals);
  AddOutputs(machine, soaked.outputs, plan, record);
  for (const auto& [number, life] : soaked.messages) {
    MessageRecord message{.text = {}, .life = life};
    for (const ir::MessageText& text : plan.program().messages) {
      if (text.number == number) message.text = text.text;
    }
    record.messages.emplace(number, std::move(message));
  }
  for (const Finding& finding : soaked.findings) {
    record.findings.push_back({.kind = finding.cause.kind,
                               .number = finding.cause.number,
                               .key = finding.cause.key,
                               .text = finding.cause.text,
                               .steps = finding.steps,
                               .file = finding.file,
                               .not_shown = finding.not_shown});
  }
  record.more = soaked.more;
  for (const auto& [cause, why] : soaked.not_repeated) record.not_repeated.push_back(cause.text + ": " + why);
  return record;
}

std::string WorkWords(const Record& record, const SoakRequest& request, const WatchPlan& plan) {
  std::string all;
  for (const std::vector<Stimuli>* const runs : {&request.corpus, &request.scenarios}) {
    for (const Stimuli& run : *runs) all += CorpusName(run) + "\n";
    all += "\n";
  }
  for (const prove::properties::Property& property : plan.properties()) all += property.text + "\n";
  return SeedAndMachines(record) + (request.wide ? ", in a fleet" : "") + ", begins with " + Hash64(all);
}

std::string ToJson(const Record& record) {
  return JsonOf(record).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::variant<Record, std::string> ReadRecord(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return "it is no record of a soak: this is no JSON, or it ends too early";
  try {
    Record record;
    std::string wrong = ReadFrom(json, record);
    if (wrong.empty()) return record;
    return wrong;
  } catch (const Json::exception&) {
    return "it is no record of a soak: a field is missing, or has a value of another kind";
  }
}

std::string AddRecord(Record& record, const Record& other) {
  if (record.hash != other.hash || record.GoalCount() != other.GoalCount()) return "it is of another program";
  if (record.outputs.size() != other.outputs.size()) return "it has other outputs";
  if (record.plant != other.plant || record.driven != other.driven) return "its machines have another plant";
  for (const std::string& shard : other.shards) {
    if (!record.shards.insert(shard).second && record.seed == other.seed) return "shard " + shard + " is there twice";
  }
  for (const std::string& work : other.works) {
    if (!record.works.insert(work).second)
      return "the same work is there twice (" + work +
             "), and looked at nothing new; leave out the shorter of both, or " + "give one of them another --seed";
  }
  record.machines += other.machines;
  record.machine_ms += other.machine_ms;
  record.parts += other.parts;
  record.wide_parts += other.wide_parts;
  record.steps += other.steps;
  record.out_of_time = record.out_of_time || other.out_of_time;
  record.was_asked_to_end = record.was_asked_to_end || other.was_asked_to_end;
  record.reached.Add(other.reached);
  for (const auto& [name, goals] : other.corpus) record.corpus.emplace(name, goals);
  std::vector<std::string> names;
  std::vector<GoalSet> runs;
  for (const auto& [name, goals] : record.corpus) {
    names.push_back(name);
    runs.push_back(goals);
  }
  const std::vector<size_t> needed = Needed(runs, record.reached);
  for (size_t i = 0; i < names.size(); ++i) {
    if (!std::ranges::binary_search(needed, i)) record.corpus.erase(names[i]);
  }
  for (size_t i = 0; i < record.outputs.size(); ++i) {
    record.outputs[i].ones |= other.outputs[i].ones;
    record.outputs[i].zeros |= other.outputs[i].zeros;
  }
  for (const auto& [number, message] : other.messages) {
    const auto [at, is_new] = record.messages.emplace(number, message);
    if (!is_new) at->second.life.Add(message.life);
  }
  for (const FindingRecord& finding : other.findings) {
    const auto same = std::ranges::find(record.findings, finding.key, &FindingRecord::key);
    if (same == record.findings.end()) {
      record.findings.push_back(finding);
    } else if (finding.steps.size() < same->steps.size()) {
      *same = finding;
    }
  }
  record.more.insert(other.more.begin(), other.more.end());
  // What never goes in one of them may go in the other.
  std::erase_if(record.findings, [&record](const FindingRecord& finding) {
    return finding.kind == CauseKind::kMessage && record.messages[finding.number].life.went != 0;
  });
  for (const std::string& text : other.not_repeated) {
    if (std::ranges::find(record.not_repeated, text) == record.not_repeated.end()) record.not_repeated.push_back(text);
  }
  return {};
}

Count CountOf(const Record& record, GoalKind kind) {
  Count count;
  size_t goal = 0;
  for (const StatementRecord& statement : record.statements) {
    for (size_t i = 0; i < statement.goals.size(); ++i, ++goal) {
      if (statement.goals[i] != kind) continue;
      ++count.all;
      bool is_reached = record.reached.Has(goal);
      if (kind == GoalKind::kCondition) {
        // Both ways follow each other.
        ++i;
        is_reached = record.reached.Has(++goal) && is_reached;
      }
      if (is_reached) ++count.reached;
    }
  }
  return count;
}

}  // namespace plcxx::soak
