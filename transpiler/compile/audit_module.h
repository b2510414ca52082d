// What the tool and the module that reads objects (audit/, the only code here that includes LLVM) tell each other.
#pragma once

#include <string>
#include <string_view>

#include "transpiler/compile/object_facts.h"

namespace plcxx::compile {

struct ObjectRequest {
  std::string_view bytes;      // of the object file
  std::string_view processor;  // of LLVM's scheduling models; "native": a plain one of the object's architecture
};

using ReadObjectFunction = void (*)(const ObjectRequest& request, ObjectFacts& facts);
inline constexpr const char* kReadObjectSymbol = "plcxx_read_object";

/// None, with the reason in words, when this installation has no module. Loads it once.
ReadObjectFunction LoadObjectReader(std::string& reason);

}  // namespace plcxx::compile
