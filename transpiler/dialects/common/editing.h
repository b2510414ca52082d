// What an editor asks of a language beyond its diagnostics: the words of a text, the names that a program defines, and
// what can be written.
//
// Each dialect fills one Editing object from its own lexer, its tree and the rows of its machine.def. Nothing here is
// reported: a text that is being typed is wrong most of the time. Not its job: which mention belongs to which name
// (transpiler/lsp/names.h), where memory lies (Dialect::locate).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/source/source.h"

namespace plcxx::dialects {

enum class TokenRole : uint8_t {
  kComment,
  kKeyword,   // what is neither an instruction nor a name: parts, declarations, directives
  kMnemonic,  // an instruction
  kFunction,  // a function of the language, or of the control
  kAddress,   // an operand that is spelled by its address
  kName,      // a word that may be somebody's name: its place and the program decide
  kMember,    // a name after a '.' or '->'
  kNumber,
  kText,
  kOperator,
};

struct EditorToken {
  source::Range range;
  TokenRole role{};
};

enum class DefinitionKind : uint8_t {
  kSignal,     // a name for memory: `address` is what it stands for
  kConstant,   //
  kVariable,   //
  kParameter,  // of a function or macro
  kLabel,      // where jumps go
  kRoutine,    // what is called, or runs by itself: a module, a subroutine, a mechanism, a function
  kBlock,      // a part of a routine: a network, a block of statements
  kMacro,      //
  kType,       // a structure
  kField,      // of a structure
};

struct Definition {
  std::string name;  // as it is spelled where it is defined
  DefinitionKind kind{};
  source::Range name_range;  // empty: nothing in the text spells it
  source::Range range;       // all of it, with its body
  source::Range scope;       // where it is known; empty: everywhere
  std::string address;       // what Dialect::locate takes; empty: it is no memory
  std::string detail;        // type, value or title, in the dialect's words
  std::string comment;       // of the author
};

/// A word that can be written, for completion and the help with operands.
struct Word {
  std::string name;
  TokenRole role{};
  std::string meaning;                  // one line; may be empty
  std::vector<std::string> parameters;  // in their order; "time", "a bit"
};

/// A signal of the control.
struct ControlSignal {
  std::string address;  // what Dialect::locate takes
  std::string name;     // the control's own
  std::string meaning;
  bool has_name_in_programs = false;  // `name` can be written instead of the address
};

struct Editing {
  /// The words of one file by place; they do not overlap.
  std::vector<EditorToken> (*tokens)(Request& request, source::FileId file) = nullptr;
  /// What the files of the request, and those that they include, define; by file, then by place.
  std::vector<Definition> (*definitions)(Request& request) = nullptr;
  /// What all spellings of one name have in common.
  std::string (*key)(std::string_view spelling) = nullptr;
  /// The part of a token of role kName that is replaced when its name changes: without marks around it.
  source::Range (*name_part)(source::Range range, std::string_view spelling) = nullptr;
  std::vector<Word> (*words)() = nullptr;
  std::vector<ControlSignal> (*signals)(const Request& request) = nullptr;
  std::string_view name_mark;  // in front of a name where it is used; empty: none
  /// What stands between an instruction and its operands, and between two of them.
  std::string_view opening = " ", separators = ",";
};

}  // namespace plcxx::dialects
