// Directives (specification 9): SLOWDIV, CHANNELS, OPTION.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class DirectiveReader : private StatementReader {
 public:
  using StatementReader::StatementReader;

  void ReadDirectives(std::span<const DirectiveLine> directives);

 private:
  void ReadDirective(const Line& line);
  void ReadNumberDirective(std::string_view word);
  void ReadOption();

  std::set<std::string, std::less<>> given_;  // in capitals
};

}  // namespace plcxx::host50
