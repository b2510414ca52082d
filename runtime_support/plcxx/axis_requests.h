// What an axis block has asked of the control last: HOST50 6.8.
//
// Plain memory: generated code compares and writes the fields where the block is.
// Position and speed are compared as bit patterns, but any two NaNs count as the same: the sign and the payload of a
// NaN that an operation yields are the processor's choice, and no second request may depend on that.
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
