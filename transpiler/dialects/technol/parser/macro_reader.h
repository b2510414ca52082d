// Definitions of macros, and the lines that their calls become (specification 9.7).
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/technol/parser/code_reader.h"
#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/macros.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

/// A call whose lines are being read.
struct MacroCall {
  const Macro& macro;
  std::vector<std::string_view> arguments;
  ExpansionId outer;      // of the line with the call
  source::Range range{};  // of the outermost call, which is in a file
  uint32_t number = 0;    // unlike that of any other call
  size_t next = 0;        // line of the macro
};

class MacroReader : private StatementReader {
 public:
  MacroReader(Parsing& parsing, CommentReader& comments, CodeReader& code)
      : StatementReader(parsing), comments_(comments), code_(code) {}

  /// name MACRO [parameters]
  void OpenMacro(const Statement& statement);
  bool IsOpen() const { return open_.has_value(); }
  /// A line between MACRO and ENDM: kept as it is.
  void ReadLine(std::string_view text, std::span<const Token> tokens, const LinePlace& place);
  /// The file ends inside of a macro.
  void LeaveOpenMacro();

  /// Null when the symbol is no macro that is complete.
  const Macro* Find(SymbolId symbol) const;
  /// The statement is a call; none when it is wrong (reported).
  std::optional<MacroCall> BeginCall(const Statement& statement, const Macro& called);
  /// The next line of the call, which belongs to an expansion of its own; none after the last one.
  std::optional<std::string_view> ExpandNextLine(MacroCall& call);
  void EndCall(const MacroCall& call);

 private:
  /// The macro is complete.
  void Close();

  CommentReader& comments_;
  CodeReader& code_;
  std::optional<Macro> open_;
  std::unordered_map<SymbolId, Macro> macros_;
  uint32_t depth_ = 0;  // of calls
  uint32_t line_count_ = 0;
  uint32_t call_count_ = 0;
  bool full_ = false;              // too many lines: reported, no macro is expanded any more
  std::deque<std::string> texts_;  // of all expanded lines: tokens refer to them
};

}  // namespace plcxx::technol
