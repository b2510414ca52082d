// The operator's panel of a machine, as panel.yaml lays it out: what is on it, and which locations it works on.
//
// In: the file's text. Out: groups of controls, each with what operating it writes and what it shows, or all that is
// wrong. What is written on a panel is text for people. Not its job: what a name is in a program, and drawing (live/).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/plant/condition.h"
#include "transpiler/yaml/place.h"

namespace plcxx::plant {

enum class ControlKind : uint8_t {
#define PLCXX_PANEL_CONTROL(Id, Text, Meaning) k##Id,
#define PLCXX_PANEL_KEY(Id, Text, Shape, Meaning, Default)
#include "transpiler/plant/panel.def"
#undef PLCXX_PANEL_CONTROL
#undef PLCXX_PANEL_KEY
};

enum class PanelShape : uint8_t {
  kInputs,     // a location that operating it writes, or a list of them
  kLocation,   // one
  kSettings,   // a map from locations to whole numbers
  kCondition,  // of locations
  kText,
  kTexts,    // a list
  kNumber,   // a whole number from 1
  kNumbers,  // a list of whole numbers
  kContact,  // closes or opens
  kStart,    // on or off
  kColor,
  kCoding,
  kBase
};

struct ControlRow {
  ControlKind kind;
  std::string_view text;
  std::string_view meaning;  // Markdown
};
struct ControlKeyRow {
  ControlKind control;
  std::string_view text;
  PanelShape shape;
  std::string_view meaning;      // Markdown
  std::string_view when_absent;  // Markdown
};
std::span<const ControlRow> Controls();
std::string_view NameOf(ControlKind kind);
std::vector<const ControlKeyRow*> KeysOf(ControlKind kind);
/// The words that a shape allows; empty where others may be.
std::vector<std::string_view> WordsOf(PanelShape shape);

/// A location that gets a value.
struct Setting {
  uint32_t write = 0;  // of Panel::writes
  int64_t value = 0;
};

struct PanelControl {
  ControlKind kind{};
  yaml::Place mark;
  std::string text;
  /// What each position writes. Of a button and its like the first is released (off), the second pressed (on).
  std::vector<std::vector<Setting>> positions;
  std::vector<std::string> labels;  // of the positions, where they have some
  uint32_t start = 0;               // position at delivery
  std::optional<Condition> lamp;
  std::optional<uint32_t> shows;  // of Panel::reads
  std::string color, base, unit;
  uint32_t column = 0, row = 0;  // from 1; 0: where there is room
  uint32_t width = 1;            // columns
};

struct PanelGroup {
  std::string title;
  uint32_t columns = 4;
  std::vector<PanelControl> controls;
};

struct Panel {
  std::string path, title;
  std::vector<PanelGroup> groups;
  std::vector<yaml::MarkedText> writes, reads;  // locations, each once
};

using PanelOrErrors = std::variant<Panel, std::vector<yaml::Error>>;
PanelOrErrors ReadPanel(const std::string& path);
/// As ReadPanel, from a text in memory.
PanelOrErrors ParsePanel(const std::string& path, const std::string& text);

}  // namespace plcxx::plant
