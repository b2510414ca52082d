// A file inside the tool: what plcxx_embed in cmake/PlcxxTargets.cmake makes arrays of.
#pragma once

namespace plcxx::support {

struct EmbeddedFile {
  const char* name;  // without directory: "timers.h"
  unsigned size;
  const char* text;
};

}  // namespace plcxx::support
