// A drawing as SVG: few elements, one path for all that is drawn with the same pen.

#include "transpiler/report/embedded_page.h"
#include "transpiler/report/html.h"
#include "transpiler/report/ladder_drawing.h"

namespace plcxx::report {
namespace {

std::string Number(int value) { return std::to_string(value); }

void Path(std::string& out, std::string_view pen, const std::string& path) {
  if (path.empty()) return;
  out += "<path class=\"";
  out += pen;
  out += "\" d=\"" + path + "\"/>";
}

constexpr const char* ClassOf(TextKind kind) {
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
  std::string classes = ClassOf(text.kind);
  if (text.anchor == Anchor::kStart) classes += classes.empty() ? "s" : " s";
  if (text.local) classes += classes.empty() ? "l" : " l";
  out += "<text x=\"" + Number(text.x) + "\" y=\"" + Number(text.y) + "\"";
  if (!classes.empty()) out += " class=\"" + classes + "\"";
  if (text.signal != kNoSignal) out += " data-s=\"" + Number(static_cast<int>(text.signal)) + "\"";
  out += ">" + Escape(text.text) + "</text>";
}

void Body(std::string& out, const Drawing& drawing) {
  Path(out, "f", PathOf(drawing.frames));
  Path(out, "r", PathOf(drawing.rails));
  Path(out, "w", PathOf(drawing.wires) + drawing.symbols);
  Path(out, "w d", drawing.local_symbols);
  Path(out, "b", PathOf(drawing.boxes));
  Path(out, "b d", PathOf(drawing.local_boxes));
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
  for (const Line& line : lines) {
    path += "M" + Number(line.x1) + " " + Number(line.y1);
    path += line.y1 == line.y2 ? "H" + Number(line.x2) : "V" + Number(line.y2);
  }
  return path;
}

std::string PathOf(std::span<const Rectangle> boxes) {
  std::string path;
  for (const Rectangle& box : boxes) {
    path += "M" + Number(box.x) + " " + Number(box.y) + "h" + Number(box.width) + "v" + Number(box.height) + "h-" +
            Number(box.width) + "z";
  }
  return path;
}

std::string SvgElement(const Drawing& drawing, std::string_view label) {
  std::string out = "<svg" + Attributes(drawing, label) + ">";
  Body(out, drawing);
  return out + "</svg>";
}

std::string SvgFile(const Drawing& drawing, std::string_view label) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Attributes(drawing, label) + ">\n<style>\n" +
                    std::string(PageFile("ladder.css")) + "</style>\n";
  Body(out, drawing);
  return out + "\n</svg>\n";
}

}  // namespace plcxx::report
