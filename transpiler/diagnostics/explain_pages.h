// What the build generates from explain/*.md (plcxx_embed in cmake/PlcxxTargets.cmake).
#pragma once

namespace plcxx::diag {

struct EmbeddedFile {
  const char* name;  // "nc110-41.md"
  unsigned size;
  const char* text;
};

extern const EmbeddedFile kExplainPages[];  // sorted by name
extern const unsigned kExplainPagesCount;

}  // namespace plcxx::diag
