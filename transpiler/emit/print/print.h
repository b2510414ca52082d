// What is printed of an emittable program: its C++ files, its map, and itself.
//
// In: the Emittable and the source texts that go into comments. Out: files in the order in which they are read.
#pragma once

#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/source/source.h"

namespace plcxx::emit::print {

/// <name>.hpp, <name>.cpp and, for large programs, <name>_<part>.cpp.
std::vector<OutputFile> PrintCpp(const Emittable& emittable, const source::SourceManager& sources);

/// <name>.map.json: every symbol with address, type, offset in State and comment; every statement with file, line and
/// column. The only output with line numbers: it is for tools, and never compiled.
std::string PrintMap(const Emittable& emittable, const source::SourceManager& sources);

/// For `plcxx print ir-emittable`.
std::string PrintEmittable(const Emittable& emittable);

}  // namespace plcxx::emit::print
