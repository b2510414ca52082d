// Reading the sources of a program: paths, standard input, the dialect that says how they are read.
//
// In: a request. Out: a Compilation with its files, or the diagnostics that say why not. Not its job: phases.
#pragma once

#include <string>

#include "transpiler/compilation/compilation.h"

namespace plcxx::compilation {

/// Chooses the dialect, loads every source and makes the loader for files that options name.
/// What is wrong is reported; `wrong_use` tells faults of the command line from unreadable files.
void LoadSources(const CompilationRequest& request, Compilation& compilation);

/// The dialect that LoadSources would choose; none when it cannot be told. Reads no standard input.
const dialects::Dialect* DialectOf(const CompilationRequest& request);

/// Of every file read: bytes that its encoding does not define, and text behind its end mark.
void ReportUnread(Compilation& compilation);

/// `path` as it has to be opened from the current directory.
std::string FromBase(const std::string& base_directory, const std::string& path);

}  // namespace plcxx::compilation
