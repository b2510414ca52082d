#include "transpiler/checks/preemption.h"

#include <algorithm>
#include <string>
#include <utility>

#include "transpiler/checks/accesses.h"
#include "transpiler/checks/part_uses.h"

namespace plcxx::checks {
namespace {

constexpr const char* kFastWrites = "the fast part writes it here";
constexpr const char* kFastReads = "the fast part reads it here";

/// What the fast part does with one bit of the program's memory, or one field: an index of PlaceId or StateId each.
struct Touched {
  uint32_t reader = support::Id<void>::kNone, writer = support::Id<void>::kNone;
  source::Range read, written;
  bool is_read() const { return reader != support::Id<void>::kNone; }
  bool is_written() const { return writer != support::Id<void>::kNone; }
};

class Check {
 public:
  Check(const ir::Program& program, const std::vector<StoredPlace>& stored, diag::Engine& diagnostics)
      : program_(program),
        stored_(stored),
        diagnostics_(diagnostics),
        numbering_(program),
        fast_(CollectUses(program, {ir::RoutineKind::kFast, ir::RoutineKind::kInterrupt})),
        slow_(CollectUses(program, {ir::RoutineKind::kSlow})),
        touched_(numbering_.count()),
        slow_reads_(numbering_.count()),
        slow_writes_(numbering_.count()),
        shared_(program.places.size()) {}

  std::vector<bool> Run() {
    if (fast_.empty() || slow_.empty()) return std::move(shared_);
    for (const PartUses* const part : {&fast_, &slow_}) {
      for (const auto& [host, range] : part->state_calls) {
        diagnostics_.Report(range, diag::PreemptWholeState, program_.host_functions[ir::HostFunctionId(host)].name);
      }
    }
    MarkFast();
    for (const auto& [place, use] : slow_.places) CountSlow(ir::PlaceId(place), use);
    for (const auto& [state, times] : slow_.runs) SlowRuns(ir::StateId(state), times);
    for (const auto& [place, use] : slow_.places) {
      if (use.writes.count > 0) SlowWrites(ir::PlaceId(place), use.writes);
      if (use.reads.count > 0) SlowReads(ir::PlaceId(place), use.reads);
    }
    return std::move(shared_);
  }

 private:
  void MarkFast() {
    for (const auto& [place, use] : fast_.places) {
      const BitSpan span = numbering_.Of(program_.places[ir::PlaceId(place)]);
      for (uint32_t bit = span.first; bit < span.last; ++bit) {
        Touched& touched = touched_[bit];
        if (use.reads.count > 0 && !touched.is_read()) {
          touched.reader = place;
          touched.read = use.reads.first;
        }
        if (use.writes.count > 0 && !touched.is_written()) {
          touched.writer = place;
          touched.written = use.writes.first;
        }
      }
      if (use.writes.count == 0) continue;
      const StoredPlace& stored = stored_[place];
      if (fast_bytes_.size() < stored.offset + stored.bytes)
        fast_bytes_.resize(stored.offset + stored.bytes, support::Id<void>::kNone);
      for (uint32_t i = 0; i < stored.bytes; ++i) fast_bytes_[stored.offset + i] = place;
    }
  }

  void CountSlow(ir::PlaceId place, const Use& use) {
    const BitSpan span = numbering_.Of(program_.places[place]);
    const auto add = [](uint8_t& sum, uint8_t count) { sum = static_cast<uint8_t>(std::min(sum + count, 2)); };
    for (uint32_t bit = span.first; bit < span.last; ++bit) {
      add(slow_reads_[bit], use.reads.count);
      add(slow_writes_[bit], use.writes.count);
    }
  }

  /// An instance that the slow part runs: the fast part must not run it, too, nor use a field.
  void SlowRuns(ir::StateId state, const Times& times) {
    source::Range other;
    if (const auto run = fast_.runs.find(state.index); run != fast_.runs.end()) {
      other = run->second.first;
    } else {
      const auto found = std::ranges::find_if(
          fast_.places, [&](const auto& entry) { return program_.places[ir::PlaceId(entry.first)].state == state; });
      if (found == fast_.places.end()) return;
      const Use& use = found->second;
      other = use.reads.count > 0 ? use.reads.first : use.writes.first;
    }
    Refuse(diagnostics_.Report(times.first, diag::PreemptInstance, program_.states[state].name), other,
           "the fast part uses it here");
  }

  void SlowWrites(ir::PlaceId id, const Times& writes) {
    const ir::Place& place = program_.places[id];
    if (const auto run = fast_.runs.find(place.state.index); place.is_field() && run != fast_.runs.end()) {
      Refuse(diagnostics_.Report(writes.first, diag::PreemptBothWrite, place.name), run->second.first,
             "the fast part runs it here");
      return;
    }
    const BitSpan span = numbering_.Of(place);
    const auto first = touched_.begin() + span.first, last = touched_.begin() + span.last;
    if (const auto both = std::find_if(first, last, [](const Touched& bit) { return bit.is_written(); });
        both != last) {
      Refuse(diagnostics_.Report(writes.first, diag::PreemptBothWrite, place.name), both->written, kFastWrites);
      return;
    }
    const StoredPlace& stored = stored_[id.index];
    for (uint32_t at = stored.offset; at < stored.offset + stored.bytes && at < fast_bytes_.size(); ++at) {
      if (fast_bytes_[at] == support::Id<void>::kNone) continue;
      const ir::PlaceId other(fast_bytes_[at]);
      Refuse(diagnostics_.Report(writes.first, diag::PreemptSharedByte, place.name, program_.places[other].name),
             fast_.places.at(other.index).writes.first, "the fast part writes the other one here");
      return;
    }
    const auto reader = std::find_if(first, last, [](const Touched& bit) { return bit.is_read(); });
    if (reader == last) return;
    shared_[id.index] = true;
    if (stored.pieces > 1) {
      Refuse(diagnostics_.Report(writes.first, diag::PreemptPieces, place.name, stored.pieces), reader->read,
             kFastReads);
    } else if (const auto bit = static_cast<size_t>(reader - touched_.begin()); slow_writes_[bit] > 1) {
      Refuse(
          diagnostics_.Report(writes.count > 1 ? writes.second : writes.first, diag::PreemptWrittenAgain, place.name),
          reader->read, kFastReads);
    }
  }

  void SlowReads(ir::PlaceId id, const Times& reads) {
    const ir::Place& place = program_.places[id];
    const StoredPlace& stored = stored_[id.index];
    const BitSpan span = numbering_.Of(place);
    const auto first = touched_.begin() + span.first, last = touched_.begin() + span.last;
    const auto writer = std::find_if(first, last, [](const Touched& bit) { return bit.is_written(); });
    const auto run = place.is_field() ? fast_.runs.find(place.state.index) : fast_.runs.end();
    if (writer == last && run == fast_.runs.end()) return;
    shared_[id.index] = true;
    const source::Range other = writer != last ? writer->written : run->second.first;
    const char* const says = writer != last ? kFastWrites : "the fast part runs it here";
    const bool again = std::any_of(slow_reads_.begin() + span.first, slow_reads_.begin() + span.last,
                                   [](uint8_t count) { return count > 1; });
    if (stored.pieces > 1) {
      Refuse(diagnostics_.Report(reads.first, diag::PreemptPieces, place.name, stored.pieces), other, says);
    } else if (again) {
      Refuse(diagnostics_.Report(reads.count > 1 ? reads.second : reads.first, diag::PreemptReadAgain, place.name),
             other, says);
    }
  }

  static void Refuse(diag::Diagnostic& diagnostic, source::Range other, const char* says) {
    diagnostic.notes.push_back({other, says});
  }

  const ir::Program& program_;
  const std::vector<StoredPlace>& stored_;
  diag::Engine& diagnostics_;
  BitNumbering numbering_;
  PartUses fast_, slow_;
  std::vector<Touched> touched_;                   // by number of the bit
  std::vector<uint8_t> slow_reads_, slow_writes_;  // likewise: 0, 1, or 2 for more
  std::vector<uint32_t> fast_bytes_;               // by byte of State: a place that the fast part writes there
  std::vector<bool> shared_;                       // by PlaceId
};

}  // namespace

std::vector<bool> CheckPreemption(const ir::Program& program, const std::vector<StoredPlace>& stored,
                                  diag::Engine& diagnostics) {
  return Check(program, stored, diagnostics).Run();
}

}  // namespace plcxx::checks
