// What the example needs of a board. One directory beside this one implements it for each processor.
#pragma once

#include <stdint.h>

namespace board {

/// From now on TimerTick is called from the timer's interrupt, once in `period_us` microseconds.
void StartTimer(uint32_t period_us);

/// The watchdog bites when it is not fed for 100 ms. A board without one does nothing.
void StartWatchdog();
void FeedWatchdog();

/// Sleeps until the next interrupt is over.
void WaitForInterrupt();

/// The serial port of a link (link.h); none of these waits.
void StartLink();
bool LinkReceive(uint8_t& byte);
bool LinkCanSend();
void LinkSend(uint8_t byte);

/// Ends the run in the emulator with a word and an exit code. On a machine: a loop that waits for the watchdog.
[[noreturn]] void End(const char* word, int code);

}  // namespace board

// The application's, called by the board.

/// The timer's interrupt.
extern "C" void TimerTick();

enum class FaultKind : uint8_t { kException, kWatchdog };
/// After an exception of the processor, or when the watchdog is about to reset. Must not come back.
extern "C" [[noreturn]] void FaultHook(FaultKind kind);

extern "C" int main();
