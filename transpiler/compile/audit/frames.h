// The stack that each function's frame takes, from the frame descriptions of the object (.debug_frame).
#pragma once

#include <llvm/DebugInfo/DWARF/DWARFContext.h>
#include <llvm/Object/ELFObjectFile.h>

#include <cstdint>
#include <map>
#include <utility>

namespace plcxx::compile::audit {

struct Frame {
  uint64_t bytes = 0;
  bool known = true;  // false: it is not told relative to the stack pointer
};

/// By section index and address of the function.
using Frames = std::map<std::pair<uint64_t, uint64_t>, Frame>;

Frames ReadFrames(const llvm::object::ELFObjectFileBase& object, llvm::DWARFContext& context, uint64_t stack_pointer);

}  // namespace plcxx::compile::audit
