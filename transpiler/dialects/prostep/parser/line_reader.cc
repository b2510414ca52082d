#include "transpiler/dialects/prostep/parser/line_reader.h"

#include <algorithm>

namespace plcxx::prostep {

bool LineReader::IsReported(const Statement& statement) const {
  const auto faulty = [](const Token& token) { return token.faulty; };
  return std::ranges::any_of(statement.labels, faulty) || std::ranges::any_of(statement.tokens, faulty);
}

}  // namespace plcxx::prostep
