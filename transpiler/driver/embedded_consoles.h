// The files of consoles/ inside the tool, so that a moved binary can still build harnesses.
#pragma once

namespace plcxx::driver {

struct EmbeddedFile {
  const char* name;  // "host.h"
  unsigned size;
  const char* text;
};

extern const EmbeddedFile kConsoleFiles[];
extern const unsigned kConsoleFilesCount;

}  // namespace plcxx::driver
