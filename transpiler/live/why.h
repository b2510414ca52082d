// Why a signal is what it is now: the last periods are run again on a copy of the machine, and explained.
#pragma once

#include <string>

#include "transpiler/live/session.h"

namespace plcxx::live {

struct Reasons {
  std::string text;  // indented lines, as `plcxx why` prints them
  Refusal refusal;   // or why there are none
};
Reasons WhyNow(Session& session, const std::string& name);

}  // namespace plcxx::live
