// Where everything stands. Each element is measured first (how far it reaches above and below its wire), then drawn.

#include <algorithm>
#include <utility>

#include "transpiler/report/ladder_drawing.h"
#include "transpiler/report/ladder_symbols.h"

namespace plcxx::report {
namespace {

constexpr int kMostWidth = 640;  // of a line of a rung; one element may be wider
constexpr int kLeastWidth = 260;
constexpr int kDepth = 14;   // indentation of a frame
constexpr int kRail = 6;     // of the left rail behind the indentation
constexpr int kJoin = 8;     // from an upright to what stands between two
constexpr int kGap = 4;      // between branches
constexpr int kPadding = 5;  // above and below a rung
constexpr int kArrow = 16;   // a mark that the rung goes on
constexpr int kLabelHeight = 18;
constexpr int kCaptionHeight = 15;

class Layout {
 public:
  Layout(std::span<const LadderItem> items, std::span<const Caption> captions) : items_(items), captions_(captions) {}

  Drawing Run() {
    NewNet({.kind = NetKind::kRail, .from = {}, .value = {}});
    for (const LadderItem& item : items_) width_ = std::max(width_, WidthOf(item));
    for (const Caption& caption : captions_) width_ = std::max(width_, TextWidth(caption.text) + 3 * kRail);
    for (size_t i = 0; i < items_.size(); ++i) {
      Captions(i);
      Item(items_[i]);
    }
    drawing_.width = width_ + kRail;
    drawing_.height = y_;
    return std::move(drawing_);
  }

 private:
  using Parts = std::span<const Element>;

  Extent Measure(const Element& element) const;
  Extent MeasureParallel(Parts parts) const;
  Extent MeasureOutputs(const Rung& rung) const;
  std::vector<Parts> LinesOf(const Rung& rung, int left) const;
  int WidthOf(const LadderItem& item) const;
  int WidthOf(const Rung& rung, int left) const;

  void Item(const LadderItem& item);
  void Captions(size_t item);
  void RungLines(const Rung& rung, int left);
  /// Where a wire ends, and which net it is of.
  struct End {
    int x = 0;
    uint32_t net = 0;
  };
  /// Draws from there to the right at the wire y; gives where it ends.
  End Place(const Element& element, End from, int y);
  End PlaceParallel(Parts parts, End from, int y);
  void PlaceOutputs(const Rung& rung, End from, int y);
  uint32_t NewNet(Net net) {
    drawing_.nets.push_back(std::move(net));
    return static_cast<uint32_t>(drawing_.nets.size() - 1);
  }
  /// What an element makes of the net in front of it.
  uint32_t NetBehind(const Element& element, uint32_t from);
  void Wire(int x1, int y1, int x2, int y2, uint32_t net) {
    if (x1 != x2 || y1 != y2) drawing_.wires.push_back({x1, y1, x2, y2, net});
  }
  void Mark(int x, int y) {
    drawing_.texts.push_back({x, y + 4, Anchor::kStart, TextKind::kTitle, "▸", kNoSignal, false});
  }
  void Bars(uint32_t depth, int top) {
    for (uint32_t d = 0; d < depth; ++d) drawing_.frames.push_back({BarOf(d), top, BarOf(d), y_});
  }
  static int BarOf(uint32_t depth) { return static_cast<int>(depth) * kDepth + 2; }
  static int LeftOf(uint32_t depth) { return static_cast<int>(depth) * kDepth + kRail; }

  std::span<const LadderItem> items_;
  std::span<const Caption> captions_;
  Drawing drawing_;
  int width_ = kLeastWidth;  // where the right rail is
  int y_ = 0;
  size_t next_caption_ = 0;
};

Extent Layout::Measure(const Element& element) const {
  if (element.shape == Shape::kParallel) return MeasureParallel(element.parts);
  if (element.shape != Shape::kSeries) return SymbolExtent(element);
  Extent sum;
  for (const Element& part : element.parts) {
    const Extent extent = Measure(part);
    sum.width += extent.width;
    sum.up = std::max(sum.up, extent.up);
    sum.down = std::max(sum.down, extent.down);
  }
  return sum;
}

Extent Layout::MeasureParallel(Parts parts) const {
  Extent all;
  for (size_t i = 0; i < parts.size(); ++i) {
    const Extent extent = Measure(parts[i]);
    all.width = std::max(all.width, extent.width + 2 * kJoin);
    if (i == 0) {
      all.up = extent.up;
      all.down = extent.down;
    } else {
      all.down += kGap + extent.up + extent.down;
    }
  }
  return all;
}

Extent Layout::MeasureOutputs(const Rung& rung) const {
  if (rung.outputs.empty()) return {};
  Extent all = MeasureParallel(rung.outputs);
  if (rung.outputs.size() == 1) all.width -= kJoin;  // no upright
  return all;
}

/// The parts of a series, line by line, so that each line is as wide as it may be; the outputs follow the last one.
std::vector<Layout::Parts> Layout::LinesOf(const Rung& rung, int left) const {
  Parts parts(&rung.network, 1);
  if (rung.network.shape == Shape::kSeries) parts = rung.network.parts;
  std::vector<Parts> lines;
  size_t begin = 0;
  int x = left;
  for (size_t i = 0; i < parts.size(); ++i) {
    const int width = Measure(parts[i]).width;
    if (i > begin && x + width > kMostWidth) {
      lines.push_back(parts.subspan(begin, i - begin));
      begin = i;
      x = left + kArrow;
    }
    x += width;
  }
  lines.push_back(parts.subspan(begin));
  if (x + MeasureOutputs(rung).width > kMostWidth && x > left + kArrow + kMostWidth / 3) lines.emplace_back();
  return lines;
}

int Layout::WidthOf(const Rung& rung, int left) const {
  const std::vector<Parts> lines = LinesOf(rung, left);
  int widest = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    int x = left + (i == 0 ? 0 : kArrow);
    for (const Element& part : lines[i]) x += Measure(part).width;
    x += i + 1 < lines.size() ? kArrow : MeasureOutputs(rung).width;
    widest = std::max(widest, x);
  }
  return widest + kJoin;
}

int Layout::WidthOf(const LadderItem& item) const {
  const int left = LeftOf(item.depth);
  int width = 0;
  if (!item.label.empty()) width = left + TextWidth(item.label) + kRail;
  const bool rung = item.kind == ItemKind::kRung || !item.rung.outputs.empty();
  return rung ? std::max(width, WidthOf(item.rung, left)) : width;
}

Layout::End Layout::PlaceParallel(Parts parts, End from, int y) {
  const Extent all = MeasureParallel(parts);
  const int x = from.x, right = x + all.width;
  int at = y;
  int below = 0;  // how far the branch before reaches below its wire
  Net joined{.kind = NetKind::kAny, .from = {}, .value = {}};
  std::vector<Line> uprights;  // on the right: of a net that is known when all branches are
  for (size_t i = 0; i < parts.size(); ++i) {
    const Extent extent = Measure(parts[i]);
    if (i > 0) {
      const int next = at + below + kGap + extent.up;
      Wire(x, at, x, next, from.net);
      uprights.push_back({right, at, right, next});
      at = next;
    }
    below = extent.down;
    Wire(x, at, x + kJoin, at, from.net);
    const End end = Place(parts[i], {x + kJoin, from.net}, at);
    Wire(end.x, at, right, at, end.net);
    joined.from.push_back(end.net);
  }
  const uint32_t net = NewNet(std::move(joined));
  for (const Line& line : uprights) Wire(line.x1, line.y1, line.x2, line.y2, net);
  return {right, net};
}

uint32_t Layout::NetBehind(const Element& element, uint32_t from) {
  switch (element.shape) {
    case Shape::kNever:
      return NewNet({.kind = NetKind::kNever, .from = {}, .value = {}});
    case Shape::kInvert:
      return NewNet({.kind = NetKind::kInverted, .from = {from}, .value = {}});
    case Shape::kContact:
    case Shape::kNotContact:
    case Shape::kCompare:
    case Shape::kBox: {
      if (!element.value.valid()) return from;
      const NetKind kind = element.rooted ? NetKind::kOutput : NetKind::kThrough;
      return NewNet({.kind = kind, .from = {from}, .value = element.value, .inverted = element.inverted});
    }
    case Shape::kWire:
    case Shape::kSeries:
    case Shape::kParallel:
    case Shape::kCoil:
    case Shape::kSet:
    case Shape::kReset:
    case Shape::kTarget:
      return from;
  }
  return from;
}

Layout::End Layout::Place(const Element& element, End from, int y) {
  if (element.shape == Shape::kParallel) return PlaceParallel(element.parts, from, y);
  if (element.shape == Shape::kSeries) {
    for (const Element& part : element.parts) from = Place(part, from, y);
    return from;
  }
  DrawnSymbol symbol{.net = NetBehind(element, from.net),
                     .symbols_begin = drawing_.symbols.size(),
                     .local_begin = drawing_.local_symbols.size(),
                     .boxes_begin = drawing_.boxes.size(),
                     .local_boxes_begin = drawing_.local_boxes.size()};
  const End end{PlaceSymbol(element, from.x, y, drawing_), symbol.net};
  symbol.symbols_end = drawing_.symbols.size();
  symbol.local_end = drawing_.local_symbols.size();
  symbol.boxes_end = drawing_.boxes.size();
  symbol.local_boxes_end = drawing_.local_boxes.size();
  drawing_.parts.push_back(symbol);
  return end;
}

/// At the right end, one below the other.
void Layout::PlaceOutputs(const Rung& rung, End from, int y) {
  int at = y;
  int below = 0;
  for (size_t i = 0; i < rung.outputs.size(); ++i) {
    const Extent extent = Measure(rung.outputs[i]);
    if (i > 0) {
      const int next = at + below + kGap + extent.up;
      Wire(from.x, at, from.x, next, from.net);
      at = next;
    }
    below = extent.down;
    const int begin = width_ - kJoin - extent.width;
    Wire(from.x, at, begin, at, from.net);
    const End end = Place(rung.outputs[i], {begin, from.net}, at);
    Wire(end.x, at, width_, at, end.net);
  }
}

void Layout::RungLines(const Rung& rung, int left) {
  const int top = y_;
  const std::vector<Parts> lines = LinesOf(rung, left);
  uint32_t net = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    const bool last = i + 1 == lines.size();
    Extent extent = last ? MeasureOutputs(rung) : Extent{};
    for (const Element& part : lines[i]) {
      const Extent own = Measure(part);
      extent.up = std::max(extent.up, own.up);
      extent.down = std::max(extent.down, own.down);
    }
    const int y = y_ + kPadding + std::max(extent.up, 8);
    int x = left;
    if (i > 0) {
      Mark(x, y);
      x += kArrow;
    }
    End end{x, net};
    for (const Element& part : lines[i]) end = Place(part, end, y);
    net = end.net;
    if (last) {
      PlaceOutputs(rung, end, y);
    } else {
      Mark(end.x + 4, y);
    }
    y_ = y + std::max(extent.down, 8) + kPadding;
  }
  drawing_.rails.push_back({left, top, left, y_});
  drawing_.rails.push_back({width_, top, width_, y_});
}

void Layout::Captions(size_t item) {
  const int left = LeftOf(items_[item].depth);
  const int top = y_;
  for (; next_caption_ < captions_.size() && captions_[next_caption_].item <= item; ++next_caption_) {
    const Caption& caption = captions_[next_caption_];
    y_ += kCaptionHeight;
    drawing_.texts.push_back({left, y_ - 4, Anchor::kStart, caption.kind, caption.text, kNoSignal, false});
  }
  if (y_ > top) Bars(items_[item].depth, top);
}

void Layout::Item(const LadderItem& item) {
  const int left = LeftOf(item.depth);
  const int top = y_;
  switch (item.kind) {
    case ItemKind::kStatement:
      return;
    case ItemKind::kRung:
      RungLines(item.rung, left);
      break;
    case ItemKind::kHead:
    case ItemKind::kSection: {
      if (item.kind == ItemKind::kSection) drawing_.frames.push_back({BarOf(item.depth), y_, width_, y_});
      if (!item.label.empty()) {
        y_ += kLabelHeight;
        drawing_.texts.push_back({left, y_ - 5, Anchor::kStart, TextKind::kLabel, item.label, kNoSignal, false});
      }
      if (!item.rung.outputs.empty()) RungLines(item.rung, left);
      if (item.kind == ItemKind::kHead) drawing_.frames.push_back({BarOf(item.depth), y_, width_, y_});
      break;
    }
    case ItemKind::kEnd:
      y_ += item.label.empty() ? 8 : kLabelHeight;
      if (!item.label.empty()) {
        drawing_.texts.push_back({left, y_ - 5, Anchor::kStart, TextKind::kLabel, item.label, kNoSignal, false});
      }
      drawing_.frames.push_back({BarOf(item.depth), y_, width_, y_});
      y_ += 1;
      break;
  }
  // A section and an end lie inside of their frame.
  const bool inside = item.kind == ItemKind::kSection || item.kind == ItemKind::kEnd;
  Bars(item.depth + (inside ? 1 : 0), top);
}

}  // namespace

Drawing Draw(std::span<const LadderItem> items, std::span<const Caption> captions) {
  return Layout(items, captions).Run();
}

}  // namespace plcxx::report
