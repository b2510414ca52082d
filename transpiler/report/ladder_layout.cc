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
  /// Draws from x to the right at the wire y; gives where it ends.
  int Place(const Element& element, int x, int y);
  int PlaceParallel(Parts parts, int x, int y);
  void PlaceOutputs(const Rung& rung, int x, int y);
  void Wire(int x1, int y1, int x2, int y2) {
    if (x1 != x2 || y1 != y2) drawing_.wires.push_back({x1, y1, x2, y2});
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

int Layout::PlaceParallel(Parts parts, int x, int y) {
  const Extent all = MeasureParallel(parts);
  const int right = x + all.width;
  int at = y;
  int below = 0;  // how far the branch before reaches below its wire
  for (size_t i = 0; i < parts.size(); ++i) {
    const Extent extent = Measure(parts[i]);
    if (i > 0) {
      const int next = at + below + kGap + extent.up;
      Wire(x, at, x, next);
      Wire(right, at, right, next);
      at = next;
    }
    below = extent.down;
    Wire(x, at, x + kJoin, at);
    const int end = Place(parts[i], x + kJoin, at);
    Wire(end, at, right, at);
  }
  return right;
}

int Layout::Place(const Element& element, int x, int y) {
  if (element.shape == Shape::kParallel) return PlaceParallel(element.parts, x, y);
  if (element.shape != Shape::kSeries) return PlaceSymbol(element, x, y, drawing_);
  for (const Element& part : element.parts) x = Place(part, x, y);
  return x;
}

/// At the right end, one below the other.
void Layout::PlaceOutputs(const Rung& rung, int x, int y) {
  int at = y;
  int below = 0;
  for (size_t i = 0; i < rung.outputs.size(); ++i) {
    const Extent extent = Measure(rung.outputs[i]);
    if (i > 0) {
      const int next = at + below + kGap + extent.up;
      Wire(x, at, x, next);
      at = next;
    }
    below = extent.down;
    const int begin = width_ - kJoin - extent.width;
    Wire(x, at, begin, at);
    Wire(Place(rung.outputs[i], begin, at), at, width_, at);
  }
}

void Layout::RungLines(const Rung& rung, int left) {
  const int top = y_;
  const std::vector<Parts> lines = LinesOf(rung, left);
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
    for (const Element& part : lines[i]) x = Place(part, x, y);
    if (last) {
      PlaceOutputs(rung, x, y);
    } else {
      Mark(x + 4, y);
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
