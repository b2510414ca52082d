// The program as the C++ printer takes it: every decision made, nothing spelled.
//
// Legalize chooses names, storage, which values become named locals, and the chunks and files that the statements go
// into; the printer only spells. Chunk borders are content-defined (they depend on the statements' own texts), so
// that an inserted statement does not move the borders behind it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/emit/layout.h"
#include "transpiler/ir/program.h"

namespace plcxx::emit {

/// Debug carries force masks and line enables; release carries none of it. The statements' text is the same.
enum class Flavour : uint8_t { kRelease, kDebug };

struct EmitOptions {
  std::string name = "program";  // of the files and, made safe, of the namespace
  Flavour flavour = Flavour::kRelease;
  bool line_directives = false;
};

/// A function of its own for a stretch of statements: small functions compile in linear time and stay in cache.
struct Chunk {
  std::string name;
  ir::RegionId region;
  uint32_t begin = 0, end = 0;  // indices into the region's instructions
  uint32_t part = 0;            // index into Emittable::parts
  uint32_t statements = 0;      // nested ones included
  bool top_level = false;       // called by the routine itself, not by the chunk it was cut from
};

/// One generated .cpp file; part 0 holds the routines themselves.
struct Part {
  std::string suffix;  // "" or "_slow_U4A8": the file is <name><suffix>.cpp
  std::string entry;   // the function that runs all chunks of this part; empty for part 0
};

struct Emittable {
  const ir::Program* program = nullptr;
  EmitOptions options;
  Layout layout;
  std::string namespace_name;
  std::vector<std::string> place_names;    // by PlaceId; empty: nothing uses it
  std::vector<std::string> state_names;    // by StateId
  std::vector<std::string> stretch_names;  // by index in Layout::stretches: of its first byte
  std::vector<bool> local_value;           // by InstId: computed into a named const before its use
  std::vector<Chunk> chunks;               // nested ones before the ones that call them
  std::vector<std::vector<uint32_t>>
      region_chunks;  // by RegionId: what the region was cut into; empty: printed in place
  std::vector<Part> parts;
  std::vector<std::string> functions;  // of runtime_support that expressions call, sorted
  std::vector<bool> host_used;         // by HostFunctionId
};

/// `program` is structured, sliced and optimized, and outlives the result.
Emittable Legalize(const ir::Program& program, const EmitOptions& options);

/// For `plcxx print ir-emittable`.
std::string Print(const Emittable& emittable);

// The steps of Legalize, one file each.
void NamePlaces(Emittable& emittable);
void PlaceTemporaries(Emittable& emittable);
void CutChunks(Emittable& emittable);

}  // namespace plcxx::emit
