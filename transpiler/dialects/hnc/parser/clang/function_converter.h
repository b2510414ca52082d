// Functions: what they are, what may not be declared, their bodies (specification 4.1, 6.4, 9.4).
#pragma once

#include <unordered_map>

#include "transpiler/dialects/hnc/parser/clang/declared_type_checker.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/type_converter.h"

namespace plcxx::hnc {

class BodyKeeper;
class VariableConverter;

class FunctionConverter : private NodeConverter {
 public:
  FunctionConverter(Conversion& conversion, TypeConverter& types, DeclaredTypeChecker& checker,
                    VariableConverter& variables, BodyKeeper& bodies)
      : NodeConverter(conversion), types_(types), checker_(checker), variables_(variables), bodies_(bodies) {}

  FunctionId FunctionOf(const clang::FunctionDecl* function);
  void CheckFunction(const clang::FunctionDecl* function);
  void Define(const clang::FunctionDecl* function);

 private:
  void CheckEntry(const clang::FunctionDecl* function);

  TypeConverter& types_;
  DeclaredTypeChecker& checker_;
  VariableConverter& variables_;
  struct Known {
    FunctionId id;
    uint32_t noted = 0;  // by which body last
  };
  void Note(const clang::FunctionDecl* function, Known& known);

  BodyKeeper& bodies_;
  std::unordered_map<const clang::FunctionDecl*, Known> functions_;  // only asked
};

}  // namespace plcxx::hnc
