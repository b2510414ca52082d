// What the tool and the parser's module (parser/, the only code that includes Clang) tell each other.
//
// The module is loaded at run time and has no function of the tool: texts come in through `open`, everything that it
// finds goes out as data.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/parser/kept_bodies.h"
#include "transpiler/dialects/hnc/source/findings.h"
#include "transpiler/dialects/hnc/source/source_text.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// The folders in which the module looks for files: that of the main source, one for each -I, the product's headers.
inline constexpr std::string_view kMainFolder = "/src";
inline constexpr std::string_view kIncludeFolder = "/inc";  // with the number of the -I after it
inline constexpr std::string_view kProductFolder = "/sys";

struct ParserInput {
  std::string main_path;  // below kMainFolder
  /// The file of a path below one of the folders; null where there is none. The same path gives the same text.
  std::function<const SourceText*(const std::string& path)> open;
  /// The program's text at a place, for messages.
  std::function<std::string(source::Range)> text;
  uint32_t include_folders = 0;  // how many -I
  std::vector<dialects::MacroOption> macros;
  bool char_is_signed = true;
  bool keeps_bodies = false;         // whether ParserOutput::bodies is wanted
  const KeptBodies* kept = nullptr;  // none: all of the program is in the texts
};

/// An #include whose file does not exist.
struct MissingInclude {
  std::string name;
  source::Range range;
  bool quoted = false;
  bool in_main = false;
};

/// One token after the preprocessor, for `print tokens`.
struct TokenText {
  source::Offset place = 0;
  std::string_view kind;  // "identifier", "keyword", ...
  std::string text;
};

struct ParserOutput {
  Unit unit;
  Findings findings;
  std::vector<source::Range> left_out;  // groups of #if that do not count
  std::vector<MissingInclude> missing;
  std::vector<std::string> read;             // paths of all files that were read
  std::vector<TokenText> tokens;             // only where asked for
  std::vector<FunctionBody> bodies;          // of all definitions in their order, where asked for
  std::vector<std::string> open_names;       // declared within a body and seen beyond it
  std::vector<source::Offset> builtin_uses;  // places of uses of __LINE__ and its like
  size_t token_count = 0;                    // with those of macros' arguments
  bool can_keep = true;                      // false: something in the program forbids to take over any of its bodies
  /// Indices into KeptBodies::bodies of those whose words have come to mean something else; where there are some, the
  /// rest is worth nothing.
  std::vector<uint32_t> stale_bodies;
  bool kept_fits = true;  // false: the program is not the one of ParserInput::kept; the rest is worth nothing
  std::string bitcode;    // likewise; empty: the program has errors
  std::string compiler;   // that made it
};

/// kCode: the tree, and what Clang itself makes of the program.
enum class ParseUntil : uint8_t { kTokens, kTree, kCode };

using ParseFunction = void (*)(const ParserInput& input, ParseUntil until, ParserOutput& output);
inline constexpr const char* kParseSymbol = "plcxx_hnc_parse";

}  // namespace plcxx::hnc
