// Names of the source made safe for C++: one rule, no numbering through the file.
//
// The rule (documented for users in the README): letters, digits and '_' stay; '.' becomes '_', '@' "_at", '#' "_no",
// ''' "_q", '?' "_is", anything else '_'; runs of '_' become one; a name that does not start with a letter gets "n_"
// in front. Where the result is taken (a word of C++, a name of the generated code, another name made safe), the
// address goes after it ("PUMP_U4A8").
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace plcxx::emit::legalize {

/// The rule without the look at other names.
std::string SafeIdentifier(std::string_view name);

/// The namespace of a program: its name made safe, with "_program" where C++ or a usual header has the word.
std::string NamespaceOf(std::string_view program);

/// Of a base with numbers after it, the first one that may be free: all before it are taken, for good.
using FirstFree = std::unordered_map<std::string, uint32_t>;

/// The names that a function has given to its own.
class FunctionNames {
 public:
  bool Has(const std::string& name) const { return names_.contains(name); }
  void Take(const std::string& name) { names_.insert(name); }
  uint32_t FirstNumber(const std::string& base) const;
  /// After the name of the base with this number has been taken.
  void TakeNumber(const std::string& base, uint32_t number);

 private:
  std::unordered_set<std::string> names_;
  FirstFree first_free_;
};

class NameTable {
 public:
  /// C++ keywords, macros of the included headers, names of runtime_support and of the generated file itself are taken.
  NameTable();
  void Reserve(std::string_view name) { taken_.emplace(name); }
  /// A free identifier for `name`; `address` tells two of the same name apart.
  std::string Allocate(std::string_view name, std::string_view address);
  /// The same for a name that only these functions know: it is free there, and in the file, but others may have it.
  std::string AllocateIn(const std::vector<FunctionNames*>& functions, std::string_view name) const;

 private:
  std::unordered_set<std::string> taken_;
  FirstFree first_free_;
};

}  // namespace plcxx::emit::legalize
