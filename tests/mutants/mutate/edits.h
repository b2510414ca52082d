// Changes of one file's text, which nest: what is put around an expression stays around what is put inside it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace plcxx::mutants {

class Edits {
 public:
  /// Around the bytes [begin, end). Of two that begin or end at one place, the one that came first is the outer one.
  void Wrap(unsigned begin, unsigned end, const std::string& before, const std::string& after);
  /// Instead of the bytes [begin, end), in which no other change is.
  void Replace(unsigned begin, unsigned end, const std::string& text);

  std::string Apply(const std::string& text) const;

 private:
  struct Place {
    std::string closing, opening, replacement;
    unsigned replaced = 0;
  };
  std::map<unsigned, Place> places_;  // by offset
};

}  // namespace plcxx::mutants
