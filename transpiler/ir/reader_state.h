// What the reader's files share: the lines as tokens, the names known so far, and the first error.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/text_format.h"

namespace plcxx::ir {

struct Reader {
  struct Line {
    uint32_t number;
    std::vector<text::Token> tokens;
  };
  template <class IdType>
  using Names = std::unordered_map<std::string, IdType>;  // for lookups only, never iterated

  Program program;
  std::vector<Line> lines;
  size_t line = 0;                 // the current one
  size_t token = 0;                // the next one of the current line
  std::optional<ReadError> error;  // the first one; everything after it is skipped

  Names<SpaceId> spaces;
  Names<StateId> states;
  Names<PlaceId> places;
  Names<HostFunctionId> host_functions;
  Names<TextId> texts;
  Names<StatementId> statements;
  Names<RoutineId> routines;
  std::vector<std::pair<RoutineId, size_t>> bodies;  // a routine's head line

  // --- the current line ---
  void Fail(std::string message);
  bool AtEnd() const { return error || token == lines[line].tokens.size(); }
  /// The next token is this word or punctuation: takes it.
  bool Accept(std::string_view wanted);
  void Expect(std::string_view wanted);
  void ExpectEnd();
  /// A word or a string; empty after an error.
  std::string Name();
  bool AtString() const;
  uint64_t Number();
  uint32_t Number32() { return static_cast<uint32_t>(Number()); }
  Type TypeName();
  /// The index of the next word in a table of spellings; 0 after an error.
  size_t OneOf(std::span<const std::string_view> spellings, std::string_view what);

  template <class IdType>
  IdType Known(const Names<IdType>& names, std::string_view what) {
    const std::string name = Name();
    if (error) return {};
    const auto found = names.find(name);
    if (found == names.end()) Fail("unknown " + std::string(what) + " '" + name + "'");
    return found == names.end() ? IdType() : found->second;
  }
  template <class IdType>
  void Declare(Names<IdType>& names, const std::string& name, IdType id, std::string_view what) {
    if (!error && !names.emplace(name, id).second) Fail(std::string(what) + " '" + name + "' is declared twice");
  }

  // --- reader_declarations.cc ---
  void ReadDeclaration(std::string_view keyword);
  void ReadScheduleEntry();
  StatementId DeclareStatement(const std::string& name);

  // --- reader_routines.cc ---
  void ReadBody(RoutineId routine);
};

}  // namespace plcxx::ir
