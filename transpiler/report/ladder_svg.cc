// A drawing as SVG: few elements, one path for all that is drawn with the same pen.

#include "transpiler/report/embedded_page.h"
#include "transpiler/report/html.h"
#include "transpiler/report/ladder_drawing.h"

namespace plcxx::report {
namespace {

std::string Number(int value) { return std::to_string(value); }

// Straight into `out`: the ladders of nested statements are most of a page of many megabytes.
void AppendShapes(std::string& out, std::span<const Line> lines) {
  for (const Line& line : lines) {
    out += "M" + Number(line.x1) + " " + Number(line.y1);
    out += line.y1 == line.y2 ? "H" + Number(line.x2) : "V" + Number(line.y2);
  }
}

void AppendShapes(std::string& out, std::span<const Rectangle> boxes) {
  for (const Rectangle& box : boxes) {
    out += "M" + Number(box.x) + " " + Number(box.y) + "h" + Number(box.width) + "v" + Number(box.height) + "h-" +
           Number(box.width) + "z";
  }
}

/// `symbols`: what else is drawn with this pen.
template <class Shape>
void Path(std::string& out, std::string_view pen, std::span<const Shape> shapes, std::string_view symbols) {
  if (shapes.empty() && symbols.empty()) return;
  out += "<path class=\"";
  out += pen;
  out += "\" d=\"";
  AppendShapes(out, shapes);
  out += symbols;
  out += "\"/>";
}

constexpr const char* TextClassOf(TextKind kind) {
  switch (kind) {
    case TextKind::kName:
      return "";
    case TextKind::kAddress:
      return "a";
    case TextKind::kTitle:
      return "t";
    case TextKind::kLine:
      return "v";
    case TextKind::kLabel:
      return "k";
    case TextKind::kComment:
      return "c";
  }
  return "";
}

void Text(std::string& out, const DrawnText& text) {
  std::string classes = TextClassOf(text.kind);
  if (text.anchor == Anchor::kStart) classes += classes.empty() ? "s" : " s";
  if (text.local) classes += classes.empty() ? "l" : " l";
  out += "<text x=\"" + Number(text.x) + "\" y=\"" + Number(text.y) + "\"";
  if (!classes.empty()) out += " class=\"" + classes + "\"";
  if (text.signal != kNoSignal) out += " data-s=\"" + Number(static_cast<int>(text.signal)) + "\"";
  out += ">" + Escape(text.text) + "</text>";
}

void Body(std::string& out, const Drawing& drawing) {
  Path<Line>(out, "f", drawing.frames, "");
  Path<Line>(out, "r", drawing.rails, "");
  Path<Line>(out, "w", drawing.wires, drawing.symbols);
  Path<Line>(out, "w d", {}, drawing.local_symbols);
  Path<Rectangle>(out, "b", drawing.boxes, "");
  Path<Rectangle>(out, "b d", drawing.local_boxes, "");
  for (const DrawnText& text : drawing.texts) Text(out, text);
}

std::string Attributes(const Drawing& drawing, std::string_view label) {
  const std::string width = Number(drawing.width), height = Number(drawing.height);
  return " class=\"ladder\" role=\"img\" aria-label=\"" + Escape(label) + "\" width=\"" + width + "\" height=\"" +
         height + "\" viewBox=\"0 0 " + width + " " + height + "\"";
}

}  // namespace

std::string PathOf(std::span<const Line> lines) {
  std::string path;
  AppendShapes(path, lines);
  return path;
}

std::string PathOf(std::span<const Rectangle> boxes) {
  std::string path;
  AppendShapes(path, boxes);
  return path;
}

void AppendSvgElement(const Drawing& drawing, std::string_view label, std::string& out) {
  out += "<svg" + Attributes(drawing, label) + ">";
  Body(out, drawing);
  out += "</svg>";
}

std::string SvgFile(const Drawing& drawing, std::string_view label) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Attributes(drawing, label) + ">\n<style>\n" +
                    std::string(PageFile("ladder.css")) + "</style>\n";
  Body(out, drawing);
  out += "\n</svg>\n";
  return out;
}

}  // namespace plcxx::report
