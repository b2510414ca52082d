#include "transpiler/report/ladder_pictures.h"

#include <utility>

#include "transpiler/report/ladder_drawing.h"
#include "transpiler/report/routine_title.h"
#include "transpiler/report/rows.h"

namespace plcxx::report {
namespace {

constexpr size_t kMostCaption = 100;  // bytes of a line above a rung

std::string Shortened(std::string_view text) {
  text = text.substr(0, text.find_first_of("\r\n"));
  const size_t begin = text.find_first_not_of(" \t");
  text.remove_prefix(begin == std::string_view::npos ? text.size() : begin);
  if (text.size() <= kMostCaption) return std::string(text);
  size_t end = kMostCaption;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole characters of UTF-8
  return std::string(text.substr(0, end)) + " …";
}

/// What is drawn of a ladder: items and the texts above them.
struct Captioned {
  std::vector<LadderItem> items;
  std::vector<Caption> captions;
};

void Append(const ProgramInput& input, RoutineLadder ladder, Captioned& out) {
  const ir::Routine& routine = input.program->routines[ladder.routine];
  const std::string title = RoutineTitle(routine);
  out.captions.push_back({out.items.size(), "", TextKind::kLabel});
  out.captions.push_back({out.items.size(), title, TextKind::kLabel});
  std::vector<bool> seen(input.program->statements.size());
  for (LadderItem& item : ladder.items) {
    if (item.kind == ItemKind::kStatement && item.statement.valid() && !seen[item.statement.index]) {
      seen[item.statement.index] = true;
      const ir::Statement& statement = input.program->statements[item.statement];
      for (const source::Range& comment : statement.comments) {
        out.captions.push_back({out.items.size(), Shortened(input.sources->Text(comment)), TextKind::kComment});
      }
      const std::string text = Shortened(input.sources->Text(statement.range));
      if (!text.empty()) out.captions.push_back({out.items.size(), text, TextKind::kLine});
    }
    out.items.push_back(std::move(item));
  }
}

bool HasRungs(const RoutineLadder& ladder) {
  for (const LadderItem& item : ladder.items) {
    if (item.kind != ItemKind::kStatement) return true;
  }
  return false;
}

}  // namespace

std::vector<Picture> LadderPictures(const ProgramInput& input) {
  std::vector<Picture> pictures;
  for (RoutineLadder& ladder : MakeLadders(input, MakeCrossReference(input))) {
    if (!HasRungs(ladder)) continue;
    const std::string& name = input.program->routines[ladder.routine].name;
    Captioned captioned;
    Append(input, std::move(ladder), captioned);
    pictures.push_back({name, SvgFile(Draw(captioned.items, captioned.captions), "ladder of " + name)});
  }
  return pictures;
}

std::string LadderPicture(const ProgramInput& input) {
  Captioned captioned;
  for (RoutineLadder& ladder : MakeLadders(input, MakeCrossReference(input))) {
    if (HasRungs(ladder)) Append(input, std::move(ladder), captioned);
  }
  return SvgFile(Draw(captioned.items, captioned.captions), "ladder of " + input.program->name);
}

}  // namespace plcxx::report
