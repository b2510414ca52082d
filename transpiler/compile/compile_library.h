// Generated C++ to objects and a static library, in a directory of its own.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/output_file.h"

namespace plcxx::compile {

struct LibraryRequest {
  const Target* target = nullptr;
  const Toolchain* toolchain = nullptr;
  std::string name;                                      // of the program; the library is lib<name>.a
  std::string level;                                     // as behind -O
  unsigned jobs = 1;                                     // compilers at the same time
  const std::vector<emit::OutputFile>* files = nullptr;  // those that end in .hpp and .cpp count
  std::string directory;                                 // exists, empty
  std::string previous;  // directory that may hold the library of an earlier build; empty: the current one
  std::function<void(std::string_view)> progress;
};

/// What the compiler is to read cannot be written into the directory.
struct NoRoom {};

struct RefusedSource {
  std::string source;   // its name; empty: the archiver
  std::string message;  // the first line with a fault
  std::string output;   // all that the compiler said
};

struct Library {
  std::vector<std::string> objects;  // names below the request's directory
  std::string archive;               // likewise
  std::string record;                // the text of lib<name>.objects, for the next build (known_objects.h)
};

std::variant<Library, RefusedSource, NoRoom> CompileLibrary(const LibraryRequest& request);

}  // namespace plcxx::compile
