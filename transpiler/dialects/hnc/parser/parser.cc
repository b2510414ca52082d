#include "transpiler/dialects/hnc/parser/parser.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/parser/consequences.h"
#include "transpiler/dialects/hnc/parser/files.h"
#include "transpiler/dialects/hnc/parser/kept_program.h"
#include "transpiler/dialects/hnc/parser/module.h"
#include "transpiler/dialects/hnc/parser/module_loading.h"

namespace plcxx::hnc {
namespace {

struct Parsed {
  std::unique_ptr<ProgramFiles> files;
  ParserOutput output;
  std::string assumed_header;  // an include that was taken for the system header
};

bool IsWithin(const std::vector<source::Range>& groups, source::Offset place) {
  return std::ranges::any_of(groups, [&](source::Range group) { return group.begin <= place && place < group.end; });
}

class Run {
 public:
  explicit Run(dialects::Request& request) : request_(request), settings_(ReadSettings(request.options)) {}

  Parsed Parse(ParseUntil until) {
    Parsed parsed;
    parsed.files = std::make_unique<ProgramFiles>(request_, settings_, loaded_, nullptr);
    std::string reason;
    const ParseFunction parse = LoadParser(reason);
    if (parse == nullptr) {
      request_.diagnostics->Report({}, diag::HncNoFrontEnd, reason);
      parsed.output.unit.faulty = true;
      return parsed;
    }
    parse(InputOf(*parsed.files), until, parsed.output);
    if (IsOptionLeftOut(parsed)) {
      ignores_option_ = true;
      parsed.output = {};
      parse(InputOf(*parsed.files), until, parsed.output);
    }
    const MissingInclude* assumed = SystemHeaderAmong(parsed);
    if (assumed == nullptr) return parsed;
    // 9.1: again, with this name for the system header.
    Parsed second;
    second.assumed_header = assumed->name;
    LoadedFiles again;
    second.files = std::make_unique<ProgramFiles>(request_, settings_, again, nullptr);
    second.files->TakeForSystemHeader(assumed->name);
    parse(InputOf(*second.files), until, second.output);
    request_.diagnostics->Report(assumed->range, diag::HncAssumedSystemHeader, assumed->name);
    return second;
  }

  /// Takes over what is the same in the program before; none: it is not the same program.
  std::optional<Parsed> ParseChanged(KeptProgram& before) {
    std::vector<uint32_t> stale;
    for (size_t known = 0;; known = stale.size()) {
      std::optional<Parsed> parsed = ParseChanged(before, stale);
      if (parsed || stale.size() == known) return parsed;
    }
  }

 private:
  /// `stale`: bodies that are to be read again; where there are more of them, these come out, too.
  std::optional<Parsed> ParseChanged(KeptProgram& before, std::vector<uint32_t>& stale) {
    Reuse reuse(before, stale);
    Parsed parsed;
    parsed.files = std::make_unique<ProgramFiles>(request_, settings_, loaded_, &reuse);
    std::string reason;
    const ParseFunction parse = LoadParser(reason);
    if (parse == nullptr || !reuse.fits()) return std::nullopt;
    ParserInput input = InputOf(*parsed.files);
    input.kept = &reuse.bodies();
    parsed.output.unit = reuse.TakeSpare();
    parse(input, ParseUntil::kTree, parsed.output);
    if (IsOptionLeftOut(parsed)) return std::nullopt;
    if (!reuse.Fits(*request_.sources, parsed.files->texts(), parsed.output)) {
      // Nearly all of it twice is dearer than all of it once.
      const std::vector<uint32_t>& more = parsed.output.stale_bodies;
      if (more.size() * 2 <= reuse.elided_count()) stale.insert(stale.end(), more.begin(), more.end());
      return std::nullopt;
    }
    return parsed;
  }

  ParserInput InputOf(ProgramFiles& files) const {
    ParserInput input;
    input.main_path = files.main_name();
    input.open = [&files](const std::string& path) { return files.Open(path); };
    input.text = [sources = request_.sources](source::Range range) { return std::string(sources->Text(range)); };
    input.include_folders = static_cast<uint32_t>(request_.include_directories.size());
    input.macros = request_.macros;
    input.keeps_bodies = request_.kept != nullptr;
    input.char_is_signed =
        settings_.plain_char == CharOption::kSigned && (ignores_option_ || files.main().unsigned_char.empty());
    return input;
  }

  /// Each `#pragma option -K` is in a group of #if that does not count, which is known only now.
  bool IsOptionLeftOut(const Parsed& parsed) const {
    const std::vector<source::Offset>& places = parsed.files->main().unsigned_char;
    return !ignores_option_ && !places.empty() &&
           std::ranges::all_of(places, [&](source::Offset place) { return IsWithin(parsed.output.left_out, place); });
  }

  /// The one quoted include of the main source that cannot be found, where no system header is included.
  static const MissingInclude* SystemHeaderAmong(const Parsed& parsed) {
    if (parsed.files->system_header_read()) return nullptr;
    const MissingInclude* found = nullptr;
    std::set<std::string> names;
    for (const MissingInclude& missing : parsed.output.missing) {
      if (!missing.quoted || !missing.in_main) continue;
      names.insert(missing.name);
      if (found == nullptr) found = &missing;
    }
    return names.size() == 1 ? found : nullptr;
  }

  dialects::Request& request_;
  Settings settings_;
  LoadedFiles loaded_;
  bool ignores_option_ = false;
};

bool IsErrorOfParser(const Finding& finding) { return finding.row.severity == diag::Severity::kError; }

/// Reports what counts: nothing in groups that are left out, nothing that only follows from a fault of the text or the
/// syntax on the same line.
class Reporter {
 public:
  Reporter(const dialects::Request& request, const Parsed& parsed) : request_(request), parsed_(parsed) {}

  void Run() {
    for (const MissingInclude& missing : parsed_.output.missing) {
      request_.diagnostics->Report(missing.range, diag::HncCannotOpenInclude, missing.name);
    }
    std::vector<Finding> findings;
    for (const std::string& path : parsed_.output.read) {
      const SourceText* text = parsed_.files->Open(path);
      if (text == nullptr) continue;
      std::ranges::copy_if(text->findings.all(), std::back_inserter(findings),
                           [&](const Finding& finding) { return !IsLeftOut(finding.range); });
    }
    std::ranges::copy(parsed_.output.findings.all(), std::back_inserter(findings));
    if (!parsed_.files->system_header_read()) MergeMissingHeader(*request_.sources, findings);
    MergeMissingBrace(*request_.sources, findings);
    std::ranges::stable_sort(findings, {}, &Finding::phase);
    std::set<Line> divisions;  // a division by zero is also no constant expression
    for (const Finding& finding : findings) {
      if (finding.row.key == diag::HncDivisionByZero.row.key) divisions.insert(LineOf(finding.range));
    }
    std::set<source::Offset> conflicts;  // a name that disagrees with its header is not undefined as well
    for (const Finding& finding : findings) {
      const bool explained =
          finding.row.key == diag::HncConstantRequired.row.key && divisions.contains(LineOf(finding.range));
      const bool is_conflict = finding.row.code == diag::HncConflictingTypes.row.code;
      const bool is_undefined = finding.row.code == diag::HncUndefinedFunction.row.code;
      const bool told = (is_conflict || is_undefined) && conflicts.contains(finding.range.begin);
      if (is_conflict) conflicts.insert(finding.range.begin);
      if (!explained && !told && !Follows(finding)) Report(finding);
    }
  }

 private:
  using Line = std::pair<uint32_t, uint32_t>;  // file, line

  Line LineOf(source::Range range) const {
    const source::Position position = request_.sources->Locate(range.begin);
    return {position.file.index, position.line};
  }
  bool IsLeftOut(source::Range range) const { return IsWithin(parsed_.output.left_out, range.begin); }
  bool Follows(const Finding& finding) {
    if (!IsErrorOfParser(finding)) return false;
    const Line line = LineOf(finding.range);
    const bool follows = finding.phase != Phase::kText && faulty_lines_.contains(line);
    if (!follows && finding.phase != Phase::kMeaning) faulty_lines_.insert(line);
    return follows;
  }
  void Report(const Finding& finding) {
    diag::Diagnostic& reported = request_.diagnostics->ReportRow(finding.range, finding.row, finding.arguments);
    reported.notes = finding.notes;
    reported.fixits = finding.fixits;
  }

  const dialects::Request& request_;
  const Parsed& parsed_;
  std::set<Line> faulty_lines_;
};

bool IsOneSource(const dialects::Request& request) {
  if (request.files.size() == 1) return true;
  if (request.files.size() > 1) {
    request.diagnostics->Report({}, diag::HncOneSource, request.sources->Get(request.files[1]).path);
  }
  return false;
}

/// What the last run has left, as far as it is of use for this one.
std::unique_ptr<KeptProgram> TakeKept(dialects::Request& request) {
  if (request.kept == nullptr || *request.kept == nullptr) return nullptr;
  std::unique_ptr<dialects::Kept> kept = std::move(*request.kept);
  const auto* program = dynamic_cast<const KeptProgram*>(kept.get());
  if (program == nullptr || !program->is_complete || program->settings != SettingsOf(request)) return nullptr;
  return std::unique_ptr<KeptProgram>(static_cast<KeptProgram*>(kept.release()));
}

/// A program with a tree that was read again only in part, where that gives the same.
Parsed ParseKeeping(dialects::Request& request) {
  std::unique_ptr<KeptProgram> before = TakeKept(request);
  Run run(request);
  std::optional<Parsed> parsed;
  if (before != nullptr) parsed = run.ParseChanged(*before);
  if (!parsed) {
    before = nullptr;  // its memory, before the whole program is read
    parsed = run.Parse(ParseUntil::kTree);
  }
  if (request.kept != nullptr && parsed->assumed_header.empty()) {
    *request.kept = KeepProgram(request, parsed->files->texts(), parsed->output, before.get());
  }
  return std::move(*parsed);
}

}  // namespace

void Keep(dialects::Request& request, Unit unit) {
  if (request.kept == nullptr) return;
  if (auto* program = dynamic_cast<KeptProgram*>(request.kept->get())) {
    program->unit = std::move(unit);
    program->is_complete = true;
  }
}

Unit Parse(dialects::Request& request) {
  Unit faulty;
  faulty.faulty = true;
  if (!IsOneSource(request)) {
    if (request.kept != nullptr) request.kept->reset();
    return faulty;
  }
  Parsed parsed = ParseKeeping(request);
  Reporter(request, parsed).Run();
  Unit& unit = parsed.output.unit;
  unit.faulty = unit.faulty || request.diagnostics->HasErrors();
  std::set<uint32_t> counted;
  for (const std::string& path : parsed.output.read) {
    const SourceText* text = parsed.files->Open(path);
    if (text != nullptr && text->file.valid() && counted.insert(text->file.index).second) {
      unit.line_count += request.sources->LineCount(text->file);
    }
  }
  return std::move(parsed.output.unit);
}

CompiledUnit ParseAndCompile(dialects::Request& request) {
  Parsed parsed = Run(request).Parse(ParseUntil::kCode);
  return {std::move(parsed.output.unit), std::move(parsed.output.bitcode), std::move(parsed.output.compiler)};
}

std::string PrintTokens(dialects::Request& request) {
  if (!IsOneSource(request)) return {};
  const Parsed parsed = Run(request).Parse(ParseUntil::kTokens);
  Reporter(request, parsed).Run();
  std::string text;
  for (const TokenText& token : parsed.output.tokens) {
    text +=
        dialects::PlaceText(*request.sources, token.place) + " " + std::string(token.kind) + " " + token.text + "\n";
  }
  return text;
}

}  // namespace plcxx::hnc
