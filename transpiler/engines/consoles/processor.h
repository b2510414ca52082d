// What differs between the emulated processors: the first instructions, and how they call the emulator.
#pragma once

#include <stdint.h>

namespace plcxx_console {

/// A request to the emulator with its block of parameters; its result.
intptr_t Semihosting(intptr_t operation, const void* block);

/// Called by the first instructions when there is a stack: memory, files, main. Does not come back.
[[noreturn]] void Run();

/// Where a processor's exception ends: the emulator goes away with exit code 1, which the engine tells.
[[noreturn]] void Fault();

}  // namespace plcxx_console
