// T_INCLUDE and INCLUDE (specification 9.6): which file is meant, and whether it may be read here.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "transpiler/dialects/technol/parser/code_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

struct IncludedFile {
  source::FileId file;
  std::string identity;
};

class IncludeReader : private StatementReader {
 public:
  IncludeReader(Parsing& parsing, CodeReader& code)
      : StatementReader(parsing), request_(parsing.request), code_(code) {}

  /// T_INCLUDE: the file that takes the place of the statement; none when there is none (reported).
  std::optional<IncludedFile> ReadInclude(const Statement& statement);
  /// INCLUDE x.ASH: the header is built in.
  void ReadSystemHeader(const Statement& statement);

 private:
  std::optional<std::string> FindInclude(std::string_view name, TokenKind form) const;
  bool MayInclude(std::string_view name, const std::string& path) const;
  source::FileId LoadInclude(const std::string& path, const Token& name);

  dialects::Request& request_;
  CodeReader& code_;
  std::map<std::string, source::FileId> included_;
  uint32_t count_ = 0;
};

}  // namespace plcxx::technol
