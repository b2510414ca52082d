// Macros (specification 9.7): the text of a call's lines from the text of the definition.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/technol/machine/symbols.h"
#include "transpiler/source/source.h"

namespace plcxx::technol {

constexpr size_t kExpandedLineBytes = 64 * 1024;  // a longer line is refused, as in a file
constexpr uint32_t kExpandedLines = 1'000'000;    // of all calls together

struct MacroLine {
  std::string_view text;
  source::Range range;
};

struct Macro {
  SymbolId symbol;
  std::string name;
  source::Range range;
  bool faulty = false;
  bool in_body = false;                  // a line that is no LOCAL has been read
  std::optional<source::Range> foreign;  // first word of the first line that no macro has: ENDM may be missing
  std::vector<std::string> parameters;   // folded as names are
  std::vector<std::string> locals;       //
  std::vector<MacroLine> lines;
};

/// The arguments in `text`, the rest of a call's line: separated by commas outside brackets and quotes, without blanks
/// at their ends. None in a blank text.
std::vector<std::string_view> SplitArguments(std::string_view text);

/// One line with its parameters replaced, its local names made those of expansion `number`, and its comment left out.
/// `fold` makes names comparable.
std::string Expand(std::string_view line, const Macro& macro, const std::vector<std::string_view>& arguments,
                   uint32_t number, const std::function<std::string(std::string_view)>& fold);

/// The name that a program's author wrote: without what makes a local name unique.
std::string_view WrittenName(std::string_view name);

}  // namespace plcxx::technol
