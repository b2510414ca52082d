// What a module of plcxx needs of LinuxCNC's hal.h, where LinuxCNC is not installed: the API of 2.9; with STUB_HAL=210
// that of 2.10 as its master has it, with the old pins beside the new ones; with STUB_HAL=211 what its comments
// announce: the old pins and uses_fp gone. stub.cc has the functions.
//
// tests/host/linuxcnc_headers.py compares this with LinuxCNC's own header, where one is.
#pragma once

#include <stdint.h>

#ifndef STUB_HAL
#define STUB_HAL 29
#endif

#if STUB_HAL >= 210
#define HAL_NAME_LEN 55
#define HAL_BOOL 1
typedef enum { HAL_DIR_UNSPECIFIED = -1, HAL_IN = 16, HAL_OUT = 32, HAL_IO = 48 } hal_pdir_t;
typedef hal_pdir_t hal_pin_dir_t;
#else
#define HAL_NAME_LEN 47
typedef enum { HAL_DIR_UNSPECIFIED = -1, HAL_IN = 16, HAL_OUT = 32, HAL_IO = 48 } hal_pin_dir_t;
#endif

extern "C" {
int hal_init(const char* name);
int hal_ready(int component);
int hal_exit(int component);
void* hal_malloc(long bytes);

#if STUB_HAL >= 210
// References that nobody may look through.
typedef struct stub_bool* hal_bool_t;
typedef struct stub_sint* hal_sint_t;
typedef struct stub_uint* hal_uint_t;
typedef struct stub_real* hal_real_t;
int hal_pin_new_bool(int component, hal_pdir_t direction, hal_bool_t* pin, bool value, const char* format, ...);
int hal_pin_new_si32(int component, hal_pdir_t direction, hal_sint_t* pin, int32_t value, const char* format, ...);
int hal_pin_new_ui32(int component, hal_pdir_t direction, hal_uint_t* pin, uint32_t value, const char* format, ...);
int hal_pin_new_real(int component, hal_pdir_t direction, hal_real_t* pin, double value, const char* format, ...);
bool hal_get_bool(const hal_bool_t pin);
int32_t hal_get_si32(const hal_sint_t pin);
uint32_t hal_get_ui32(const hal_uint_t pin);
double hal_get_real(const hal_real_t pin);
bool hal_set_bool(hal_bool_t pin, bool value);
int32_t hal_set_si32(hal_sint_t pin, int32_t value);
uint32_t hal_set_ui32(hal_uint_t pin, uint32_t value);
double hal_set_real(hal_real_t pin, double value);
#endif

#if STUB_HAL < 211
typedef volatile bool hal_bit_t;
typedef volatile int32_t hal_s32_t;
typedef volatile uint32_t hal_u32_t;
typedef volatile double hal_float_t;
int hal_pin_bit_newf(hal_pin_dir_t direction, hal_bit_t** pin, int component, const char* format, ...);
int hal_pin_s32_newf(hal_pin_dir_t direction, hal_s32_t** pin, int component, const char* format, ...);
int hal_pin_u32_newf(hal_pin_dir_t direction, hal_u32_t** pin, int component, const char* format, ...);
int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t** pin, int component, const char* format, ...);
int hal_export_funct(const char* name, void (*function)(void*, long), void* argument, int uses_fp, int reentrant,
                     int component);
#else
int hal_export_funct(const char* name, void (*function)(void*, long), void* argument, int reentrant, int component);
#endif
}
