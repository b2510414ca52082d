// One header that holds a whole program, for people without a build system.
#pragma once

#include <string>
#include <vector>

#include "transpiler/emit/output_file.h"

namespace plcxx::compile {

/// <name>.hpp: the runtime that the program uses, its declarations, and its code between #ifdef <NAME>_IMPLEMENTATION
/// and #endif, so that exactly one source of the machine's project holds the code. `files` are PrintCpp's of a program
/// in one part: header and source.
emit::OutputFile Amalgamate(const std::vector<emit::OutputFile>& files, const std::string& program);

/// The macro: letters in upper case, what is no letter or digit as '_'.
std::string ImplementationMacro(const std::string& program);

}  // namespace plcxx::compile
