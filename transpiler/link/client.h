// The host's side of the link to a running machine: requests, their answers, and what is asked for again.
//
// In: a wire to something that may be a machine. Out: bytes of State, samples, or why there are none. Whatever comes
// over the wire, an answer is one of this request with a right CRC, or none. What changes nothing is asked for again
// when no answer comes; a write never is, for it may have been done. Not its job: which program it is (the caller
// compares the identity before anything else), which place is where (cells.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "plcxx/debug_link.h"
#include "transpiler/link/transport.h"

namespace plcxx::debug_link {

struct Answer {
  uint8_t status = 0;  // LinkStatus
  uint8_t number = 0;
  uint32_t offset = 0;
  Bytes payload;
};

/// Cuts answers out of what arrives.
class AnswerReader {
 public:
  void Feed(std::span<const uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// The next one; what is none is skipped.
  std::optional<Answer> Next();

 private:
  Bytes bytes_;
};

/// Why there is nothing; lower case, no full stop.
struct Failure {
  std::string text;
};
template <class T>
using Result = std::variant<T, Failure>;

inline constexpr int kAnswerMs = 1000;  // for one answer
inline constexpr int kTries = 3;

class Client {
 public:
  explicit Client(Transport& transport, int answer_ms = kAnswerMs) : transport_(transport), answer_ms_(answer_ms) {}

  /// The first thing to ask: 64 bytes of transpiler/identity.
  Result<Bytes> ReadIdentity();
  Result<LinkLimits> ReadLimits();
  Result<LinkCounts> ReadCounts();
  Result<Bytes> ReadState(uint32_t offset, uint32_t count);
  /// Empty: done. `masks` and `values` have a byte for each byte of State from `offset` on, at most 32.
  std::string Write(uint32_t offset, const Bytes& masks, const Bytes& values);
  /// A mask of 0 lets a byte go.
  std::string Force(uint32_t offset, const Bytes& masks, const Bytes& values);
  std::string ReleaseAll();
  std::string Watch(uint8_t number, uint32_t offset, uint8_t bytes);
  /// What the ring has from `position` on.
  Result<Answer> ReadTrace(uint32_t position, uint8_t most);

 private:
  enum class Repeat : uint8_t { kYes, kNo };
  Result<Answer> Ask(LinkCommand command, uint32_t offset, const Bytes& payload, Repeat repeat);
  Result<Bytes> Read(LinkCommand command, uint32_t offset, uint32_t count);
  std::string Order(LinkCommand command, uint32_t offset, const Bytes& payload, Repeat repeat);

  Transport& transport_;
  AnswerReader answers_;
  int answer_ms_;
  uint8_t number_ = 0;
};

}  // namespace plcxx::debug_link
