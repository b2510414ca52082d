// The headers of runtime_support inside the tool, so that a moved binary can still compile what it generated.
#pragma once

namespace plcxx::compile {

struct EmbeddedFile {
  const char* name;  // "timers.h"
  unsigned size;
  const char* text;
};

extern const EmbeddedFile kRuntimeHeaders[];
extern const unsigned kRuntimeHeadersCount;

}  // namespace plcxx::compile
