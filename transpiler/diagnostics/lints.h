// The checks that are the same in every dialect, with the message by which a dialect reports each.
// A null message: the dialect does not have the check. checks/ finds, the dialect's row words it.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::diag {

/// Each message takes the name of the place or instance it is about.
struct Lints {
  const Message<Text>* driven_in_both_parts = nullptr;     // one state instance stepped in fast and slow
  const Message<Text>* driven_twice = nullptr;             // two statements step one instance
  const Message<Text>* read_never_driven = nullptr;        // an instance is read, no statement steps it
  const Message<Text>* sliced_carry_read = nullptr;        // carry of a fast counter read in a sliced slow part
  const Message<Text>* written_in_both_parts = nullptr;    // the same bit or word in fast and slow
  const Message<Text>* double_coil = nullptr;              // two unconditional writes, no read in between
  const Message<Text>* dead_store = nullptr;               // overwritten before any read or the end of the partition
  const Message<Text>* read_never_written = nullptr;       // free memory that nothing writes
  const Message<Text>* self_hold_without_reset = nullptr;  // U = a + U and nothing else writes U
};

}  // namespace plcxx::diag
