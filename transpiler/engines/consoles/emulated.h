// How a harness (../harness.h) talks to the engine that started it: here from a processor in QEMU, by semihosting.
//
// Written beside a harness as "console.h"; compiled once for all harnesses of a platform (emulated.cc). The contract
// of each function is that of host.h, which is the same interface on the machine that plcxx runs on.
#pragma once

#include <stddef.h>

namespace plcxx_console {

[[noreturn]] void Quit();
void Read(void* bytes, size_t size);
void Write(const void* bytes, size_t size);
void Flush();
void* Grow(void* bytes, size_t old_size, size_t size);

}  // namespace plcxx_console
