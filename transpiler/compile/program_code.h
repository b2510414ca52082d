// The objects of one program together: functions of all of them with one number each, and who calls whom.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "transpiler/compile/object_facts.h"

namespace plcxx::compile {

class ProgramCode {
 public:
  explicit ProgramCode(std::vector<ObjectFacts> objects);

  uint32_t function_count() const { return static_cast<uint32_t>(places_.size()); }
  const CodeFunction& Function(uint32_t id) const { return Object(id).functions[places_[id].index]; }
  const ObjectFacts& Object(uint32_t id) const { return objects_[places_[id].object]; }
  const std::vector<ObjectFacts>& objects() const { return objects_; }
  /// As the source has it: "mill::fast(mill::State&, mill::Host&)".
  const std::string& Text(uint32_t id) const { return Object(id).symbols[Function(id).symbol].text; }
  /// As the source calls it: "mill::fast".
  std::string Name(uint32_t id) const;
  /// The function that a call of `caller` reaches; kNoFunction: none of these objects.
  uint32_t Callee(uint32_t caller, const CodeCall& call) const;
  const CodeSymbol& Symbol(uint32_t caller, const CodeCall& call) const { return Object(caller).symbols[call.symbol]; }
  /// The global function of that name in the source; kNoFunction: there is none.
  uint32_t Find(std::string_view name) const;
  /// Whether one of the objects has this symbol for the others, code or data.
  bool Defines(const std::string& symbol) const { return defined_.contains(symbol); }

 private:
  struct Place {
    uint32_t object, index;
  };
  std::vector<ObjectFacts> objects_;
  std::vector<Place> places_;
  std::unordered_set<std::string> defined_;
  std::vector<std::vector<uint32_t>> targets_;  // by object and symbol: a function
};

/// "mill::fast" of "mill::fast(mill::State&, mill::Host&) (.part.0)".
std::string NameOf(std::string_view text);

}  // namespace plcxx::compile
