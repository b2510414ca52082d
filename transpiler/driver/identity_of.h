// What a program's identity is made from: see transpiler/identity/identity.h.
#pragma once

#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/identity/identity.h"

namespace plcxx::driver {

/// Sources: names without their folders and texts of all files that were read, in their order. Options: dialect, --set,
/// -D and -U. Generated: names and texts of what ends in .hpp and .cpp. Paths, encodings and dates are in none of them.
identity::Identity IdentityOf(const compilation::Compilation& compilation,
                              const std::vector<emit::OutputFile>& generated);

/// The constant at the end of NAME.cpp, which each program has.
void AddIdentity(const identity::Identity& identity, const std::string& name, std::vector<emit::OutputFile>& files);

}  // namespace plcxx::driver
