// Ladder items with coordinates, and as SVG.
//
// In: items (ladder.h). Out: lines, boxes and texts in pixels, x to the right, y down; then SVG. A network is drawn in
// series from left to right, branches one below the other between two uprights, so that no two wires can cross; a
// series that is too wide goes on in a line below, after arrows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/report/ladder.h"

namespace plcxx::report {

struct Line {  // horizontal or vertical
  int x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  uint32_t net = 0;  // of a wire
};
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};
enum class Anchor : uint8_t { kMiddle, kStart };
enum class TextKind : uint8_t { kName, kAddress, kTitle, kLine, kLabel, kComment };
struct DrawnText {
  int x = 0, y = 0;  // of the base line
  Anchor anchor = Anchor::kMiddle;
  TextKind kind = TextKind::kName;
  std::string text;
  uint32_t signal = kNoSignal;
  bool local = false;
};

/// What is connected by wires, so that one colour tells whether it carries power. Net 0 is the left rail.
enum class NetKind : uint8_t {
  kRail,
  kThrough,   // after a contact, comparison or box: from `from`, if `value` lets it through
  kOutput,    // after a box that has an output of its own: `value`
  kInverted,  // 1 where `from` is 0
  kAny,       // 1 where one of `from` is
  kNever
};
struct Net {
  NetKind kind{};
  std::vector<uint32_t> from;  // nets, each of a lower number
  ir::ValueId value;
  bool inverted = false;
};

/// One symbol: its share of what the pens draw, and the net after it.
struct DrawnSymbol {
  uint32_t net = 0;
  size_t symbols_begin = 0, symbols_end = 0, local_begin = 0, local_end = 0;  // of Drawing::symbols, local_symbols
  size_t boxes_begin = 0, boxes_end = 0, local_boxes_begin = 0, local_boxes_end = 0;
};

struct Drawing {
  int width = 0, height = 0;
  std::vector<Line> wires;          // between elements, and to the rails
  std::vector<Rectangle> elements;  // what each element occupies, its name and its stubs of wire included
  std::vector<Rectangle> boxes, local_boxes;
  std::string symbols, local_symbols;  // of contacts and coils, as SVG paths
  std::vector<Line> rails, frames;
  std::vector<DrawnText> texts;
  std::vector<Net> nets;
  std::vector<DrawnSymbol> parts;
};

/// A text above an item of the list, for pictures that stand alone.
struct Caption {
  size_t item = 0;  // stands above this one
  std::string text;
  TextKind kind = TextKind::kComment;
};

/// `captions` ascending by item.
Drawing Draw(std::span<const LadderItem> items, std::span<const Caption> captions = {});

/// Pixels that a text takes in the pictures' font; letters of East Asia take twice as much.
int TextWidth(std::string_view utf8);

/// The `d` of an SVG path.
std::string PathOf(std::span<const Line> lines);
std::string PathOf(std::span<const Rectangle> boxes);

/// An <svg> element as a part of a page, whose style sheet it uses; `label` is what a screen reader says.
void AppendSvgElement(const Drawing& drawing, std::string_view label, std::string& out);
/// A file of its own, with its style.
std::string SvgFile(const Drawing& drawing, std::string_view label);

}  // namespace plcxx::report
