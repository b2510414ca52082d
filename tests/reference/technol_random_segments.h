// The subprograms of a random program of dialect technol: which labels of earlier ones a later one may jump to.
//
// The whole area is one unit (6.4), and calls lead downwards only, so that there is no ring. A jump back makes what is
// there a part of the subprogram that jumps: nothing of it may call that one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace plcxx::reference::technol_code {

class Segments {
 public:
  struct Labels {
    uint32_t unit = 0, count = 0;
  };

  void Begin() { segments_.push_back({.lowest_label = static_cast<uint32_t>(segments_.size())}); }
  /// Of the last one: what it calls, and when it is made its labels.
  void Calls(uint32_t callee) { segments_.back().lowest_callee = std::min(segments_.back().lowest_callee, callee); }
  void End(Labels labels) { segments_.back().labels = labels; }

  /// Whether the last one may jump to this one, which it does then.
  bool JumpsBackTo(uint32_t target) {
    const auto from = static_cast<uint32_t>(segments_.size() - 1);
    uint32_t lowest = target;
    for (uint32_t at = from; at-- > lowest;) lowest = std::min(lowest, segments_[at].lowest_label);
    for (uint32_t at = lowest; at < from; ++at) {
      if (segments_[at].lowest_callee <= from) return false;
    }
    segments_[from].lowest_label = std::min(segments_[from].lowest_label, lowest);
    return true;
  }
  Labels LabelsOf(uint32_t segment) const { return segments_[segment].labels; }

 private:
  struct Segment {
    uint32_t lowest_callee = std::numeric_limits<uint32_t>::max();
    uint32_t lowest_label = 0;  // of the segments that it jumps to, itself among them
    Labels labels = {};
  };
  std::vector<Segment> segments_;
};

}  // namespace plcxx::reference::technol_code
