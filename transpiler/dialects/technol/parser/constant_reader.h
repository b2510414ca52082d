// Definitions of constants (specification 9.1): EQUI and EQU for good, '=' until the next one.
#pragma once

#include <set>
#include <span>

#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

class ConstantReader : private StatementReader {
 public:
  ConstantReader(Parsing& parsing, CommentReader& comments) : StatementReader(parsing), comments_(comments) {}

  void ReadEqui(const Statement& statement);
  void ReadEqu(const Statement& statement);
  void ReadAssignment(const Statement& statement);

 private:
  void DefineConstant(const Token& name, std::span<const Token> expression);
  void AssignConstant(const Token& name, std::span<const Token> expression);
  /// The first comments are those of the constant.
  void SetComments(const Token& name, const Statement& statement);

  CommentReader& comments_;
  std::set<SymbolId> assigned_;  // defined by '='
};

}  // namespace plcxx::technol
