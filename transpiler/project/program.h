// A program of plcxx.yaml from the keys that were read: patterns become names, paths are looked at.
#pragma once

#include <vector>

#include "transpiler/project/project.h"
#include "transpiler/project/values.h"

namespace plcxx::project {

/// `keys` are those of one program, common ones merged in; `mark` is where it begins. Errors go to the reader, whose
/// path is that of the file.
Program MakeProgram(const std::vector<NamedValue>& keys, yaml::Place mark, Reach reach, yaml::Reader& reader);

}  // namespace plcxx::project
