// What C++ calls a function of an object or of a module.
#pragma once

#include <string>

namespace plcxx::prove::verify::llvm_ir {

/// With its namespaces and without parameters: "lathe::fast", also of "lathe::fast(State&) [clone .2]". A function
/// inside another one has a name of its own. Several symbols may have one name: functions that are overloaded, and
/// files' own functions.
std::string NameInSource(const std::string& symbol);

}  // namespace plcxx::prove::verify::llvm_ir
