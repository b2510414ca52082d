#include "transpiler/report/ladder_symbols.h"

#include <algorithm>

#include "transpiler/source/columns.h"

namespace plcxx::report {
namespace {

using source::ColumnsOf;

constexpr int kLeast = 44;   // width of a contact or coil with a short name
constexpr int kMargin = 5;   // beside a text
constexpr int kNameUp = 26;  // what a name above the wire needs
constexpr int kBelow = 11;   // what a symbol needs below it
constexpr int kAddressBelow = 23;
constexpr int kLine = 14;            // height of a line in a box
constexpr int kBoxTop = 12;          // from the wire to the box's upper edge
constexpr int kStub = 6;             // of wire beside a box
constexpr size_t kMostColumns = 34;  // of a line in a box

/// The bytes of the next character of UTF-8.
size_t CharacterSize(unsigned char first) { return first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4; }

/// Broken at blanks, and where there is none, anywhere.
void Wrap(std::string_view text, std::vector<std::string>& lines) {
  while (ColumnsOf(text) > kMostColumns) {
    size_t end = 0, blank = 0;
    for (size_t columns = 0; end < text.size() && columns < kMostColumns;) {
      const size_t size = CharacterSize(static_cast<unsigned char>(text[end]));
      if (text[end] == ' ') blank = end;
      columns += ColumnsOf(text.substr(end, size));
      end += size;
    }
    const size_t cut = blank > 0 ? blank : std::min(end, text.size());
    lines.emplace_back(text.substr(0, cut));
    text.remove_prefix(blank > 0 ? cut + 1 : cut);
  }
  if (!text.empty()) lines.emplace_back(text);
}

/// The lines in the box. An assignment reads as one: "TWANT := TNOW + 1".
std::vector<std::string> BoxLines(const Element& box) {
  std::vector<std::string> lines;
  if (box.title == ":=") {
    Wrap(box.name + " := " + (box.lines.empty() ? "" : box.lines.front()), lines);
    return lines;
  }
  Wrap(box.title, lines);
  for (const std::string& line : box.lines) Wrap(line, lines);
  return lines;
}

bool NameAboveBox(const Element& box) { return !box.name.empty() && box.title != ":="; }

Extent BoxExtent(const Element& box) {
  Extent extent;
  const std::vector<std::string> lines = BoxLines(box);
  for (const std::string& line : lines) extent.width = std::max(extent.width, TextWidth(line));
  extent.width += 2 * kMargin;
  if (NameAboveBox(box)) extent.width = std::max(extent.width, TextWidth(box.name));
  extent.width = std::max(extent.width + 2 * kStub, kLeast);
  extent.up = kBoxTop + (NameAboveBox(box) ? kLine : 2);
  extent.down = static_cast<int>(lines.size()) * kLine + 6 - kBoxTop + 2;
  return extent;
}

std::string Move(int x, int y) { return "M" + std::to_string(x) + " " + std::to_string(y); }
std::string Horizontal(int x) { return "H" + std::to_string(x); }
std::string Vertical(int y) { return "V" + std::to_string(y); }

class Symbol {
 public:
  Symbol(const Element& element, int x, int y, Drawing& drawing)
      : element_(element),
        extent_(SymbolExtent(element)),
        x_(x),
        y_(y),
        drawing_(drawing),
        path_(element.local ? drawing.local_symbols : drawing.symbols) {}

  int Run();

 private:
  int right() const { return x_ + extent_.width; }
  int middle() const { return x_ + extent_.width / 2; }
  void Text(int x, int y, Anchor anchor, TextKind kind, const std::string& text, uint32_t signal = kNoSignal) {
    drawing_.texts.push_back({x, y, anchor, kind, text, signal, element_.local});
  }
  void Names() {
    Text(middle(), y_ - 14, Anchor::kMiddle, TextKind::kName, element_.name, element_.signal);
    if (!element_.address.empty()) {
      Text(middle(), y_ + 20, Anchor::kMiddle, TextKind::kAddress, element_.address, element_.signal);
    }
  }
  /// Two bars at `half` beside the middle, wires up to them.
  void Bars(int half) {
    drawing_.symbols += Move(x_, y_) + Horizontal(middle() - half) + Move(middle() + half, y_) + Horizontal(right());
    path_ += Move(middle() - half, y_ - 9) + Vertical(y_ + 9) + Move(middle() + half, y_ - 9) + Vertical(y_ + 9);
  }
  void Contact();
  void Compare();
  void Coil(const char* letter);
  void Box();
  void Target();

  const Element& element_;
  Extent extent_;
  int x_, y_;
  Drawing& drawing_;
  std::string& path_;
};

void Symbol::Contact() {
  Bars(5);
  if (element_.shape == Shape::kNotContact)
    path_ += Move(middle() - 8, y_ + 8) + "L" + std::to_string(middle() + 8) + " " + std::to_string(y_ - 8);
  Names();
}

void Symbol::Compare() {
  Bars(TextWidth(element_.title) / 2 + 4);
  Text(middle(), y_ + 4, Anchor::kMiddle, TextKind::kTitle, element_.title);
  Names();
  if (!element_.lines.empty()) {
    Text(middle(), y_ + 20, Anchor::kMiddle, TextKind::kLine, element_.lines.front());
  }
}

void Symbol::Coil(const char* letter) {
  const int half = 9;
  drawing_.symbols += Move(x_, y_) + Horizontal(middle() - half) + Move(middle() + half, y_) + Horizontal(right());
  const std::string x = std::to_string(2 * half);
  path_ += Move(middle() - half, y_) + "a9 9 0 0 1 " + x + " 0a9 9 0 0 1 -" + x + " 0";
  if (*letter != '\0') Text(middle(), y_ + 4, Anchor::kMiddle, TextKind::kTitle, letter);
  Names();
}

void Symbol::Box() {
  const int top = y_ - kBoxTop;
  const std::vector<std::string> lines = BoxLines(element_);
  drawing_.symbols += Move(x_, y_) + Horizontal(x_ + kStub) + Move(right() - kStub, y_) + Horizontal(right());
  const Rectangle box{x_ + kStub, top, extent_.width - 2 * kStub, static_cast<int>(lines.size()) * kLine + 6};
  (element_.local ? drawing_.local_boxes : drawing_.boxes).push_back(box);
  if (NameAboveBox(element_)) {
    Text(middle(), top - 3, Anchor::kMiddle, TextKind::kName, element_.name, element_.signal);
  }
  for (size_t i = 0; i < lines.size(); ++i) {
    const bool assigns = element_.title == ":=";
    Text(box.x + kMargin, top + 14 + static_cast<int>(i) * kLine, Anchor::kStart,
         i == 0 && !assigns ? TextKind::kTitle : TextKind::kLine, lines[i],
         i == 0 && assigns ? element_.signal : kNoSignal);
  }
}

void Symbol::Target() {
  drawing_.symbols += Move(x_, y_) + Horizontal(x_ + kStub);
  const std::string end = std::to_string(right());
  path_ += Move(x_ + kStub, y_ - 10) + Horizontal(right() - 8) + "L" + end + " " + std::to_string(y_) + "L" +
           std::to_string(right() - 8) + " " + std::to_string(y_ + 10) + Horizontal(x_ + kStub) + "Z";
  Text(x_ + kStub + kMargin, y_ + 4, Anchor::kStart, TextKind::kTitle, element_.title);
}

int Symbol::Run() {
  switch (element_.shape) {
    case Shape::kWire:
      drawing_.symbols += Move(x_, y_) + Horizontal(right());
      break;
    case Shape::kNever:
    case Shape::kInvert:
      Bars(TextWidth(element_.shape == Shape::kNever ? "0" : "NOT") / 2 + 4);
      Text(middle(), y_ + 4, Anchor::kMiddle, TextKind::kTitle, element_.shape == Shape::kNever ? "0" : "NOT");
      break;
    case Shape::kContact:
    case Shape::kNotContact:
      Contact();
      break;
    case Shape::kCompare:
      Compare();
      break;
    case Shape::kCoil:
      Coil("");
      break;
    case Shape::kSet:
      Coil("S");
      break;
    case Shape::kReset:
      Coil("R");
      break;
    case Shape::kBox:
      Box();
      break;
    case Shape::kTarget:
      Target();
      break;
    case Shape::kSeries:
    case Shape::kParallel:
      break;  // placed part by part
  }
  if (element_.shape != Shape::kWire) {
    drawing_.elements.push_back({x_, y_ - extent_.up, extent_.width, extent_.up + extent_.down});
  }
  return right();
}

}  // namespace

int TextWidth(std::string_view text) { return static_cast<int>((ColumnsOf(text) * 67 + 9) / 10); }

Extent SymbolExtent(const Element& element) {
  switch (element.shape) {
    case Shape::kWire:
      return {16, 0, 0};
    case Shape::kNever:
    case Shape::kInvert:
      return {kLeast, 10, kBelow};
    case Shape::kBox:
      return BoxExtent(element);
    case Shape::kTarget:
      return {TextWidth(element.title) + kStub + 2 * kMargin + 8, 12, 12};
    case Shape::kContact:
    case Shape::kNotContact:
    case Shape::kCompare:
    case Shape::kCoil:
    case Shape::kSet:
    case Shape::kReset:
    case Shape::kSeries:
    case Shape::kParallel:
      break;
  }
  Extent extent;
  extent.width = std::max(kLeast, TextWidth(element.name) + 2 * kMargin);
  extent.width = std::max(extent.width, TextWidth(element.address) + 2 * kMargin);
  if (!element.lines.empty()) extent.width = std::max(extent.width, TextWidth(element.lines.front()) + 2 * kMargin);
  extent.width += extent.width % 2;
  extent.up = kNameUp;
  extent.down = element.address.empty() && element.lines.empty() ? kBelow : kAddressBelow;
  return extent;
}

int PlaceSymbol(const Element& element, int x, int y, Drawing& drawing) { return Symbol(element, x, y, drawing).Run(); }

}  // namespace plcxx::report
