// What is known of the names of a program: for maps, reports, and for those who name a location (specification 5.7).
#pragma once

#include <string>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Documentation : Context {
 public:
  explicit Documentation(const Context& context) : Context(context) {}

  void Add();

 private:
  void AddSymbols();
  /// The numbers of all ESETs, with where they are (9.5).
  void AddErrors();
  /// A comment without its ';' and the strokes of a frame.
  std::string CommentOf(const Symbol& symbol) const;
};

}  // namespace plcxx::technol
