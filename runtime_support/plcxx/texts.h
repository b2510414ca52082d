// Texts that the operator sends to the logic, and the flags of the literals that compare with them.
//
// Implements NC110 7.5: at the start of every slow cycle each literal's flag is updated, then the inbox is cleared. All
// zero is the state after power-on. Comparison is exact, byte by byte, in the encoding of the control.
// Not its job: to queue texts (the latest wins), nor to make SendText safe against an interrupted scan (the host's).
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace plcxx {

constexpr uint8_t kLongestText = 32;

struct TextInbox {
  char text[kLongestText];
  uint8_t length;  // kLongestText + 1: the text was longer and equals no literal
  bool pending;
};

struct TextFlag {
  uint8_t left;  // slow cycles for which the flag stays 1, this one included
  bool flag;
};

/// The operator has sent a text of any length; it replaces one that is still pending.
constexpr void SendText(TextInbox& inbox, const char* text, size_t length) noexcept {
  inbox.pending = true;
  if (length > kLongestText) {
    inbox.length = kLongestText + 1;
    return;
  }
  inbox.length = static_cast<uint8_t>(text == nullptr ? 0 : length);
  for (uint8_t i = 0; i < inbox.length; ++i) inbox.text[i] = text[i];  // at most 32 rounds
}

/// True when the text in the inbox is the literal, a string of C.
constexpr bool EqualsText(const TextInbox& inbox, const char* literal) noexcept {
  if (literal == nullptr || inbox.length > kLongestText) return false;
  uint8_t i = 0;
  for (; literal[i] != '\0'; ++i) {  // at most 33 rounds: the inbox ends before
    if (i == inbox.length || literal[i] != inbox.text[i]) return false;
  }
  return i == inbox.length;
}

/// Start of a slow cycle, for one literal: its flag is 1 for two slow cycles after its text has arrived.
[[gnu::noinline]] static constexpr void UpdateText(TextFlag& flag, const TextInbox& inbox,
                                                   const char* literal) noexcept {
  if (inbox.pending) {
    flag.left = EqualsText(inbox, literal) ? 2 : 0;
  } else if (flag.left > 0) {
    --flag.left;
  }
  flag.flag = flag.left > 0;
}

/// After the flags of all literals are updated: the text is taken.
constexpr void ClearText(TextInbox& inbox) noexcept {
  inbox.pending = false;
  inbox.length = 0;
}

}  // namespace plcxx
