#include "transpiler/dialects/host50/analysis/warnings.h"

#include "transpiler/dialects/host50/analysis/resources.h"
#include "transpiler/source/characters.h"

namespace plcxx::host50 {
namespace {

class TextLengths {
 public:
  explicit TextLengths(diag::Engine& diagnostics) : diagnostics_(diagnostics) {}

  void Check(std::string_view what, std::string_view text, uint32_t most, source::Range range) {
    const size_t characters = source::CountCodePoints(text);
    if (characters <= most) return;
    diagnostics_.Report(range, diag::Host50TooLong, what, static_cast<int64_t>(characters), most);
  }

 private:
  diag::Engine& diagnostics_;
};

/// Without ';' and the blanks after it.
std::string_view TextOf(std::string_view comment) {
  comment.remove_prefix(1);
  const size_t first = comment.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : comment.substr(first);
}

}  // namespace

void CheckProgram(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  CheckEncodings(program, sources, diagnostics);
  CheckTexts(program, sources, diagnostics);
  CheckInstructions(program, sources, diagnostics);
  CheckAccesses(program, sources, diagnostics);
  CheckResources(program, diagnostics);
  if (program.faulty) return;  // what is missing may stand in a line that was not understood
  CheckAxisSignals(program, sources, diagnostics);
  CheckFlow(program, sources, diagnostics);
  CheckLayout(program, diagnostics);
}

void CheckEncodings(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  for (const source::FileId id : program.files) {
    const source::File& file = sources.Get(id);
    if (file.origin != source::EncodingOrigin::kFallback) continue;
    const auto length = static_cast<source::Offset>(sources.Line(id, 1).size());
    diagnostics.Report({file.base, file.base + length}, diag::Host50ReadAsGb18030);
  }
}

void CheckTexts(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  TextLengths lengths(diagnostics);
  for (const TitleField& field : program.title) {
    const TitleKeyInfo& key = TitleKeys()[static_cast<size_t>(field.key)];
    lengths.Check("text of " + std::string(key.name), field.text, key.most_characters, field.range);
  }
  for (const Symbol& symbol : program.symbols) {
    if (symbol.predefined) continue;
    lengths.Check("symbol", symbol.name, kMostSymbolName, symbol.name_range);
    lengths.Check("comment of a symbol", symbol.comment, kMostSymbolComment, symbol.comment_range);
  }
  for (const Section& section : program.sections) {
    if (section.kind != SectionKind::kSubroutine) continue;
    lengths.Check("name of a subroutine", section.name, kMostSubroutineName, section.name_range);
  }
  for (const Instruction& instruction : program.instructions) {
    for (uint32_t i = 0; i < instruction.comments.count; ++i) {
      const Comment& comment = program.comments[instruction.comments.first + i];
      if (comment.place != CommentPlace::kRow) continue;
      lengths.Check("row comment", TextOf(sources.Text(comment.range)), kMostRowComment, comment.range);
    }
  }
  for (const MCode& code : program.mcodes) {
    if (code.number > kLastRegularMCode) diagnostics.Report(code.range, diag::Host50MCodeAbove99, code.number);
  }
}

void CheckResources(const Program& program, diag::Engine& diagnostics) {
  for (const ResourceUse& use : ResourcesOf(program)) {
    const bool is_error = use.resource == Resource::kPrograms || use.resource == Resource::kNetworks;
    if (is_error || !use.surplus) continue;
    diagnostics.Report(*use.surplus, diag::Host50Resource, Name(use.resource), Available(use.resource));
  }
}

}  // namespace plcxx::host50
