// What the machine has said, the newest at the end.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <utility>

#include "transpiler/ir/program.h"

namespace plcxx::live {

enum class NoteKind : uint8_t { kMessage, kCall, kFault, kLink };
struct Note {
  uint64_t period = 0, time_ms = 0;
  NoteKind kind{};
  std::string text;
  ir::StatementId statement;  // of a fault: where
};
inline constexpr size_t kMostNotes = 200;

class Notes {
 public:
  void Add(Note note) {
    notes_.push_back(std::move(note));
    if (notes_.size() > kMostNotes) notes_.pop_front();
    ++version_;
  }
  /// The machine went back to the beginning of this period.
  void GoBack(uint64_t period) {
    while (!notes_.empty() && notes_.back().period >= period) notes_.pop_back();
    ++version_;
  }
  const std::deque<Note>& all() const { return notes_; }
  /// Another one with each change.
  uint32_t version() const { return version_; }

 private:
  std::deque<Note> notes_;
  uint32_t version_ = 0;
};

}  // namespace plcxx::live
