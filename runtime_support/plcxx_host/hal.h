// Pins of LinuxCNC's HAL, for the API of 2.9 and for that of 2.10.
//
// 2.9 gives pointers into shared memory, 2.10 references with functions that read and write; what differs is here. 2.10
// still has the pointers, and says that they are to go. Its header has no number of a version: HAL_BOOL is a name of
// its types that 2.9 does not have.
#pragma once

#include <stdint.h>

#include <hal.h>
#include <rtapi.h>
#include <rtapi_app.h>

#include <plcxx_host/pins.h>

namespace plcxx::host {

inline auto ToHal(Direction direction) noexcept {
  return direction == Direction::kIn ? HAL_IN : direction == Direction::kOut ? HAL_OUT : HAL_IO;
}

#if defined(HAL_BOOL)

union HalPin {
  hal_bool_t bit;
  hal_sint_t s32;
  hal_uint_t u32;
  hal_real_t real;
};

inline bool GetBit(const HalPin& pin) noexcept { return hal_get_bool(pin.bit) != 0; }
inline int32_t GetS32(const HalPin& pin) noexcept { return hal_get_si32(pin.s32); }
inline uint32_t GetU32(const HalPin& pin) noexcept { return hal_get_ui32(pin.u32); }
inline double GetReal(const HalPin& pin) noexcept { return hal_get_real(pin.real); }
inline void SetBit(HalPin& pin, bool value) noexcept { hal_set_bool(pin.bit, value); }
inline void SetS32(HalPin& pin, int32_t value) noexcept { hal_set_si32(pin.s32, value); }
inline void SetU32(HalPin& pin, uint32_t value) noexcept { hal_set_ui32(pin.u32, value); }
inline void SetReal(HalPin& pin, double value) noexcept { hal_set_real(pin.real, value); }

inline int NewPin(HalPin& pin, int component, Type type, Direction to, const char* name) noexcept {
  const auto direction = ToHal(to);
  switch (type) {
    case Type::kBit:
      return hal_pin_new_bool(component, direction, &pin.bit, 0, "%s", name);
    case Type::kS32:
      return hal_pin_new_si32(component, direction, &pin.s32, 0, "%s", name);
    case Type::kU32:
      return hal_pin_new_ui32(component, direction, &pin.u32, 0, "%s", name);
    case Type::kFloat:
      return hal_pin_new_real(component, direction, &pin.real, 0, "%s", name);
  }
  return -1;
}

#else

/// Lies in memory of hal_malloc, as HAL writes the pointer when a pin is linked.
union HalPin {
  hal_bit_t* bit;
  hal_s32_t* s32;
  hal_u32_t* u32;
  hal_float_t* real;
};

inline bool GetBit(const HalPin& pin) noexcept { return *pin.bit; }
inline int32_t GetS32(const HalPin& pin) noexcept { return *pin.s32; }
inline uint32_t GetU32(const HalPin& pin) noexcept { return *pin.u32; }
inline double GetReal(const HalPin& pin) noexcept { return *pin.real; }
inline void SetBit(HalPin& pin, bool value) noexcept { *pin.bit = value; }
inline void SetS32(HalPin& pin, int32_t value) noexcept { *pin.s32 = value; }
inline void SetU32(HalPin& pin, uint32_t value) noexcept { *pin.u32 = value; }
inline void SetReal(HalPin& pin, double value) noexcept { *pin.real = value; }

inline int NewPin(HalPin& pin, int component, Type type, Direction to, const char* name) noexcept {
  const auto direction = ToHal(to);
  switch (type) {
    case Type::kBit:
      return hal_pin_bit_newf(direction, &pin.bit, component, "%s", name);
    case Type::kS32:
      return hal_pin_s32_newf(direction, &pin.s32, component, "%s", name);
    case Type::kU32:
      return hal_pin_u32_newf(direction, &pin.u32, component, "%s", name);
    case Type::kFloat:
      return hal_pin_float_newf(direction, &pin.real, component, "%s", name);
  }
  return -1;
}

#endif

using HalFunction = void (*)(void*, long);
/// `uses_fp` is ignored by 2.10, which says that it is to go: whichever hal_export_funct the header declares.
inline int ExportBy(int (*with_fp)(const char*, HalFunction, void*, int, int, int), const char* name,
                    HalFunction function, void* argument, int component) noexcept {
  return with_fp(name, function, argument, 1, 0, component);
}
inline int ExportBy(int (*without)(const char*, HalFunction, void*, int, int), const char* name, HalFunction function,
                    void* argument, int component) noexcept {
  return without(name, function, argument, 0, component);
}
inline int ExportFunction(const char* name, HalFunction function, void* argument, int component) noexcept {
  return ExportBy(&hal_export_funct, name, function, argument, component);
}

}  // namespace plcxx::host
