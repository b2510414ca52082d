#include "transpiler/plant/panel.h"

#include "transpiler/plant/elements.h"

namespace plcxx::plant {
namespace {

constexpr ControlRow kControls[] = {
#define PLCXX_PANEL_CONTROL(Id, Text, Meaning) {ControlKind::k##Id, Text, Meaning},
#define PLCXX_PANEL_KEY(Id, Text, ShapeOf, Meaning, Default)
#include "transpiler/plant/panel.def"
#undef PLCXX_PANEL_CONTROL
#undef PLCXX_PANEL_KEY
};

constexpr ControlKeyRow kControlKeys[] = {
#define PLCXX_PANEL_CONTROL(Id, Text, Meaning)
#define PLCXX_PANEL_KEY(Id, Text, ShapeOf, Meaning, Default) \
  {ControlKind::k##Id, Text, PanelShape::ShapeOf, Meaning, Default},
#include "transpiler/plant/panel.def"
#undef PLCXX_PANEL_CONTROL
#undef PLCXX_PANEL_KEY
};

}  // namespace

std::span<const ControlRow> Controls() { return kControls; }

std::string_view NameOf(ControlKind kind) { return kControls[static_cast<size_t>(kind)].text; }

std::vector<const ControlKeyRow*> KeysOf(ControlKind kind) {
  std::vector<const ControlKeyRow*> rows;
  for (const ControlKeyRow& row : kControlKeys) {
    if (row.control == kind) rows.push_back(&row);
  }
  return rows;
}

std::vector<std::string_view> WordsOf(PanelShape shape) {
  switch (shape) {
    case PanelShape::kContact:
      return {"closes", "opens"};
    case PanelShape::kStart:
      return {"off", "on"};
    case PanelShape::kColor:
      return {"white", "green", "yellow", "red", "blue"};
    case PanelShape::kCoding:
      return WordsOf(Shape::kCoding);
    case PanelShape::kBase:
      return {"dec", "signed", "hex", "bcd"};
    case PanelShape::kInputs:
    case PanelShape::kLocation:
    case PanelShape::kSettings:
    case PanelShape::kCondition:
    case PanelShape::kText:
    case PanelShape::kTexts:
    case PanelShape::kNumber:
    case PanelShape::kNumbers:
      break;
  }
  return {};
}

}  // namespace plcxx::plant
