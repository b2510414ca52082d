// Executes the instances on the target, in QEMU: each gets a block with registers and memory, and what it left there is
// written to a file of the host's.
#include <stddef.h>
#include <stdint.h>

enum { kBlock = 352, kHeader = 76, kScratch = 96, kPattern = kBlock - kScratch };

typedef void Instance(uint8_t* block);
extern Instance* const judge_instances[];
extern const uint32_t judge_count, judge_states;
extern const uint8_t judge_headers[], judge_pattern[];
void judge_call(Instance* instance, uint8_t* block);

intptr_t judge_semihosting(intptr_t operation, const void* block);

static uint8_t block[kBlock] __attribute__((aligned(16)));

int main(void) {
  static const char name[] = JUDGE_RESULTS;
  const intptr_t open[] = {(intptr_t)name, 5 /* wb */, sizeof name - 1};
  const intptr_t file = judge_semihosting(1, open);
  const uint8_t* header = judge_headers;
  for (uint32_t i = 0; i < judge_count; ++i) {
    for (uint32_t k = 0; k < judge_states; ++k, header += kHeader) {
      for (size_t at = 0; at < kBlock; ++at)
        block[at] = at < kHeader ? header[at] : at < kScratch ? 0 : judge_pattern[at - kScratch];
      judge_call(judge_instances[i], block);
      const intptr_t write[] = {file, (intptr_t)block, kBlock};
      judge_semihosting(5, write);
    }
  }
  const intptr_t close[] = {file};
  judge_semihosting(2, close);
  const intptr_t end[] = {0x20026, 0};  // ADP_Stopped_ApplicationExit
  judge_semihosting(0x20, end);
  judge_semihosting(0x18, (const void*)0x20026);
  for (;;) {
  }
}
