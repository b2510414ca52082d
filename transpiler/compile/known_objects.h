// Objects of an earlier build that need not be compiled again.
//
// Beside lib<name>.a stands lib<name>.objects: for each object the SHA-256 of all that it was made of (source, headers,
// command, compiler, variables that the compiler reads) and of itself. An object is taken from the library when both
// are what they were: a compiler that was upgraded, a header or an option that changed, a library that somebody else
// wrote all lead to compiling.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/output_file.h"

namespace plcxx::compile {

/// Included by sources, not compiled itself.
bool IsHeader(const emit::OutputFile& file);

/// What all sources of a library have in common: headers of program and runtime, compiler, its environment.
std::string CommonInputs(const Toolchain& toolchain, const std::vector<emit::OutputFile>& files);

/// SHA-256 of all that an object is made of.
std::string InputsOf(const Toolchain& toolchain, const Target& target, const std::string& level,
                     const emit::OutputFile& source, const std::string& object, const std::string& common_inputs);

/// What lib<name>.objects says: by object.
struct KnownObject {
  std::string inputs, bytes;  // SHA-256
};
using KnownObjects = std::map<std::string, KnownObject>;

/// Lines that it does not understand count as not there.
KnownObjects ReadRecord(std::string_view text);
std::string RecordText(const KnownObjects& objects);

/// Copies the wanted objects of `library` into `directory`, each under its name; whether it did so for all of them.
/// Nothing is said of what the copies hold.
bool TakeObjects(const std::string& archiver, const std::string& library, const std::vector<std::string>& objects,
                 const std::string& directory);

}  // namespace plcxx::compile
