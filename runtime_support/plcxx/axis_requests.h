// What an axis block has asked of the control last: HOST50 6.8.
//
// Plain memory: generated code compares and writes the fields where the block stands.
#pragma once

#include <stdint.h>

namespace plcxx {

struct AxisRequest {
  uint32_t axis;    // 0..9, while active
  uint32_t method;  // of homing
  float position;
  float speed;
  bool active;
};

}  // namespace plcxx
