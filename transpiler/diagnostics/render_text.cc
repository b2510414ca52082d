#include <algorithm>
#include <string>

#include "transpiler/diagnostics/places.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/diagnostics/snippet.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/support/check.h"
#include "transpiler/support/counted.h"

namespace plcxx::diag {
namespace {

constexpr std::string_view kBold = "\x1b[1m";
constexpr std::string_view kRed = "\x1b[1;31m";
constexpr std::string_view kMagenta = "\x1b[1;35m";
constexpr std::string_view kCyan = "\x1b[1;36m";
constexpr std::string_view kGreen = "\x1b[1;32m";
constexpr std::string_view kReset = "\x1b[0m";

constexpr size_t kGutter = 5;     // digits of a line number
constexpr uint32_t kNarrow = 20;  // a line cropped to less shows nothing
constexpr std::string_view kBar = " | ";

std::string_view ColourOf(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return kRed;
    case Severity::kWarning:
      return kMagenta;
    case Severity::kNote:
      return kCyan;
  }
  PLCXX_UNREACHABLE();
}

class TextRenderer {
 public:
  TextRenderer(const source::SourceManager& sources, const TextStyle& style) : sources_(sources), style_(style) {}

  void Add(const Diagnostic& diagnostic) {
    Head(diagnostic.range, ColourOf(diagnostic.severity), SeverityName(diagnostic.severity));
    Coloured(kBold, Escaped(diagnostic.text));
    out_ += " [" + std::string(diagnostic.row->code) + "]\n";
    SourceLine(diagnostic.range);
    if (!diagnostic.remedy.empty()) Below("help: " + Escaped(diagnostic.remedy));
    for (const FixIt& fixit : diagnostic.fixits) AddFixIt(diagnostic, fixit);
    for (const Note& note : diagnostic.notes) {
      Head(note.range, kCyan, "note");
      out_ += Escaped(note.text) + '\n';
      SourceLine(note.range);
    }
  }

  std::string Finish(std::string_view counts) {
    if (!counts.empty()) out_ += std::string(counts) + '\n';
    return std::move(out_);
  }

 private:
  /// "turret.plc:3:6: error: "
  void Head(source::Range range, std::string_view colour, std::string_view kind) {
    if (HasPlace(range)) {
      const Place place = PlaceOf(sources_, range);
      Coloured(kBold, Escaped(place.path) + ':' + LineAndColumn(place.begin) + ':');
      out_ += ' ';
    }
    Coloured(colour, std::string(kind) + ':');
    out_ += ' ';
  }

  void SourceLine(source::Range range) {
    if (!HasPlace(range)) return;
    const std::string number = std::to_string(sources_.Locate(range.begin).line);
    const uint32_t gutter = static_cast<uint32_t>(std::max(number.size(), kGutter) + kBar.size());
    const Snippet snippet = SnippetOf(sources_, range, std::max(style_.width, gutter + kNarrow) - gutter);
    std::string line =
        std::string(gutter - kBar.size() - number.size(), ' ') + number + std::string(kBar) + snippet.line;
    line.erase(line.find_last_not_of(' ') + 1);
    out_ += line + '\n' + std::string(gutter - kBar.size(), ' ') + std::string(kBar);
    const size_t blanks = snippet.marker.find('^');
    out_.append(blanks, ' ');
    Coloured(kGreen, snippet.marker.substr(blanks));
    out_ += '\n';
  }

  void AddFixIt(const Diagnostic& diagnostic, const FixIt& fixit) {
    std::string text = "fix: " + Escaped(DescriptionOf(sources_, fixit));
    if (HasPlace(fixit.range) && fixit.range.begin != diagnostic.range.begin) {
      text += " at " + LineAndColumn(sources_.Locate(fixit.range.begin));
    }
    Below(text);
  }

  void Below(const std::string& text) { out_ += std::string(kGutter + 1, ' ') + text + '\n'; }

  static std::string LineAndColumn(source::Position position) {
    return std::to_string(position.line) + ':' + std::to_string(position.column);
  }

  void Coloured(std::string_view colour, std::string_view text) {
    if (style_.colour == Colour::kOn) out_ += colour;
    out_ += text;
    if (style_.colour == Colour::kOn) out_ += kReset;
  }

  const source::SourceManager& sources_;
  const TextStyle& style_;
  std::string out_;
};

/// `count_of` gives the number for a severity.
template <class CountOf>
std::string JoinedCounts(const CountOf& count_of) {
  std::string text;
  for (const Severity severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    const size_t count = count_of(severity);
    if (count == 0) continue;
    if (!text.empty()) text += ", ";
    text += support::Counted(count, SeverityName(severity));
  }
  return text;
}

}  // namespace

std::string CountsText(std::span<const Diagnostic> diagnostics) {
  return JoinedCounts([diagnostics](Severity severity) {
    return static_cast<size_t>(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
  });
}

std::string CountsText(const Engine& diagnostics) {
  return JoinedCounts([&diagnostics](Severity severity) -> size_t {
    switch (severity) {
      case Severity::kError:
        return diagnostics.error_count();
      case Severity::kWarning:
        return diagnostics.warning_count();
      case Severity::kNote:
        return diagnostics.note_count();
    }
    PLCXX_UNREACHABLE();
  });
}

std::vector<Diagnostic> FirstOf(std::span<const Diagnostic> diagnostics, size_t most) {
  std::vector<Diagnostic> first;
  size_t errors = 0, others = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    size_t& count = diagnostic.severity == Severity::kError ? errors : others;
    if (most == 0 || ++count <= most) first.push_back(diagnostic);
  }
  return first;
}

std::string RenderText(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics,
                       const TextStyle& style) {
  TextRenderer renderer(sources, style);
  for (const Diagnostic& diagnostic : diagnostics) renderer.Add(diagnostic);
  return renderer.Finish(CountsText(diagnostics));
}

std::string RenderFirst(const source::SourceManager& sources, const Engine& diagnostics, size_t most,
                        const TextStyle& style) {
  TextRenderer renderer(sources, style);
  const std::vector<Diagnostic> shown = FirstOf(diagnostics.all(), most);
  for (const Diagnostic& diagnostic : shown) renderer.Add(diagnostic);
  const size_t all = size_t{diagnostics.error_count()} + diagnostics.warning_count() + diagnostics.note_count();
  std::string end;
  if (all > shown.size()) end = std::to_string(all - shown.size()) + " more not shown; see --max-messages\n";
  return renderer.Finish(end + CountsText(diagnostics));
}

}  // namespace plcxx::diag
