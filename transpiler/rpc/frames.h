// Messages on a stream of bytes: cut out of what arrives, and framed for what is sent.
//
// In: bytes as they come, in any pieces. Out: one text a message, or the words for a frame that cannot be read, after
// which reading goes on with the next frame that can. Not its job: what the text means (json_rpc.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plcxx::rpc {

enum class Framing : uint8_t {
  kHeaders,  // "Content-Length: 53", an empty line, 53 bytes (Language Server Protocol)
  kLines,    // one line a message (Model Context Protocol)
};

/// A longer message is refused, and skipped.
inline constexpr size_t kMaxMessageBytes = size_t{64} << 20;

struct Frame {
  std::string text;   // of the message; empty with an error
  std::string error;  // why there is no message
};

class FrameReader {
 public:
  explicit FrameReader(Framing framing, size_t max_bytes = kMaxMessageBytes)
      : framing_(framing), max_bytes_(max_bytes) {}

  void Feed(std::string_view bytes);
  /// The next message that is complete; none until more has arrived.
  std::optional<Frame> Next();
  /// The last text was no message. Where its length was wrong, it has swallowed the beginning of the next frame:
  /// reading goes on there.
  void Reread(std::string_view text);

 private:
  std::optional<Frame> NextLine();
  std::optional<Frame> NextWithHeaders();
  /// What is left of a header that cannot be read, up to the next one that may be.
  void SkipToHeader();
  /// Of a message that is too long: to its end, or to a header in it, for then its length was wrong.
  void SkipMessage();
  std::string_view Rest() const { return std::string_view(bytes_).substr(at_); }
  void Drop(size_t count);

  Framing framing_;
  size_t max_bytes_;
  std::string bytes_;
  size_t at_ = 0;        // what lies before it has been given
  size_t skipping_ = 0;  // bytes of a message that is too long
  bool in_long_line_ = false;
};

/// `text` as one frame.
std::string Framed(Framing framing, std::string_view text);

}  // namespace plcxx::rpc
