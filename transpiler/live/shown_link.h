// What is known of a running machine that is shown instead of a simulated one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/live/chart.h"
#include "transpiler/live/notes.h"
#include "transpiler/live/timeline.h"

namespace plcxx::live {

struct LinkStatus {
  std::string address;
  bool is_connected = false;
  std::string reason;      // why it is not; lower case, no full stop
  bool can_write = false;  // there is code that writes; now it may only with
  bool may_write = false;
  uint32_t forced_bytes = 0;  // whoever has forced them
  uint32_t scans = 0;
  uint64_t lost = 0;      // samples of what is watched now, for which the wire was too slow
  uint64_t round_ms = 0;  // in which all of State was read last
};

/// What the machine says, in the places where a page looks for what a simulated one does.
class ShownLink {
 public:
  /// All outlive it.
  ShownLink(const ir::Program& program, Timeline& timeline, Chart& chart, Notes& notes)
      : program_(program), timeline_(timeline), chart_(chart), notes_(notes) {}

  /// From the first status on nothing runs here, and time is the machine's.
  void Show(LinkStatus status) { status_ = std::move(status); }
  const std::optional<LinkStatus>& status() const { return status_; }
  /// One for each watched location, after the scan of this number.
  void TakeSample(uint32_t scan, const std::vector<uint64_t>& values);
  /// Those that were reported before, without a break, are not news.
  void TakeFaults(const std::vector<sim::HostEvent>& faults);
  void AddNote(std::string text);

 private:
  const ir::Program& program_;
  Timeline& timeline_;
  Chart& chart_;
  Notes& notes_;
  std::optional<LinkStatus> status_;
  std::vector<std::string> faults_;  // of the scan that was computed again last
};

}  // namespace plcxx::live
