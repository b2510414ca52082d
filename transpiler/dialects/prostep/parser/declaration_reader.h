// DDB, DDW, DDD, DMF, DM, DT (specification 9).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/parser/comment_reader.h"
#include "transpiler/dialects/prostep/parser/line_reader.h"

namespace plcxx::prostep {

class DeclarationReader : private LineReader {
 public:
  DeclarationReader(Parsing& parsing, CommentReader& comments) : LineReader(parsing), comments_(comments) {}

  void TakeDeclaration(const LexedFile& lexed, const Line& line);

 private:
  void DeclareData(std::string_view word, const std::vector<Token>& tokens, source::Range range, Span comments);
  void CheckIoCount(const DataDeclaration& declared, std::string_view text, source::Range range);
  void WarnOfOverlap(const DataDeclaration& declared, std::string_view text);
  void DeclareMFunction(const std::vector<Token>& tokens, source::Range range, Span comments);
  bool TakeSwitch(const Token& token, std::string_view name, MFunction& function, std::set<char>& seen);
  void WarnOfSharedBits(const MFunction& function);
  void DeclareText(std::string_view word, const std::vector<Token>& tokens, source::Range range, Span comments);
  /// The declaration's number between `first` and `last`; none when it is wrong (reported).
  std::optional<uint8_t> DeclarationNumber(std::string_view word, const Token& number, uint32_t first, uint32_t last);
  /// False when the number has been declared before (reported).
  bool IsFirst(std::map<uint8_t, source::Range>& declared, std::string_view name, uint8_t number, source::Range range);

  CommentReader& comments_;
  std::map<uint8_t, source::Range> m_functions_, messages_, menu_texts_;
  std::array<uint32_t, kFirstKeptByte> data_owner_{};  // index of the declaration + 1
};

}  // namespace plcxx::prostep
