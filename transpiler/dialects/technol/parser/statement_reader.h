// What all readers of the parser's first half share: the files on their way to a program, and where in it they are.
//
// Lines are read one after the other (FileReader): data, constants, structures, macros and units are complete then, and
// all names are known. The operands of instructions are read afterwards (operand_reader.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/technol/parser/parsing_context.h"

namespace plcxx::technol {

/// A line without its comment.
struct Statement {
  const Token* label = nullptr;
  std::span<const Token> words;    // after the label and its colon; may be empty
  const Token* comment = nullptr;  // of a line of a file
  source::Range range;             // of `words`, or of the label alone
  std::string upper;               // the first word in capitals; empty when it is no word

  const Token& first() const { return words.front(); }
};

/// Where the parser is.
struct Reading {
  source::FileId file;
  std::vector<std::string> including;  // identities of the files that are open
  bool in_data = false;
  UnitId module, mechanism;  // open
  bool lost_lines = false;   // a macro without its ENDM has taken the rest of a file
};

/// Files on their way to a program.
struct Parsing {
  dialects::Request& request;
  ParsingContext context;
  source::FileId last_source{};  // of the command line; of tables alone the last of them
  Reading now{};
};

/// Word number `index` in capitals; empty when there is none.
std::string UpperWord(std::span<const Token> words, size_t index);

/// What a part of the parser sees. Refers to the parsing.
class StatementReader {
 public:
  explicit StatementReader(Parsing& parsing) : context_(parsing.context), now_(parsing.now) {}

 protected:
  UnitId CurrentUnit() const { return now_.mechanism.valid() ? now_.mechanism : now_.module; }
  /// Reports a statement in an include file that belongs to the program alone.
  bool IsOutside(const Statement& statement);
  /// Instructions and labels: not in an include file, not in data.
  bool IsCodePlace(const Statement& statement);
  /// Nothing may follow the first `words` words.
  bool ExpectEnd(const Statement& statement, size_t words);
  /// With strict evidence: `word` is the specification's own completion of the manual.
  void WarnOfCompletion(const Token& word);

  ParsingContext& context_;
  Reading& now_;
};

}  // namespace plcxx::technol
