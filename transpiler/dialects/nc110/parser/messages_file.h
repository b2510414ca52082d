// Texts that the operator sees: the message file, the menu file LGCMNU and legacy MSG declarations
// (specification 9.3, 9.4, 9.7).
#pragma once

#include <bitset>
#include <optional>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

constexpr uint32_t kMostTexts = 255;
constexpr uint32_t kLongestMessage = 43;
constexpr uint32_t kLongestMenuText = 16;

struct TextTable {
  std::vector<ir::MessageText> texts;  // ascending by number
  std::bitset<kMostTexts + 1> defined;
  bool given = false;  // there is a file or a declaration at all
};

enum class TextFileKind : uint8_t { kMessages, kMenu };

/// One text per line, "colour#text"; the number of the line is the number of the text.
TextTable ReadTextFile(const source::SourceManager& sources, source::FileId file, TextFileKind kind,
                       diag::Engine& diagnostics);

/// MSG n "text" joins the table with colour 15.
void AddDeclaredMessages(const Program& tree, const source::SourceManager& sources, TextTable& table,
                         diag::Engine& diagnostics);

}  // namespace plcxx::nc110
