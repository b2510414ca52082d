#include "transpiler/live/program_view.h"

#include <algorithm>

#include "transpiler/live/linked_commands.h"
#include "transpiler/report/ladder_drawing.h"

namespace plcxx::live {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint32_t kNone = 0xFFFFFFFF;

constexpr const char* NameOf(SignalGroup group) {
  switch (group) {
    case SignalGroup::kInput:
      return "input";
    case SignalGroup::kOutput:
      return "output";
    case SignalGroup::kInternal:
      return "internal";
    case SignalGroup::kRetentive:
      return "retentive";
    case SignalGroup::kInstance:
      return "instance";
  }
  return "";
}

constexpr const char* NameOf(StepKind kind) {
  switch (kind) {
    case StepKind::kPeriod:
      return "period";
    case StepKind::kFast:
      return "fast";
    case StepKind::kSlow:
      return "slow";
    case StepKind::kSlice:
      return "slice";
    case StepKind::kStatement:
      return "statement";
  }
  return "";
}

constexpr const char* NameOf(report::NetKind kind) {
  switch (kind) {
    case report::NetKind::kRail:
      return "rail";
    case report::NetKind::kThrough:
      return "through";
    case report::NetKind::kOutput:
      return "output";
    case report::NetKind::kInverted:
      return "inverted";
    case report::NetKind::kAny:
      return "any";
    case report::NetKind::kNever:
      return "never";
  }
  return "";
}

constexpr const char* ClassOf(report::TextKind kind) {
  switch (kind) {
    case report::TextKind::kName:
      return "";
    case report::TextKind::kAddress:
      return "a";
    case report::TextKind::kTitle:
      return "t";
    case report::TextKind::kLine:
      return "v";
    case report::TextKind::kLabel:
      return "k";
    case report::TextKind::kComment:
      return "c";
  }
  return "";
}

Json SignalsJson(const Session& session) {
  Json list = Json::array();
  for (const LiveSignal& signal : session.signals().signals) {
    const bool is_signed = signal.location && signal.location->has_sign;
    list.push_back({{"name", signal.name},
                    {"address", signal.address},
                    {"words", signal.words},
                    {"type", signal.type},
                    {"group", NameOf(signal.group)},
                    {"signed", is_signed},
                    {"named", signal.can_be_named},
                    {"driven", signal.location ? session.DriverOf(*signal.location) : ""}});
  }
  return list;
}

/// "dec" where the file does not say how a number is shown.
std::string BaseOf(const BoundPanel& panel, const plant::PanelControl& control) {
  if (!control.base.empty()) return control.base;
  return control.shows && panel.reads[*control.shows].has_sign ? "signed" : "dec";
}

Json PanelJson(const BoundPanel& panel) {
  Json groups = Json::array();
  size_t number = 0;
  for (const plant::PanelGroup& group : panel.panel.groups) {
    Json controls = Json::array();
    for (const plant::PanelControl& control : group.controls) {
      Json one = {{"number", number++},     {"kind", std::string(plant::NameOf(control.kind))},
                  {"text", control.text},   {"color", control.color},
                  {"width", control.width}, {"column", control.column},
                  {"row", control.row}};
      if (!control.labels.empty()) one["labels"] = control.labels;
      if (control.kind == plant::ControlKind::kButton) one["lamp"] = control.lamp.has_value();
      if (control.shows) {
        one["base"] = BaseOf(panel, control);
        one["unit"] = control.unit;
        one["type"] = std::string(ir::Name(panel.reads[*control.shows].place.type));
      }
      controls.push_back(std::move(one));
    }
    groups.push_back({{"title", group.title}, {"columns", group.columns}, {"controls", std::move(controls)}});
  }
  return {{"title", panel.panel.title}, {"groups", std::move(groups)}};
}

/// Pixels that the page gives a row before it has been drawn.
size_t HeightOf(const report::Row& row) { return std::max(row.source.size() * 18, row.ladder.size() * 46) + 14; }

std::string PartOf(const std::string& pen, size_t begin, size_t end) { return pen.substr(begin, end - begin); }

}  // namespace

ProgramView::ProgramView(const Session& session)
    : session_(session),
      rows_(report::MakeRows(session.input(), report::MakeLadders(session.input(), session.uses()))),
      power_of_(session.program().insts.size(), kNone) {
  for (const report::Row& row : rows_.rows) {
    for (const report::Net& net : report::Draw(row.ladder).nets) {
      if (net.value.valid()) PowerOf(net.value);
    }
  }
}

uint32_t ProgramView::PowerOf(ir::ValueId value) {
  uint32_t& number = power_of_[value.index];
  if (number == kNone) {
    number = static_cast<uint32_t>(power_.size());
    power_.push_back(value);
  }
  return number;
}

Json ProgramView::Outline() const {
  const compilation::Compilation& compilation = session_.compilation();
  Json outline;
  outline["name"] = compilation.name;
  outline["control"] = std::string(compilation.dialect->title);
  outline["dialect"] = std::string(compilation.dialect->name);
  outline["unitMs"] = session_.unit_ms();
  outline["mostBack"] = kMostBack;
  outline["mostWatched"] = kMostWatched;
  Json steps = Json::array();
  for (const StepKind kind :
       {StepKind::kStatement, StepKind::kPeriod, StepKind::kFast, StepKind::kSlice, StepKind::kSlow}) {
    if (session_.CanStep(kind)) steps.push_back(NameOf(kind));
  }
  outline["steps"] = steps;
  if (const std::optional<LinkStatus>& link = session_.link().status()) {
    Json refused = Json::object();
    for (const std::string& command : CommandNames()) {
      if (const std::string_view reason = RefusedOverLink(command); !reason.empty()) refused[command] = reason;
    }
    outline["link"] = {{"address", link->address}, {"refused", std::move(refused)}};
  }
  outline["signals"] = SignalsJson(session_);
  Json statements = Json::array();
  for (uint32_t i = 0; i < rows_.of_statement.size(); ++i) {
    const ir::Statement& statement = session_.program().statements[ir::StatementId(i)];
    statements.push_back({{"row", rows_.of_statement[i] == report::kNoRow ? -1 : int64_t{rows_.of_statement[i]}},
                          {"subject", statement.subject},
                          {"line", session_.input().sources->Locate(statement.range.begin).line}});
  }
  outline["statements"] = statements;
  Json heights = Json::array();
  for (const report::Row& row : rows_.rows) heights.push_back(HeightOf(row));
  outline["rows"] = heights;
  if (session_.hands().panel() != nullptr) outline["panel"] = PanelJson(*session_.hands().panel());
  return outline;
}

Json ProgramView::Drawn(const std::vector<report::LadderItem>& items) const {
  const report::Drawing drawing = report::Draw(items);
  Json drawn;
  drawn["w"] = drawing.width;
  drawn["h"] = drawing.height;
  drawn["frames"] = report::PathOf(drawing.frames);
  drawn["rails"] = report::PathOf(drawing.rails);
  Json nets = Json::array();
  for (const report::Net& net : drawing.nets) {
    Json one = {{"kind", NameOf(net.kind)}, {"from", net.from}};
    if (net.value.valid()) {
      one["bit"] = power_of_[net.value.index];
      one["inverted"] = net.inverted;
    }
    std::vector<report::Line> wires;
    for (const report::Line& wire : drawing.wires) {
      if (&drawing.nets[wire.net] == &net) wires.push_back(wire);
    }
    one["wires"] = report::PathOf(wires);
    nets.push_back(std::move(one));
  }
  drawn["nets"] = std::move(nets);
  Json symbols = Json::array();
  const auto boxes = [](const std::vector<report::Rectangle>& all, size_t begin, size_t end) {
    return report::PathOf(std::span(all).subspan(begin, end - begin));
  };
  for (const report::DrawnSymbol& part : drawing.parts) {
    symbols.push_back({{"net", part.net},
                       {"pen", PartOf(drawing.symbols, part.symbols_begin, part.symbols_end)},
                       {"local", PartOf(drawing.local_symbols, part.local_begin, part.local_end)},
                       {"box", boxes(drawing.boxes, part.boxes_begin, part.boxes_end)},
                       {"localBox", boxes(drawing.local_boxes, part.local_boxes_begin, part.local_boxes_end)}});
  }
  drawn["symbols"] = std::move(symbols);
  Json texts = Json::array();
  for (const report::DrawnText& text : drawing.texts) {
    std::string classes = ClassOf(text.kind);
    if (text.anchor == report::Anchor::kStart) classes += " s";
    if (text.local) classes += " l";
    const uint32_t listed =
        text.signal == report::kNoSignal ? report::kNoSignal : session_.signals().of_reference[text.signal];
    texts.push_back({text.x, text.y, classes, text.text, listed == report::kNoSignal ? -1 : int64_t{listed}});
  }
  drawn["texts"] = std::move(texts);
  return drawn;
}

Json ProgramView::Rows(size_t begin, size_t end) const {
  Json list = Json::array();
  const source::SourceManager& sources = *session_.input().sources;
  for (size_t i = begin; i < std::min(end, rows_.rows.size()); ++i) {
    const report::Row& row = rows_.rows[i];
    Json one;
    one["row"] = i;
    one["file"] = row.file.valid() ? std::string(report::FileName(sources.Get(row.file).path)) : "";
    one["title"] = row.title;
    one["heads"] = i == 0 || rows_.rows[i - 1].file != row.file;
    Json statements = Json::array();
    for (const ir::StatementId id : row.statements) statements.push_back(id.index);
    one["statements"] = std::move(statements);
    Json lines = Json::array();
    for (const report::SourceLine& line : row.source) {
      lines.push_back({line.number, std::string(line.text), line.comment});
    }
    one["source"] = std::move(lines);
    if (!row.ladder.empty()) one["ladder"] = Drawn(row.ladder);
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace plcxx::live
