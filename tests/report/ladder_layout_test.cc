// Geometry of the ladder pictures, also of random networks: nothing overlaps, no wire crosses another one or a symbol.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "transpiler/report/ladder_drawing.h"

namespace plcxx::report {
namespace {

Element Symbol(Shape shape, std::string name) {
  Element element;
  element.shape = shape;
  element.name = std::move(name);
  return element;
}

Element Join(Shape shape, std::vector<Element> parts) {
  Element element;
  element.shape = shape;
  element.parts = std::move(parts);
  return element;
}

std::vector<LadderItem> OneRung(Element network, std::vector<Element> outputs) {
  LadderItem item;
  item.kind = ItemKind::kRung;
  item.rung = {std::move(network), std::move(outputs)};
  return {item};
}

bool Overlap(const Rectangle& a, const Rectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// Does the line run through the inside of the rectangle? Along its edge, or up to it, is allowed.
bool Cuts(const Line& line, const Rectangle& box) {
  const int left = std::min(line.x1, line.x2), right = std::max(line.x1, line.x2);
  const int top = std::min(line.y1, line.y2), bottom = std::max(line.y1, line.y2);
  if (top == bottom) return top > box.y && top < box.y + box.height && left < box.x + box.width && right > box.x;
  return left > box.x && left < box.x + box.width && top < box.y + box.height && bottom > box.y;
}

/// Do they cross where neither of them ends?
bool Cross(const Line& a, const Line& b) {
  const bool horizontal = a.y1 == a.y2;
  if (horizontal == (b.y1 == b.y2)) return false;
  const Line& h = horizontal ? a : b;
  const Line& v = horizontal ? b : a;
  const int left = std::min(h.x1, h.x2), right = std::max(h.x1, h.x2);
  const int top = std::min(v.y1, v.y2), bottom = std::max(v.y1, v.y2);
  return v.x1 > left && v.x1 < right && h.y1 > top && h.y1 < bottom;
}

/// What is wrong with a drawing; empty: nothing.
std::string FaultOf(const Drawing& drawing) {
  for (size_t i = 0; i < drawing.elements.size(); ++i) {
    const Rectangle& box = drawing.elements[i];
    if (box.x < 0 || box.y < 0 || box.x + box.width > drawing.width || box.y + box.height > drawing.height) {
      return "element " + std::to_string(i) + " stands outside";
    }
    for (size_t k = i + 1; k < drawing.elements.size(); ++k) {
      if (Overlap(box, drawing.elements[k])) return "elements " + std::to_string(i) + " and " + std::to_string(k);
    }
    for (const Line& wire : drawing.wires) {
      if (Cuts(wire, box)) return "a wire runs through element " + std::to_string(i);
    }
  }
  for (size_t i = 0; i < drawing.wires.size(); ++i) {
    const Line& wire = drawing.wires[i];
    if (wire.x1 != wire.x2 && wire.y1 != wire.y2) return "a wire is neither level nor upright";
    for (size_t k = i + 1; k < drawing.wires.size(); ++k) {
      if (Cross(wire, drawing.wires[k])) return "wires " + std::to_string(i) + " and " + std::to_string(k) + " cross";
    }
  }
  return "";
}

TEST(LadderLayout, SeriesStandOnOneWire) {
  const Drawing drawing =
      Draw(OneRung(Join(Shape::kSeries, {Symbol(Shape::kContact, "a"), Symbol(Shape::kNotContact, "b")}),
                   {Symbol(Shape::kCoil, "x")}));
  EXPECT_EQ(FaultOf(drawing), "");
  ASSERT_EQ(drawing.elements.size(), 3u);
  EXPECT_EQ(drawing.elements[0].y, drawing.elements[1].y);
  EXPECT_EQ(drawing.elements[0].x + drawing.elements[0].width, drawing.elements[1].x);
  EXPECT_EQ(drawing.elements[1].y, drawing.elements[2].y);
}

TEST(LadderLayout, BranchesStandBelowEachOther) {
  const Drawing drawing =
      Draw(OneRung(Join(Shape::kParallel,
                        {Symbol(Shape::kContact, "a"), Symbol(Shape::kContact, "b"), Symbol(Shape::kContact, "c")}),
                   {Symbol(Shape::kCoil, "x"), Symbol(Shape::kSet, "y")}));
  EXPECT_EQ(FaultOf(drawing), "");
  EXPECT_EQ(drawing.elements[0].x, drawing.elements[1].x);
  EXPECT_LT(drawing.elements[0].y + drawing.elements[0].height, drawing.elements[1].y + 1);
  EXPECT_LT(drawing.elements[1].y, drawing.elements[2].y);
}

TEST(LadderLayout, WideSeriesGoOnBelow) {
  std::vector<Element> parts;
  for (int i = 0; i < 40; ++i) parts.push_back(Symbol(Shape::kContact, "SIGNAL_" + std::to_string(i)));
  const Drawing drawing = Draw(OneRung(Join(Shape::kSeries, std::move(parts)), {Symbol(Shape::kCoil, "x")}));
  EXPECT_EQ(FaultOf(drawing), "");
  EXPECT_EQ(drawing.elements.size(), 41u);
  EXPECT_LE(drawing.width, 720);
}

TEST(LadderLayout, TextsFitIntoTheirBoxes) {
  Element box = Symbol(Shape::kBox, "T5");
  box.title = "OnDelay";
  box.lines = {"a very long operand that has to be broken somewhere",
               "报警灯报警灯报警灯报警灯报警灯报警灯报警灯报警灯", ""};
  const Drawing drawing = Draw(OneRung(Symbol(Shape::kContact, "a"), {box}));
  EXPECT_EQ(FaultOf(drawing), "");
  ASSERT_EQ(drawing.boxes.size(), 1u);
  for (const DrawnText& text : drawing.texts) {
    if (text.kind != TextKind::kLine && text.kind != TextKind::kTitle) continue;
    EXPECT_LE(text.x + TextWidth(text.text), drawing.boxes[0].x + drawing.boxes[0].width) << text.text;
    EXPECT_LE(text.y, drawing.boxes[0].y + drawing.boxes[0].height) << text.text;
  }
}

TEST(LadderLayout, LettersOfEastAsiaAreTwiceAsWide) {
  EXPECT_EQ(TextWidth("红灯"), TextWidth("abcd"));
  EXPECT_EQ(TextWidth("насос"), TextWidth("pumps"));
}

class RandomNetwork {
 public:
  explicit RandomNetwork(uint32_t seed) : random_(seed + 1) {}

  Element Network(int depth) {
    const auto choice = random_() % (depth > 0 ? 10 : 6);
    if (choice >= 6) {
      std::vector<Element> parts;
      const auto count = 2 + random_() % 4;
      for (size_t i = 0; i < count; ++i) parts.push_back(Network(depth - 1));
      return Join(choice >= 8 ? Shape::kParallel : Shape::kSeries, std::move(parts));
    }
    constexpr Shape kShapes[] = {Shape::kContact, Shape::kNotContact, Shape::kCompare,
                                 Shape::kBox,     Shape::kNever,      Shape::kInvert};
    Element element = Symbol(kShapes[choice], Name());
    if (element.shape == Shape::kCompare || element.shape == Shape::kBox) element.lines = {Name()};
    if (element.shape == Shape::kBox) element.lines.push_back(Name());
    element.title = element.shape == Shape::kCompare ? "≤" : "OnDelay";
    if (random_() % 3 == 0) element.address = Name();
    return element;
  }
  std::vector<Element> Outputs() {
    std::vector<Element> outputs;
    constexpr Shape kShapes[] = {Shape::kCoil, Shape::kSet, Shape::kReset, Shape::kBox, Shape::kTarget};
    for (size_t i = 0; i <= random_() % 4; ++i) {
      outputs.push_back(Symbol(kShapes[random_() % 5], Name()));
      outputs.back().title = Name();
    }
    return outputs;
  }

 private:
  std::string Name() { return std::string(1 + random_() % 18, 'M'); }
  std::minstd_rand random_;
};

TEST(LadderLayout, RandomNetworksNeitherOverlapNorCross) {
  for (uint32_t seed = 0; seed < 600; ++seed) {
    RandomNetwork random(seed);
    Element network = random.Network(static_cast<int>(seed % 6));
    std::vector<LadderItem> items = OneRung(std::move(network), random.Outputs());
    items.push_back(OneRung(random.Network(2), random.Outputs()).front());
    items.back().depth = seed % 3;
    ASSERT_EQ(FaultOf(Draw(items)), "") << "seed " << seed;
  }
}

// The checks above find what they are for.
TEST(LadderLayout, FaultsAreFound) {
  Drawing drawing;
  drawing.width = drawing.height = 100;
  drawing.elements = {{0, 0, 20, 20}, {10, 10, 20, 20}};
  EXPECT_EQ(FaultOf(drawing), "elements 0 and 1");
  drawing.elements = {{0, 0, 20, 20}};
  drawing.wires = {{0, 10, 40, 10}};
  EXPECT_EQ(FaultOf(drawing), "a wire runs through element 0");
  drawing.elements.clear();
  drawing.wires = {{0, 10, 40, 10}, {20, 0, 20, 40}};
  EXPECT_EQ(FaultOf(drawing), "wires 0 and 1 cross");
}

TEST(LadderSvg, IsWellFormedAndEscaped) {
  const Drawing drawing = Draw(OneRung(Symbol(Shape::kContact, "a<b>&\"c\""), {Symbol(Shape::kCoil, "</svg>")}));
  std::string svg;
  AppendSvgElement(drawing, "ladder of <x>", svg);
  EXPECT_THAT(svg, testing::StartsWith("<svg class=\"ladder\" role=\"img\" aria-label=\"ladder of &lt;x&gt;\""));
  EXPECT_THAT(svg, testing::HasSubstr("a&lt;b&gt;&amp;&quot;c&quot;"));
  EXPECT_EQ(svg.find("</svg>"), svg.size() - 6);
  EXPECT_THAT(SvgFile(drawing, "x"), testing::HasSubstr("prefers-color-scheme"));
}

}  // namespace
}  // namespace plcxx::report
