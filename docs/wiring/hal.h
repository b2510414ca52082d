// What docs/wiring.md needs of LinuxCNC's hal.h, where LinuxCNC is not installed: it compiles and links, and connects
// nothing. Inputs are 1.
#pragma once

#include <stdlib.h>

typedef volatile bool hal_bit_t;
typedef enum { HAL_IN = 16, HAL_OUT = 32 } hal_pin_dir_t;

inline int hal_init(const char*) { return 1; }
inline int hal_ready(int) { return 0; }
inline int hal_exit(int) { return 0; }
inline void* hal_malloc(long bytes) { return calloc(1, static_cast<size_t>(bytes)); }
inline int hal_pin_bit_newf(hal_pin_dir_t, hal_bit_t** pin, int, const char*, ...) {
  *pin = static_cast<hal_bit_t*>(calloc(1, 1));
  **pin = true;
  return 0;
}
