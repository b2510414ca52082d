// Numbers of statements for maps and for names in generated code: made from a statement's text and a count among equal
// texts, never from its place, so that an inserted statement changes no other one's number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/support/fnv1a.h"

namespace plcxx::dialects {

/// A running hash of what makes the text of a statement; which characters count is the language's matter.
using TextHash = support::Fnv1a32;

class StatementIds {
 public:
  /// Unique and never 0; the first statement with a text keeps the text's own hash.
  uint32_t Next(TextHash text);

 private:
  struct Hash {
    uint32_t value = 0;
    uint32_t texts = 0;    // that have it
    bool is_used = false;  // as a number
  };
  /// The one with this value, until the next call; a new one is to be counted or used.
  Hash& At(uint32_t value);
  void Grow();

  // By value, with the next free place where that is taken: each statement comes by here, and a table of nodes took as
  // long as its lowering.
  std::vector<Hash> hashes_;
  size_t count_ = 0;  // of those in it
};

/// "START_edge" and a statement's number -> "START_edge_4f2a".
std::string NameInStatement(std::string_view name, uint32_t statement);

}  // namespace plcxx::dialects
