// HAL in one process, driven by lines of standard input:
//   load [names=A,B] [retentive=FOLDER]    -> loaded CODE
//   set PIN VALUE                          (pins of the module that are inputs)
//   call FUNCTION PERIOD_NS TIMES
//   get PIN                                -> PIN VALUE
//   pins                                   -> a line for each: PIN TYPE in|out
//   wait MS, unload
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "hal.h"
#include "rtapi.h"
#include "rtapi_app.h"

extern "C" char** stub_parameter_names();
extern "C" char** stub_parameter_retentive();

namespace {

struct StubPin {
  char type = 'b';
  hal_pin_dir_t direction = HAL_IN;
  union {
    bool bit;
    int32_t s32;
    uint32_t u32;
    double real = 0;
  } value;
};
struct StubFunction {
  void (*function)(void*, long) = nullptr;
  void* argument = nullptr;
};
std::map<std::string, StubPin> pins;
std::map<std::string, StubFunction> functions;

StubPin* Add(char type, hal_pin_dir_t direction, const char* format, va_list arguments) {
  char name[256];
  vsnprintf(name, sizeof name, format, arguments);
  if (strlen(name) > HAL_NAME_LEN || pins.count(name) != 0) return nullptr;
  StubPin& pin = pins[name];
  pin.type = type;
  pin.direction = direction;
  return &pin;
}

std::string Value(const StubPin& pin) {
  std::ostringstream text;
  if (pin.type == 'b') text << pin.value.bit;
  if (pin.type == 's') text << pin.value.s32;
  if (pin.type == 'u') text << pin.value.u32;
  if (pin.type == 'f') text << pin.value.real;
  return text.str();
}

}  // namespace

#define STUB_NEW(Type, member)                                                           \
  va_list arguments;                                                                     \
  va_start(arguments, format);                                                           \
  StubPin* const made = Add(Type, direction, format, arguments);                         \
  va_end(arguments);                                                                     \
  if (made == nullptr) return -22;                                                       \
  *pin = reinterpret_cast<std::remove_reference_t<decltype(*pin)>>(&made->value.member); \
  return 0

extern "C" {

int hal_init(const char* name) { return strlen(name) <= HAL_NAME_LEN ? 1 : -22; }
int hal_ready(int) { return 0; }
int hal_exit(int) {
  pins.clear();
  functions.clear();
  return 0;
}
void* hal_malloc(long bytes) { return calloc(1, static_cast<size_t>(bytes)); }
void rtapi_print_msg(msg_level_t level, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  printf("message %d: ", static_cast<int>(level));
  vprintf(format, arguments);
  va_end(arguments);
  fflush(stdout);
}

#if STUB_HAL >= 210
int hal_pin_new_bool(int, hal_pdir_t direction, hal_bool_t* pin, bool, const char* format, ...) { STUB_NEW('b', bit); }
int hal_pin_new_si32(int, hal_pdir_t direction, hal_sint_t* pin, int32_t, const char* format, ...) {
  STUB_NEW('s', s32);
}
int hal_pin_new_ui32(int, hal_pdir_t direction, hal_uint_t* pin, uint32_t, const char* format, ...) {
  STUB_NEW('u', u32);
}
int hal_pin_new_real(int, hal_pdir_t direction, hal_real_t* pin, double, const char* format, ...) {
  STUB_NEW('f', real);
}
bool hal_get_bool(const hal_bool_t pin) { return *reinterpret_cast<bool*>(pin); }
int32_t hal_get_si32(const hal_sint_t pin) { return *reinterpret_cast<int32_t*>(pin); }
uint32_t hal_get_ui32(const hal_uint_t pin) { return *reinterpret_cast<uint32_t*>(pin); }
double hal_get_real(const hal_real_t pin) { return *reinterpret_cast<double*>(pin); }
bool hal_set_bool(hal_bool_t pin, bool value) { return *reinterpret_cast<bool*>(pin) = value; }
int32_t hal_set_si32(hal_sint_t pin, int32_t value) { return *reinterpret_cast<int32_t*>(pin) = value; }
uint32_t hal_set_ui32(hal_uint_t pin, uint32_t value) { return *reinterpret_cast<uint32_t*>(pin) = value; }
double hal_set_real(hal_real_t pin, double value) { return *reinterpret_cast<double*>(pin) = value; }
#endif

#if STUB_HAL == 29
int hal_pin_bit_newf(hal_pin_dir_t direction, hal_bit_t** pin, int, const char* format, ...) { STUB_NEW('b', bit); }
int hal_pin_s32_newf(hal_pin_dir_t direction, hal_s32_t** pin, int, const char* format, ...) { STUB_NEW('s', s32); }
int hal_pin_u32_newf(hal_pin_dir_t direction, hal_u32_t** pin, int, const char* format, ...) { STUB_NEW('u', u32); }
int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t** pin, int, const char* format, ...) {
  STUB_NEW('f', real);
}
#elif STUB_HAL == 210
// Declared, and to go: a module that still makes such a pin gets none.
int hal_pin_bit_newf(hal_pin_dir_t, hal_bit_t**, int, const char*, ...) { return -38; }
int hal_pin_s32_newf(hal_pin_dir_t, hal_s32_t**, int, const char*, ...) { return -38; }
int hal_pin_u32_newf(hal_pin_dir_t, hal_u32_t**, int, const char*, ...) { return -38; }
int hal_pin_float_newf(hal_pin_dir_t, hal_float_t**, int, const char*, ...) { return -38; }
#endif

#if STUB_HAL < 211
int hal_export_funct(const char* name, void (*function)(void*, long), void* argument, int, int, int) {
#else
int hal_export_funct(const char* name, void (*function)(void*, long), void* argument, int, int) {
#endif
  functions[name] = {function, argument};
  return 0;
}

}  // extern "C"

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, name;
    words >> word;
    if (word == "load") {
      for (std::string parameter; words >> parameter;) {
        const size_t equal = parameter.find('=');
        char** const variable =
            parameter.substr(0, equal) == "names" ? stub_parameter_names() : stub_parameter_retentive();
        *variable = strdup(parameter.c_str() + equal + 1);
      }
      const int code = rtapi_app_main();
      std::cout << "loaded " << code << std::endl;
    } else if (word == "unload") {
      rtapi_app_exit();
    } else if (word == "set") {
      double value = 0;
      words >> name >> value;
      const auto pin = pins.find(name);
      if (pin == pins.end() || pin->second.direction == HAL_OUT) {
        std::cout << "no input " << name << std::endl;
        continue;
      }
      if (pin->second.type == 'b') pin->second.value.bit = value != 0;
      if (pin->second.type == 's') pin->second.value.s32 = static_cast<int32_t>(value);
      if (pin->second.type == 'u') pin->second.value.u32 = static_cast<uint32_t>(value);
      if (pin->second.type == 'f') pin->second.value.real = value;
    } else if (word == "get") {
      words >> name;
      std::cout << name << ' ' << (pins.count(name) != 0 ? Value(pins[name]) : "is no pin") << std::endl;
    } else if (word == "pins") {
      for (const auto& [pin, data] : pins)
        std::cout << pin << ' ' << data.type
                  << (data.direction == HAL_IN    ? " in"
                      : data.direction == HAL_OUT ? " out"
                                                  : " io")
                  << std::endl;
    } else if (word == "call") {
      long period = 0;
      int times = 1;
      words >> name >> period >> times;
      const auto found = functions.find(name);
      if (found == functions.end()) std::cout << "no function " << name << std::endl;
      for (int i = 0; found != functions.end() && i < times; ++i)
        found->second.function(found->second.argument, period);
    } else if (word == "wait") {
      int ms = 0;
      words >> ms;
      usleep(static_cast<useconds_t>(ms) * 1000);
    }
  }
}
