// Runs an ELF for the ATmega2560 in libsimavr, with a data memory of 64 KiB, and prints what the program shows: after
// a store to GPIOR0 the bytes at the address in GPIOR1 and GPIOR2, as many as OCR3A says, in hexadecimal on a line.
// The program ends with interrupts off and `sleep`. Exit code 0: it did; 1: it crashed or did not end within the cycles
// that the second argument gives; 2: no such ELF.
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr avr_io_addr_t kGpior0 = 0x3E;
constexpr unsigned kGpior1 = 0x4A;
constexpr unsigned kGpior2 = 0x4B;
constexpr unsigned kCount = 0x98;
constexpr std::uint16_t kLastDataByte = 0xFFFF;

void Show(avr_t* avr, avr_io_addr_t, std::uint8_t, void*) {
  const std::uint8_t* data = avr->data;
  const unsigned from = data[kGpior1] | (data[kGpior2] << 8);
  const unsigned count = data[kCount] | (data[kCount + 1] << 8);
  for (unsigned i = 0; i < count; ++i) {
    std::printf("%02x", data[from + i]);
  }
  std::printf("\n");
}

void Silent(avr_t*, int, const char*, va_list) {}

}  // namespace

int main(int count, char** arguments) {
  avr_global_logger_set(Silent);
  elf_firmware_t firmware = {};
  if (count != 3 || elf_read_firmware(arguments[1], &firmware) != 0) {
    return 2;
  }
  avr_t* avr = avr_make_mcu_by_name("atmega2560");
  avr->ramend = kLastDataByte;  // before avr_init, which allocates the memory
  avr_init(avr);
  firmware.frequency = 16'000'000;
  avr_load_firmware(avr, &firmware);
  avr_register_io_write(avr, kGpior0, Show, nullptr);
  const std::uint64_t most_cycles = std::strtoull(arguments[2], nullptr, 10);
  int state = cpu_Running;
  while (state != cpu_Done && state != cpu_Crashed && avr->cycle < most_cycles) {
    state = avr_run(avr);
  }
  return state == cpu_Done ? 0 : 1;
}
