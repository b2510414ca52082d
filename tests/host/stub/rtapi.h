// What a module of plcxx needs of LinuxCNC's rtapi.h, where LinuxCNC is not installed.
#pragma once

typedef enum { RTAPI_MSG_NONE = 0, RTAPI_MSG_ERR, RTAPI_MSG_WARN, RTAPI_MSG_INFO, RTAPI_MSG_DBG } msg_level_t;

extern "C" void rtapi_print_msg(msg_level_t level, const char* format, ...) __attribute__((format(printf, 2, 3)));

// Parameters of loadrt are found by name.
#define RTAPI_MP_STRING(variable, text)                    \
  extern "C" {                                             \
  char** stub_parameter_##variable() { return &variable; } \
  }
