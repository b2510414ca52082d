// What the variables are called in the generated code: their symbols, or as the engine calls them.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "transpiler/dialects/classicladder/syntax/syntax.h"

namespace plcxx::classicladder {

/// By kind and number.
using VariableKey = std::pair<uint32_t, uint32_t>;

VariableKey KeyOf(const Address& address);

class Names {
 public:
  /// Symbols that two variables have, that look like another variable, or that C++ cannot spell name nothing.
  explicit Names(const Program& tree);

  std::string Of(const Address& address) const;

 private:
  std::map<VariableKey, std::string> symbols_;
};

}  // namespace plcxx::classicladder
