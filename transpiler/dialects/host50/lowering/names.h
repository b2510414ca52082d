// What places and instances are called: by the program's symbols where there are any.
#pragma once

#include <string>
#include <unordered_map>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Names : Context {
 public:
  explicit Names(const Context& context);

  /// "PUMP", "Q0", "T_RUN.Q": as the source calls it, by its symbol if there is one.
  std::string Spelled(const Address& address) const;
  /// The same, by the address where the symbol has characters that a name in C++ does not.
  std::string InCode(const Address& address) const;

 private:
  std::unordered_map<uint32_t, SymbolId> symbols_;  // by KeyOf: the one that names the address
};

}  // namespace plcxx::host50
