// Numbers of statements for maps and for names in generated code: made from a statement's text and a count among equal
// texts, never from its place, so that an inserted statement changes no other one's number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "transpiler/support/fnv1a.h"

namespace plcxx::dialects {

/// A running hash of what makes the text of a statement; which characters count is the language's matter.
using TextHash = support::Fnv1a32;

class StatementIds {
 public:
  /// Unique and never 0; the first statement with a text keeps the text's own hash.
  uint32_t Next(TextHash text);

 private:
  std::unordered_map<uint32_t, uint32_t> equal_texts_;
  std::unordered_set<uint32_t> used_;
};

/// "START_edge" and a statement's number -> "START_edge_4f2a".
std::string NameInStatement(std::string_view name, uint32_t statement);

}  // namespace plcxx::dialects
