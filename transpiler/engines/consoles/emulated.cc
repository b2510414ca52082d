// The console of a harness in QEMU, and what GCC expects of C's library: all that stands between the processor's first
// instructions (cortex_m.cc, riscv.cc) and the harness.
//
// Numbers and blocks of parameters are those of "Semihosting for AArch32 and AArch64" by Arm, which RISC-V took over.

#include <console.h>
#include <processor.h>

using Word [[gnu::may_alias]] = uintptr_t;

// The compiler calls these for copies and initial values. It must not make a call of themselves out of their loops:
// compile with -fno-tree-loop-distribute-patterns.
extern "C" {

void* memcpy(void* to, const void* from, size_t size) {
  size_t i = 0;
  if (((reinterpret_cast<uintptr_t>(to) | reinterpret_cast<uintptr_t>(from)) & (sizeof(Word) - 1)) == 0) {
    for (; i + sizeof(Word) <= size; i += sizeof(Word)) {
      *reinterpret_cast<Word*>(static_cast<unsigned char*>(to) + i) =
          *reinterpret_cast<const Word*>(static_cast<const unsigned char*>(from) + i);
    }
  }
  for (; i < size; ++i) static_cast<unsigned char*>(to)[i] = static_cast<const unsigned char*>(from)[i];
  return to;
}

void* memmove(void* to, const void* from, size_t size) {
  if (to <= from) return memcpy(to, from, size);
  for (size_t i = size; i-- > 0;) static_cast<unsigned char*>(to)[i] = static_cast<const unsigned char*>(from)[i];
  return to;
}

void* memset(void* to, int value, size_t size) {
  for (size_t i = 0; i < size; ++i) static_cast<unsigned char*>(to)[i] = static_cast<unsigned char>(value);
  return to;
}

int memcmp(const void* first, const void* second, size_t size) {
  const auto* const a = static_cast<const unsigned char*>(first);
  const auto* const b = static_cast<const unsigned char*>(second);
  for (size_t i = 0; i < size; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

int main();

// Of the linker script.
extern unsigned char plcxx_data_begin[], plcxx_data_end[], plcxx_data_image[];
extern unsigned char plcxx_bss_begin[], plcxx_bss_end[];
extern unsigned char plcxx_room_begin[], plcxx_room_end[];
}

namespace plcxx_console {
namespace {

constexpr intptr_t kOpen = 0x01, kWrite = 0x05, kRead = 0x06, kExitExtended = 0x20;
constexpr intptr_t kModeRead = 0, kModeWrite = 4;
constexpr intptr_t kApplicationExit = 0x20026;

unsigned char input[4096], output[16384];
size_t input_at = 0, input_end = 0, output_end = 0;
intptr_t input_file = -1, output_file = -1;
unsigned char* room = plcxx_room_begin;

[[noreturn]] void Exit(intptr_t code) {
  const intptr_t block[] = {kApplicationExit, code};
  for (;;) Semihosting(kExitExtended, block);
}

template <size_t kSize>
intptr_t Open(const char (&name)[kSize], intptr_t mode) {
  const intptr_t block[] = {reinterpret_cast<intptr_t>(name), mode, kSize - 1};
  return Semihosting(kOpen, block);
}

void Fill() {
  const intptr_t block[] = {input_file, reinterpret_cast<intptr_t>(input), sizeof input};
  const intptr_t missing = Semihosting(kRead, block);
  if (missing < 0 || missing >= static_cast<intptr_t>(sizeof input)) Quit();
  input_at = 0;
  input_end = sizeof input - static_cast<size_t>(missing);
}

void Deliver(const unsigned char* bytes, size_t size) {
  while (size > 0) {
    const intptr_t block[] = {output_file, reinterpret_cast<intptr_t>(bytes), static_cast<intptr_t>(size)};
    const intptr_t missing = Semihosting(kWrite, block);
    if (missing < 0 || missing >= static_cast<intptr_t>(size)) Fault();
    bytes += size - static_cast<size_t>(missing);
    size = static_cast<size_t>(missing);
  }
}

}  // namespace

void Quit() { Exit(0); }

void Fault() { Exit(1); }

void Read(void* bytes, size_t size) {
  for (size_t done = 0; done < size;) {
    if (input_at == input_end) Fill();
    const size_t part = size - done < input_end - input_at ? size - done : input_end - input_at;
    memcpy(static_cast<unsigned char*>(bytes) + done, input + input_at, part);
    input_at += part;
    done += part;
  }
}

void Flush() {
  Deliver(output, output_end);
  output_end = 0;
}

void Write(const void* bytes, size_t size) {
  if (size > sizeof output - output_end) Flush();
  if (size > sizeof output) return Deliver(static_cast<const unsigned char*>(bytes), size);
  memcpy(output + output_end, bytes, size);
  output_end += size;
}

// Blocks are not given back: each is at least twice as large as the one before, so that half of the room is of use.
void* Grow(void* bytes, size_t old_size, size_t size) {
  constexpr size_t kAlignment = 16;
  const size_t rounded = (size + kAlignment - 1) / kAlignment * kAlignment;
  if (rounded < size || static_cast<size_t>(plcxx_room_end - room) < rounded) Fault();
  void* const block = room;
  room += rounded;
  if (bytes != nullptr) memcpy(block, bytes, old_size);
  return block;
}

void Run() {
  memcpy(plcxx_data_begin, plcxx_data_image, static_cast<size_t>(plcxx_data_end - plcxx_data_begin));
  memset(plcxx_bss_begin, 0, static_cast<size_t>(plcxx_bss_end - plcxx_bss_begin));
  // Values that stand above (files of -1, the room) are in .data, which is there from here on.
  input_file = Open("/dev/stdin", kModeRead);
  output_file = Open("/dev/stdout", kModeWrite);
  if (input_file < 0 || output_file < 0) Fault();
  main();
  Quit();
}

}  // namespace plcxx_console
