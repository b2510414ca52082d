// What becomes of each of Clang's diagnostics, by its number: rows of tables (specification 3.7).
#pragma once

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::hnc {

/// Where the text of a message's parameter comes from, apart from the arguments 0, 1, ...
inline constexpr int kToken = -1;  // the token at the place, in quotes
inline constexpr int kWords = -2;  // Rule::words

struct Rule {
  unsigned id;
  const diag::Message<diag::Text>* message;
  int argument;
  const char* words = "";
};

/// What the language does not have (3.5), and what to write.
struct Extension {
  unsigned id;
  const char* words;
  const char* remedy;
};

/// Null: none for this one.
const Rule* FindRule(unsigned id);
const Extension* FindExtension(unsigned id);

/// Diagnostics that other code of ours reports, or that mean nothing here.
bool IsFoundElsewhere(unsigned id);

/// Extensions of Clang that the language has, too, and those that only follow from what is refused elsewhere. All
/// others are errors, also those that a later Clang brings.
bool IsAccepted(unsigned id);

}  // namespace plcxx::hnc
