// Whether the program of a machine is the one that is here, and how its State is laid out then.
#pragma once

#include <functional>
#include <string>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/link/target.h"
#include "transpiler/link/transport.h"

namespace plcxx::debug_link {

struct LinkedProgram {
  std::string difference;  // empty: it is this program
  emit::layout::Layout layout;
  Target::Length length{};
};

/// Of the 64 bytes that a machine has sent.
using MatchIdentity = std::function<LinkedProgram(const Bytes& identity)>;

}  // namespace plcxx::debug_link
