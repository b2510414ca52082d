#include "transpiler/dialects/classicladder/control/editing.h"

#include <algorithm>

#include "transpiler/dialects/classicladder/parser/parser.h"
#include "transpiler/dialects/classicladder/source/lines.h"
#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

dialects::TokenRole RoleOf(LineKind kind) {
  switch (kind) {
    case LineKind::kProject:
    case LineKind::kProjectEnd:
    case LineKind::kPart:
    case LineKind::kPartEnd:
    case LineKind::kDirective:
      return dialects::TokenRole::kKeyword;
    case LineKind::kComment:
      return dialects::TokenRole::kComment;
    case LineKind::kBlank:
    case LineKind::kData:
      return dialects::TokenRole::kNumber;
  }
  PLCXX_UNREACHABLE();
}

/// A project is written by ClassicLadder, not by hand: its lines are looked at whole.
std::vector<dialects::EditorToken> Tokens(dialects::Request& request, source::FileId file) {
  std::vector<dialects::EditorToken> tokens;
  for (const Line& line : LinesOfProject(*request.sources, file)) {
    if (line.kind != LineKind::kBlank) tokens.push_back({line.range, RoleOf(line.kind)});
  }
  return tokens;
}

std::vector<dialects::Definition> Definitions(dialects::Request& request) {
  diag::Engine unreported;
  const Program program = Parse(*request.sources, request.files, ReadSettings(request.options), unreported);
  std::vector<dialects::Definition> definitions;
  for (const auto& [number, section] : program.sections) {
    definitions.push_back({.name = section.name, .kind = dialects::DefinitionKind::kRoutine, .range = section.range});
  }
  for (const auto& [number, rung] : program.rungs) {
    source::Range range = rung.range;
    if (!rung.lines.empty()) range.end = rung.lines.back().end;
    const std::string name = rung.label.empty() ? "rung " + std::to_string(number) : std::string(rung.label);
    definitions.push_back({.name = name, .kind = dialects::DefinitionKind::kBlock, .range = range});
  }
  std::ranges::sort(definitions, {}, [](const dialects::Definition& each) { return each.range.begin; });
  return definitions;
}

std::string Key(std::string_view spelling) { return std::string(spelling); }
source::Range NamePart(source::Range range, std::string_view /*spelling*/) { return range; }
std::vector<dialects::Word> Words() { return {}; }
std::vector<dialects::ControlSignal> Signals(const dialects::Request& /*request*/) { return {}; }

}  // namespace

const dialects::Editing kEditing = {.tokens = Tokens,
                                    .definitions = Definitions,
                                    .key = Key,
                                    .name_part = NamePart,
                                    .words = Words,
                                    .signals = Signals};

}  // namespace plcxx::classicladder
