// How a harness (../harness.h) talks to the engine that started it: here by standard input and output of this machine.
//
// Written beside a harness as "console.h". C's library alone: the harness is compiled for every scenario, and the
// headers of C++'s cost more than all the rest. The end of the input ends the program.
#pragma once

#include <stdio.h>
#include <stdlib.h>

namespace plcxx_console {

/// Ends the program.
[[noreturn]] inline void Quit() { exit(0); }

/// Exactly `size` bytes, or Quit.
inline void Read(void* bytes, size_t size) {
  if (size > 0 && fread(bytes, size, 1, stdin) != 1) Quit();
}

/// Not seen by the engine before Flush.
inline void Write(const void* bytes, size_t size) { fwrite(bytes, 1, size, stdout); }
inline void Flush() { fflush(stdout); }

/// A block of `size` bytes with the first `old_size` bytes of `bytes`, which is given back. Quit when there is no room.
inline void* Grow(void* bytes, size_t /*old_size*/, size_t size) {
  bytes = realloc(bytes, size);
  if (bytes == nullptr) Quit();
  return bytes;
}

}  // namespace plcxx_console
