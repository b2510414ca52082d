// Definitions of structures (specification 9.3), those of the control included.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

struct StructureField {
  uint32_t offset = 0;
  uint8_t width = 8;
  uint32_t bytes = 0;
};
struct Structure {
  SymbolId symbol;
  std::string name;
  source::Range range;
  std::vector<StructureField> fields;
  std::vector<uint8_t> initial;
  bool has_wrong_line = false;  // one that is neither a field nor the end
};

class StructureReader : private StatementReader {
 public:
  StructureReader(Parsing& parsing, CommentReader& comments) : StatementReader(parsing), comments_(comments) {}

  /// TAB_TECHNOLS and SET_NCTABS (5.4, 5.5): their fields are those of the areas.
  void AddControlStructures();

  void OpenStructure(const Statement& statement);
  bool IsOpen() const { return open_.has_value(); }
  /// A line after the opening one; false: it belongs to something else, and the structure was ended (reported).
  bool ReadLine(const Statement& statement);
  /// name ENDS
  void CloseStructure(const Statement& statement);
  /// A structure that is open lacks its end, which is reported at `place`.
  void LeaveOpenStructure(source::Range place);

  /// Null when the symbol is no structure that is complete.
  const Structure* Find(SymbolId symbol) const;

 private:
  /// [name] DB ...: the directive is word number `directive`.
  void ReadField(const Statement& statement, const Token* name, size_t directive);
  void DefineField(const Token& name, const StructureField& field);
  void ReportNoField(const Statement& statement);
  void FinishStructure();

  CommentReader& comments_;
  std::optional<Structure> open_;
  std::unordered_map<SymbolId, Structure> structures_;
};

}  // namespace plcxx::technol
