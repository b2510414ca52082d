// How C++ declares a host function: in the header of a program, and wherever it is defined.
#pragma once

#include <string>

#include "transpiler/ir/program.h"

namespace plcxx::emit::print {

/// "int8_t read_port(Host& host, State& m, int32_t port) noexcept". A parameter with enumerators has an enumeration of
/// its own as its type.
std::string HostFunctionHead(const ir::HostFunction& function);

}  // namespace plcxx::emit::print
