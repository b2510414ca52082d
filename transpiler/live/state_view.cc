#include "transpiler/live/state_view.h"

#include <algorithm>

#include "transpiler/explanation/instance_text.h"
#include "transpiler/live/wishes.h"

namespace plcxx::live {
namespace {

using Json = nlohmann::ordered_json;

/// A number where JavaScript has it exactly, else its digits.
Json Exact(uint64_t value) {
  constexpr uint64_t kMost = uint64_t{1} << 53;
  if (value <= kMost) return value;
  return std::to_string(value);
}

constexpr const char* KindName(BreakKind kind) {
  switch (kind) {
    case BreakKind::kStatement:
      return "statement";
    case BreakKind::kChange:
      return "change";
    case BreakKind::kCondition:
      return "condition";
  }
  return "";
}

constexpr const char* KindName(NoteKind kind) {
  switch (kind) {
    case NoteKind::kMessage:
      return "message";
    case NoteKind::kCall:
      return "call";
    case NoteKind::kFault:
      return "fault";
    case NoteKind::kLink:
      return "link";
  }
  return "";
}

constexpr const char* KindName(TriggerState state) {
  switch (state) {
    case TriggerState::kArmed:
      return "armed";
    case TriggerState::kStarted:
      return "started";
    case TriggerState::kComplete:
      return "complete";
  }
  return "";
}

Json SampleJson(const ChartSample& sample) {
  Json values = Json::array();
  for (const uint64_t value : sample.values) values.push_back(Exact(value));
  return {sample.period, sample.time_ms, std::move(values)};
}

}  // namespace

void StateView::AddPart(Json& state, const char* key, Json value) {
  if (parts_.contains(key) && parts_[key] == value) return;
  parts_[key] = value;
  state[key] = std::move(value);
}

void StateView::AddValues(Json& state) {
  Machine& machine = session_.timeline().machine();
  const std::vector<LiveSignal>& signals = session_.signals().signals;
  values_.resize(signals.size());
  texts_.resize(signals.size());
  is_known_.resize(signals.size());
  Json changed = Json::array();
  for (uint32_t i = 0; i < signals.size(); ++i) {
    if (signals[i].state.valid()) {
      std::string text =
          explanation::InstanceText(session_.program(), signals[i].state, machine.simulator().instances());
      if (is_known_[i] && text == texts_[i]) continue;
      changed.push_back({i, text});
      texts_[i] = std::move(text);
    } else {
      const uint64_t value = machine.Read(*signals[i].location);
      if (is_known_[i] && value == values_[i]) continue;
      changed.push_back({i, Exact(value)});
      values_[i] = value;
    }
    is_known_[i] = true;
  }
  if (!changed.empty()) state["values"] = std::move(changed);
}

/// The numbers of bits that are now different from what they were; at first of those that are 1.
void StateView::AddPower(Json& state) {
  const sim::Simulator& simulator = session_.timeline().machine().simulator();
  const std::vector<ir::ValueId>& bits = program_.power();
  power_.resize(bits.size());
  Json changed = Json::array();
  for (uint32_t i = 0; i < bits.size(); ++i) {
    const bool now = (simulator.ValueOf(bits[i]) & 1) != 0;
    if (power_[i] != now) changed.push_back(i);
    power_[i] = now;
  }
  if (!changed.empty() || !has_power_) state["power"] = std::move(changed);
  has_power_ = true;
}

void StateView::AddExecuted(Json& state) {
  const Machine& machine = session_.timeline().machine();
  const std::vector<uint32_t>& last = machine.executed();
  // A slow part that is cut into slices comes by in several periods.
  uint32_t recent = 1;
  for (const ir::Routine& routine : session_.program().routines) recent = std::max<uint32_t>(recent, routine.slices);
  executed_.resize(last.size());
  Json changed = Json::array();
  for (uint32_t i = 0; i < last.size(); ++i) {
    const bool now = last[i] != 0 && machine.stretch() - last[i] < recent;
    if (executed_[i] != now) changed.push_back(i);
    executed_[i] = now;
  }
  if (!changed.empty() || !has_executed_) state["executed"] = std::move(changed);
  has_executed_ = true;
}

void StateView::AddChart(Json& state) {
  const Chart& chart = session_.chart();
  Json samples = Json::array();
  const bool is_new = !has_chart_ || chart.version() != chart_version_;
  if (is_new) {
    next_sample_ = 0;
    Json watched = Json::array();
    for (const sim::Watched& one : chart.watched()) {
      watched.push_back({{"name", one.name},
                         {"type", std::string(ir::Name(one.place.type))},
                         {"signed", one.sign == sim::Sign::kTwosComplement}});
    }
    state["watched"] = std::move(watched);
  }
  const auto begin = std::ranges::lower_bound(chart.samples(), next_sample_, {}, &ChartSample::period);
  for (auto sample = begin; sample != chart.samples().end(); ++sample) samples.push_back(SampleJson(*sample));
  if (!chart.samples().empty()) next_sample_ = chart.samples().back().period + 1;
  if (is_new || !samples.empty()) state[is_new ? "chart" : "more"] = std::move(samples);
  Json trigger;
  if (chart.trigger()) {
    const Chart::Trigger& armed = *chart.trigger();
    trigger = {{"text", armed.request.text},
               {"state", KindName(armed.state)},
               {"atMs", armed.at_ms},
               {"kept", armed.kept.size()},
               {"samples", armed.request.samples}};
    if (armed.state == TriggerState::kComplete && is_new) {
      Json kept = Json::array();
      for (const ChartSample& sample : armed.kept) kept.push_back(SampleJson(sample));
      state["kept"] = std::move(kept);
    }
  }
  AddPart(state, "trigger", std::move(trigger));
  has_chart_ = true;
  chart_version_ = chart.version();
}

void StateView::AddNotes(Json& state) {
  if (has_notes_ && notes_version_ == session_.notes().version()) return;
  Json notes = Json::array();
  for (const Note& note : session_.notes().all()) {
    notes.push_back({{"kind", KindName(note.kind)},
                     {"period", note.period},
                     {"ms", note.time_ms},
                     {"text", note.text},
                     {"statement", note.statement.valid() ? int64_t{note.statement.index} : -1}});
  }
  state["notes"] = std::move(notes);
  notes_version_ = session_.notes().version();
  has_notes_ = true;
}

void StateView::AddWhereItIs(Json& state) {
  if (const std::optional<LinkStatus>& link = session_.link().status()) {
    AddPart(state, "at",
            {{"period", link->scans},
             {"first", link->scans},
             {"end", link->scans},
             {"ms", uint64_t{link->scans} * session_.unit_ms()},
             {"statement", -1}});
    AddPart(state, "mode",
            {{"running", link->is_connected},
             {"on", true},
             {"speed", 1},
             {"why", link->is_connected ? "" : "no connection"},
             {"opened", ""}});
    AddPart(state, "link",
            {{"connected", link->is_connected},
             {"reason", link->reason},
             {"canWrite", link->can_write},
             {"mayWrite", link->may_write},
             {"forcedBytes", link->forced_bytes},
             {"lost", Exact(link->lost)},
             {"roundMs", link->round_ms}});
    return;
  }
  Timeline& timeline = session_.timeline();
  AddPart(state, "at",
          {{"period", timeline.period()},
           {"first", timeline.first()},
           {"end", timeline.end()},
           {"ms", timeline.machine().time_ms()},
           {"statement", timeline.at().valid() ? int64_t{timeline.at().index} : -1}});
  AddPart(state, "mode",
          {{"running", session_.is_running()},
           {"on", session_.is_on()},
           {"speed", session_.speed()},
           {"why", session_.why_stopped()},
           {"opened", session_.opened()}});
}

Json StateView::Changes() {
  Json state = Json::object();
  Timeline& timeline = session_.timeline();
  AddWhereItIs(state);
  AddValues(state);
  AddPower(state);
  AddExecuted(state);
  Json forced = Json::array();
  for (const Forced& one : session_.forced()) forced.push_back({one.name, Exact(one.value)});
  AddPart(state, "forced", std::move(forced));
  Json off = Json::array();
  for (uint32_t i = 0; i < timeline.machine().off().size(); ++i) {
    if (timeline.machine().off()[i]) off.push_back(i);
  }
  AddPart(state, "off", std::move(off));
  Json breakpoints = Json::array();
  for (const Breakpoint& one : session_.breakpoints().all()) {
    breakpoints.push_back({{"number", one.number},
                           {"kind", KindName(one.kind)},
                           {"text", one.text},
                           {"statement", one.statement.valid() ? int64_t{one.statement.index} : -1}});
  }
  AddPart(state, "breakpoints", std::move(breakpoints));
  if (session_.hands().panel() != nullptr) {
    Json panel = Json::array();
    for (const ControlState& control : session_.hands().States()) {
      panel.push_back({control.position, control.is_lit, Exact(control.value)});
    }
    AddPart(state, "panel", std::move(panel));
  }
  AddPart(state, "messages", ActiveMessages(session_));
  AddNotes(state);
  AddChart(state);
  return state;
}

}  // namespace plcxx::live
