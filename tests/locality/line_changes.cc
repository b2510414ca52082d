#include "tests/locality/line_changes.h"

#include <algorithm>
#include <map>

namespace plcxx::locality {
namespace {

using Lines = std::vector<std::string_view>;

Lines LinesOf(std::string_view text) {
  Lines lines;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// The furthest position of `before` on each diagonal k = (position before) - (position after), from -d to d.
class Frontier {
 public:
  explicit Frontier(int most) : most_(most), furthest_(2 * static_cast<size_t>(most) + 1, -1) {}
  int& operator[](int k) { return furthest_[IndexOf(k)]; }
  int operator[](int k) const { return furthest_[IndexOf(k)]; }

 private:
  size_t IndexOf(int k) const { return static_cast<size_t>(k) + static_cast<size_t>(most_); }

  int most_;
  std::vector<int> furthest_;
};

/// Whether step d reaches diagonal k by an added line, that is from diagonal k + 1.
bool ComesByAddition(const Frontier& previous, int k, int d) {
  return k == -d || (k != d && previous[k - 1] < previous[k + 1]);
}

/// The frontiers of each number of differences until both ends are reached.
std::vector<Frontier> Search(const Lines& before, const Lines& after) {
  const int n = static_cast<int>(before.size()), m = static_cast<int>(after.size());
  std::vector<Frontier> steps;
  for (int d = 0;; ++d) {
    Frontier frontier(d + 1);
    for (int k = -d; k <= d; k += 2) {
      int x = 0;
      if (d > 0) x = ComesByAddition(steps.back(), k, d) ? steps.back()[k + 1] : steps.back()[k - 1] + 1;
      while (x < n && x - k < m && before[static_cast<size_t>(x)] == after[static_cast<size_t>(x - k)]) ++x;
      frontier[k] = x;
      if (x >= n && x - k >= m) {
        steps.push_back(std::move(frontier));
        return steps;
      }
    }
    steps.push_back(std::move(frontier));
  }
}

/// Back from the end: one line a step; equal lines between two steps end a stretch.
LineChanges Count(const Lines& before, const Lines& after) {
  const std::vector<Frontier> steps = Search(before, after);
  LineChanges all;
  size_t removed = 0, added = 0;  // of the stretch
  int k = static_cast<int>(before.size()) - static_cast<int>(after.size());
  int x = static_cast<int>(before.size());
  const auto end_stretch = [&] {
    all.changed += std::max(removed, added);
    removed = added = 0;
  };
  for (int d = static_cast<int>(steps.size()) - 1; d > 0; --d) {
    const Frontier& previous = steps[static_cast<size_t>(d) - 1];
    const bool addition = ComesByAddition(previous, k, d);
    const int from = addition ? previous[k + 1] : previous[k - 1];
    if (x > (addition ? from : from + 1)) end_stretch();
    ++(addition ? added : removed);
    ++(addition ? all.added : all.removed);
    k += addition ? 1 : -1;
    x = from;
  }
  end_stretch();
  return all;
}

}  // namespace

LineChanges CompareLines(std::string_view before, std::string_view after) {
  return Count(LinesOf(before), LinesOf(after));
}

LineChanges CompareFiles(const std::vector<emit::OutputFile>& before, const std::vector<emit::OutputFile>& after) {
  std::map<std::string_view, std::pair<std::string_view, std::string_view>> texts;
  for (const emit::OutputFile& file : before) texts[file.name].first = file.text;
  for (const emit::OutputFile& file : after) texts[file.name].second = file.text;
  LineChanges all;
  for (const auto& [name, pair] : texts) {
    const LineChanges own = CompareLines(pair.first, pair.second);
    all.removed += own.removed;
    all.added += own.added;
    all.changed += own.changed;
  }
  return all;
}

Distribution DistributionOf(std::vector<size_t> changed) {
  std::ranges::sort(changed);
  const auto at = [&changed](size_t percent) { return changed[(changed.size() * percent - 1) / 100]; };
  return {.median = at(50), .percentile99 = at(99), .most = changed.back()};
}

bool IsLocal(const Distribution& distribution) {
  constexpr size_t kMedian = 3;
  constexpr size_t kPercentile99 = 20;
  return distribution.median <= kMedian && distribution.percentile99 <= kPercentile99;
}

}  // namespace plcxx::locality
