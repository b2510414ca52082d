// The phases that are printed: more than `plcxx print` has, for a text of each decision that is made.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "transpiler/compilation/compilation.h"

namespace plcxx::printed {

/// A program in a language, or as IR.
struct Input {
  compilation::CompilationRequest request;
  std::string ir;  // empty: it is in a language
  /// Made when a phase asks for it first; as the program is emitted, or with the errors that keep it from that.
  mutable std::shared_ptr<compilation::Compilation> optimized = {};
};

/// `beside`: the phase whose lines it does not repeat, whatever numbers its values have.
struct Phase {
  std::string_view name;
  std::string (*print)(const Input& input);
  std::string_view beside;
};
std::span<const Phase> Phases();

/// Not among them, for it is two in one compilation: all messages, and without errors the program in its structure.
std::string SaidOf(const Input& input);

}  // namespace plcxx::printed
