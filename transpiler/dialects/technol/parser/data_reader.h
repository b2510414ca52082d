// Allocations in data blocks (specification 9.2): cells, bits of a byte, instances of structures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"
#include "transpiler/dialects/technol/parser/structure_reader.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

class DataReader : private StatementReader {
 public:
  DataReader(Parsing& parsing, CommentReader& comments, const StructureReader& structures)
      : StatementReader(parsing), comments_(comments), structures_(structures) {}

  /// `[name] DB ...`: the directive is word number `directive`.
  void ReadAllocation(const Statement& statement, const Token* name, size_t directive);
  /// [name] STRUCTURE <...> or [name] STRUCTURE n DUP (<>); the structure is word number `structure`.
  void ReadInstance(const Statement& statement, const Token* name, size_t structure);

 private:
  /// Reports a statement outside of data, whose name counts as defined.
  bool IsDataPlace(const Statement& statement, const Token* name);
  void ReserveBytes(const Statement& statement, const Token* name, std::span<const Token> words);
  void ReadBits(const Statement& statement, size_t directive);
  void DefineBits(const Statement& statement, std::span<const Token* const> names);
  void ReadFields(TokenReader& reader, const Structure& structure, std::vector<uint8_t>& bytes);
  bool ReadField(TokenReader& reader, const StructureField& field, std::vector<uint8_t>& instance);
  void ReadCopies(const Statement& statement, TokenReader& reader, const Structure& structure,
                  std::vector<uint8_t>& bytes);
  void ReportSyntax(const TokenReader& reader, std::string_view expected);
  void DefineCell(const Statement& statement, const Token* name, uint8_t width, std::span<const uint8_t> bytes);

  CommentReader& comments_;
  const StructureReader& structures_;
};

}  // namespace plcxx::technol
