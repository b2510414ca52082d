#include "transpiler/link/target.h"

namespace plcxx::debug_link {
namespace {

constexpr uint32_t kMostChanged = kLinkPayload / 2;  // masks and values share a frame
constexpr size_t kScanBytes = 4;

std::vector<Cell> AllOf(const std::vector<std::vector<Cell>>& watched) {
  std::vector<Cell> all;
  for (const std::vector<Cell>& cells : watched) all.insert(all.end(), cells.begin(), cells.end());
  return all;
}

}  // namespace

std::string Target::Begin(Length length) {
  Result<LinkLimits> limits = client_.ReadLimits();
  if (const auto* failure = std::get_if<Failure>(&limits)) return failure->text;
  limits_ = std::get<LinkLimits>(limits);
  const bool fits = length == Length::kExact ? limits_.state_bytes == layout_.size : limits_.state_bytes > layout_.size;
  if (fits) return {};
  return "its State has " + std::to_string(limits_.state_bytes) + " bytes, here it has " + std::to_string(layout_.size);
}

Result<uint64_t> Target::Read(const std::vector<Cell>& cells) {
  KnownBytes known;
  for (const Run& run : RunsOf(cells, kLinkPayload)) {
    Result<Bytes> read = client_.ReadState(run.offset, run.bytes);
    if (auto* failure = std::get_if<Failure>(&read)) return std::move(*failure);
    const auto& bytes = std::get<Bytes>(read);
    for (uint32_t i = 0; i < run.bytes; ++i) known[run.offset + i] = bytes[i];
  }
  return ValueOf(cells, known);
}

std::string Target::Change(Order order, const std::vector<Cell>& cells, uint64_t value) {
  for (const MaskedRun& write : WritesOf(cells, value, kMostChanged)) {
    std::string failure = order == Order::kWrite ? client_.Write(write.offset, write.masks, write.values)
                                                 : client_.Force(write.offset, write.masks, write.values);
    if (!failure.empty()) return failure;
  }
  return {};
}

std::string Target::Write(const std::vector<Cell>& cells, uint64_t value) {
  return Change(Order::kWrite, cells, value);
}

std::string Target::Force(const std::vector<Cell>& cells, uint64_t value) {
  return Change(Order::kForce, cells, value);
}

std::string Target::Release(const std::vector<Cell>& cells) {
  for (const Run& run : RunsOf(cells, kMostChanged)) {
    if (std::string failure = client_.Force(run.offset, Bytes(run.bytes), Bytes(run.bytes)); !failure.empty()) {
      return failure;
    }
  }
  return {};
}

std::string Target::Watch(const std::vector<std::vector<Cell>>& watched) {
  runs_ = RunsOf(AllOf(watched), kLinkWatchedBytes);
  pending_.clear();
  if (runs_.size() > kLinkWatched) {
    return "these locations are in " + std::to_string(runs_.size()) + " places, a sample has " +
           std::to_string(kLinkWatched);
  }
  size_t sample = kScanBytes;
  for (const Run& run : runs_) sample += run.bytes;
  if (sample > limits_.ring_bytes) {
    return "a sample of " + std::to_string(sample) + " bytes does not fit into the machine's ring of " +
           std::to_string(limits_.ring_bytes);
  }
  for (uint8_t i = 0; i < kLinkWatched; ++i) {
    const bool is_used = i < runs_.size();
    std::string failure =
        client_.Watch(i, is_used ? runs_[i].offset : 0, is_used ? static_cast<uint8_t>(runs_[i].bytes) : uint8_t{0});
    if (!failure.empty()) return failure;
  }
  Result<LinkCounts> counts = client_.ReadCounts();
  if (const auto* failure = std::get_if<Failure>(&counts)) return failure->text;
  position_ = std::get<LinkCounts>(counts).begin;
  return {};
}

Result<std::vector<TraceSample>> Target::TakeSamples() {
  Result<Answer> read = client_.ReadTrace(position_, kLinkPayload);
  if (auto* failure = std::get_if<Failure>(&read)) return std::move(*failure);
  const Answer& answer = std::get<Answer>(read);
  if (answer.offset != position_) return Failure{"somebody else is tracing the machine, or it was started anew"};
  position_ += static_cast<uint32_t>(answer.payload.size());
  pending_.insert(pending_.end(), answer.payload.begin(), answer.payload.end());
  size_t size = kScanBytes;
  for (const Run& run : runs_) size += run.bytes;
  std::vector<TraceSample> samples;
  size_t at = 0;
  for (; at + size <= pending_.size(); at += size) {
    TraceSample sample;
    for (size_t i = 0; i < kScanBytes; ++i) sample.scan |= uint32_t{pending_[at + i]} << (8 * i);
    size_t next = at + kScanBytes;
    for (const Run& run : runs_) {
      for (uint32_t i = 0; i < run.bytes; ++i) sample.bytes[run.offset + i] = pending_[next++];
    }
    samples.push_back(std::move(sample));
  }
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(at));
  return samples;
}

}  // namespace plcxx::debug_link
