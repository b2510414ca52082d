// Bodies of functions: converted and recorded, or taken over from the run before (kept_bodies.h).
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/environment.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/type_converter.h"

namespace plcxx::hnc {

class FunctionConverter;
class StatementConverter;
class VariableConverter;

class BodyKeeper : private NodeConverter {
 public:
  BodyKeeper(Conversion& conversion, TypeConverter& types, VariableConverter& variables, FunctionConverter& functions,
             StatementConverter& statements)
      : NodeConverter(conversion),
        environment_(conversion),
        types_(types),
        variables_(variables),
        functions_(functions),
        statements_(statements) {}

  StatementId BodyOf(const clang::FunctionDecl* function);
  /// Where the names of the file level are all known. False: bodies are stale, and there is nothing to convert.
  bool CollectNames();

 private:
  StatementId Record(const clang::FunctionDecl* function, FunctionBody body, bool is_plain);
  StatementId TakeOver(const FunctionBody& body, uint32_t elided);
  /// Index into KeptBodies::elided of the function's body; kNotElided: it is in the text.
  uint32_t ElidedOf(const clang::FunctionDecl* function) const;
  void FindStaleBodies();
  void Satisfy(const Need& need);
  void TakeExpressions(const FunctionBody& body, source::Offset distance, uint32_t first_use);
  void TakeStatements(const FunctionBody& body, source::Offset distance, uint32_t first_use);
  void TakeVariable(VariableId before, source::Offset distance, ExprId first_expression, ExprId first_before);
  bool AllInside(const FunctionBody& body) const;

  Unit& Before() const { return *session_.input.kept->unit; }
  /// What the file level declares with this name; null, and a misfit: nothing, or several.
  template <class Declaration>
  const Declaration* Declared(const FileNames::ByName<Declaration>& names, const std::string& name);
  void Misfit() { session_.output.kept_fits = false; }
  TypeId TypeOf(TypeId before);
  FunctionId FunctionOf(FunctionId before);
  VariableId VariableOf(VariableId before);

  Environment environment_;
  TypeConverter& types_;
  VariableConverter& variables_;
  FunctionConverter& functions_;
  StatementConverter& statements_;
  // By id in the unit before.
  std::vector<TypeId> known_types_;
  std::vector<FunctionId> known_functions_;
  std::vector<VariableId> known_variables_;
};

}  // namespace plcxx::hnc
