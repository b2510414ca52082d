#include "transpiler/link/client.h"

#include <algorithm>
#include <chrono>

namespace plcxx::debug_link {
namespace {

using Clock = std::chrono::steady_clock;

uint32_t Word(const Bytes& bytes, size_t at) {
  uint32_t word = 0;
  for (size_t i = 0; i < 4; ++i) word |= uint32_t{bytes[at + i]} << (8 * i);
  return word;
}

Bytes FrameOf(LinkCommand command, uint8_t number, uint32_t offset, const Bytes& payload) {
  Bytes frame = {kLinkStart, static_cast<uint8_t>(payload.size()), static_cast<uint8_t>(command), number};
  for (int i = 0; i < 4; ++i) frame.push_back(static_cast<uint8_t>(offset >> (8 * i)));
  frame.insert(frame.end(), payload.begin(), payload.end());
  const uint16_t crc = LinkCrc(frame.data() + 1, static_cast<uint32_t>(frame.size() - 1));
  frame.push_back(static_cast<uint8_t>(crc >> 8));
  frame.push_back(static_cast<uint8_t>(crc));
  return frame;
}

std::string TextOf(uint8_t status) {
  switch (static_cast<LinkStatus>(status)) {
    case LinkStatus::kDone:
      return {};
    case LinkStatus::kUnknown:
      return "the machine does not know this request: is its link another version's?";
    case LinkStatus::kReadOnly:
      return "the machine permits reading only";
    case LinkStatus::kOutside:
      return "the machine has no such byte: its program is another one";
    case LinkStatus::kNoRoom:
      return "the machine has no room for more forced bytes: release others first";
  }
  return "the machine answered with the unknown status " + std::to_string(status);
}

}  // namespace

std::optional<Answer> AnswerReader::Next() {
  for (;;) {
    bytes_.erase(bytes_.begin(), std::ranges::find(bytes_, kLinkStart));
    if (bytes_.size() < 2) return std::nullopt;
    const size_t size = size_t{kLinkHead} + bytes_[1] + kLinkCrc;
    if (bytes_[1] <= kLinkPayload) {
      if (bytes_.size() < size) return std::nullopt;
      if (LinkCrc(bytes_.data() + 1, static_cast<uint32_t>(size - 1)) == 0) {
        Answer answer{.status = bytes_[2], .number = bytes_[3], .offset = Word(bytes_, 4), .payload = {}};
        answer.payload.assign(bytes_.begin() + kLinkHead,
                              bytes_.begin() + static_cast<std::ptrdiff_t>(size) - kLinkCrc);
        bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
        return answer;
      }
    }
    bytes_.erase(bytes_.begin());
  }
}

Result<Answer> Client::Ask(LinkCommand command, uint32_t offset, const Bytes& payload, Repeat repeat) {
  const uint8_t number = ++number_;
  const Bytes frame = FrameOf(command, number, offset, payload);
  for (int i = 0; i < (repeat == Repeat::kYes ? kTries : 1); ++i) {
    // What the machine still waits for after a frame that was cut off: no frame is longer.
    if (i != 0 && !transport_.Send(Bytes(kLinkFrame, 0))) return Failure{transport_.WhyGone()};
    if (!transport_.Send(frame)) return Failure{transport_.WhyGone()};
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(answer_ms_);
    while (Clock::now() < end) {
      while (std::optional<Answer> answer = answers_.Next()) {
        if (answer->number != number) continue;  // of a request that was given up
        if (std::string text = TextOf(answer->status); !text.empty()) return Failure{std::move(text)};
        return *std::move(answer);
      }
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      const std::optional<Bytes> bytes = transport_.Receive(std::max(1, static_cast<int>(left)));
      if (!bytes) return Failure{transport_.WhyGone()};
      answers_.Feed(*bytes);
    }
  }
  return Failure{repeat == Repeat::kYes ? "nobody answers" : "no answer: it may be done or not"};
}

Result<Bytes> Client::Read(LinkCommand command, uint32_t offset, uint32_t count) {
  Bytes bytes;
  while (bytes.size() < count) {
    const auto part = static_cast<uint8_t>(std::min<size_t>(kLinkPayload, count - bytes.size()));
    const auto at = offset + static_cast<uint32_t>(bytes.size());
    Result<Answer> answer = Ask(command, at, {part}, Repeat::kYes);
    if (auto* failure = std::get_if<Failure>(&answer)) return std::move(*failure);
    const Bytes& payload = std::get<Answer>(answer).payload;
    if (payload.size() != part) return Failure{"the machine gave another number of bytes than was asked for"};
    bytes.insert(bytes.end(), payload.begin(), payload.end());
  }
  return bytes;
}

std::string Client::Order(LinkCommand command, uint32_t offset, const Bytes& payload, Repeat repeat) {
  Result<Answer> answer = Ask(command, offset, payload, repeat);
  const auto* failure = std::get_if<Failure>(&answer);
  return failure == nullptr ? std::string() : failure->text;
}

Result<Bytes> Client::ReadIdentity() {
  // A frame that somebody else has begun ends here.
  if (!transport_.Send(Bytes(kLinkFrame, 0))) return Failure{transport_.WhyGone()};
  return Read(LinkCommand::kIdentity, 0, kLinkIdentityBytes);
}

Result<LinkLimits> Client::ReadLimits() {
  Result<Bytes> read = Read(LinkCommand::kLimits, 0, sizeof(LinkLimits));
  if (auto* failure = std::get_if<Failure>(&read)) return std::move(*failure);
  const auto& bytes = std::get<Bytes>(read);
  if (bytes[0] != kLinkVersion) {
    return Failure{"the machine's link is of version " + std::to_string(bytes[0]) + ", this plcxx knows version " +
                   std::to_string(kLinkVersion)};
  }
  return LinkLimits{.version = bytes[0],
                    .can_write = bytes[1],
                    .forces = bytes[2],
                    .reserved = bytes[3],
                    .state_bytes = Word(bytes, 4),
                    .ring_bytes = Word(bytes, 8),
                    .period_bytes = Word(bytes, 12)};
}

Result<LinkCounts> Client::ReadCounts() {
  Result<Bytes> read = Read(LinkCommand::kCounts, 0, sizeof(LinkCounts));
  if (auto* failure = std::get_if<Failure>(&read)) return std::move(*failure);
  const auto& bytes = std::get<Bytes>(read);
  return LinkCounts{.may_write = bytes[0],
                    .forced = bytes[1],
                    .reserved = 0,
                    .scans = Word(bytes, 4),
                    .lost = Word(bytes, 8),
                    .sample_bytes = Word(bytes, 12),
                    .begin = Word(bytes, 16),
                    .end = Word(bytes, 20)};
}

Result<Bytes> Client::ReadState(uint32_t offset, uint32_t count) { return Read(LinkCommand::kRead, offset, count); }

std::string Client::Write(uint32_t offset, const Bytes& masks, const Bytes& values) {
  Bytes payload = masks;
  payload.insert(payload.end(), values.begin(), values.end());
  return Order(LinkCommand::kWrite, offset, payload, Repeat::kNo);
}

std::string Client::Force(uint32_t offset, const Bytes& masks, const Bytes& values) {
  Bytes payload = masks;
  payload.insert(payload.end(), values.begin(), values.end());
  return Order(LinkCommand::kForce, offset, payload, Repeat::kYes);
}

std::string Client::ReleaseAll() { return Order(LinkCommand::kForce, 0, {}, Repeat::kYes); }

std::string Client::Watch(uint8_t number, uint32_t offset, uint8_t bytes) {
  return Order(LinkCommand::kWatch, offset, {number, bytes}, Repeat::kYes);
}

Result<Answer> Client::ReadTrace(uint32_t position, uint8_t most) {
  return Ask(LinkCommand::kTrace, position, {most}, Repeat::kYes);
}

}  // namespace plcxx::debug_link
