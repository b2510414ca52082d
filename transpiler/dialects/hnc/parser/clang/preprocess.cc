// The preprocessor's run: all tokens of the program, and what only the preprocessor sees: macros and their uses, groups
// that are left out, includes, pragmas.
#include <clang/Lex/Lexer.h>
#include <clang/Lex/MacroInfo.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <string>
#include <unordered_map>

#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {
namespace {

constexpr unsigned kMostIncludes = 20;      // one in the other, 10.1
constexpr size_t kMostTokens = 4'000'000;   // macros that double each other end here, not in memory
constexpr size_t kMostCharacters = 65'536;  // of a token: `#` and `##` double characters, and take the square of them
constexpr std::string_view kBlanks = " \t\v\f";  // line ends within a directive are splices

bool IsWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string_view NextWord(std::string_view& text) {
  const size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  size_t end = begin;
  while (end < text.size() && IsWord(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

class Watcher : public clang::PPCallbacks {
 public:
  explicit Watcher(Session& session) : session_(session), preprocessor_(session.clang.getPreprocessor()) {}

  void FileChanged(clang::SourceLocation /*place*/, FileChangeReason reason, clang::SrcMgr::CharacteristicKind /*kind*/,
                   clang::FileID /*previous*/) override {
    if (reason == ExitFile && depth_ > 0) --depth_;
    if (reason != EnterFile) return;
    auto* lexer = static_cast<clang::Lexer*>(preprocessor_.getCurrentFileLexer());
    if (lexer == nullptr || !lexer->getFileID().isValid()) return;
    ++depth_;
    const auto entry = session_.sources().getFileEntryRefForID(lexer->getFileID());
    if (entry) session_.output.read.push_back(entry->getName().str());
    if (depth_ <= kMostIncludes + 1) return;
    if (!too_deep_) session_.findings().Report(last_include_, diag::HncIncludeDepth, last_include_name_);
    too_deep_ = true;
    lexer->seek(static_cast<unsigned>(lexer->getBuffer().size()), true);
  }

  void InclusionDirective(clang::SourceLocation hash, const clang::Token& /*include*/, llvm::StringRef name,
                          bool angled, clang::CharSourceRange range, clang::OptionalFileEntryRef file,
                          llvm::StringRef /*search*/, llvm::StringRef /*relative*/, const clang::Module* /*module*/,
                          bool /*imported*/, clang::SrcMgr::CharacteristicKind /*kind*/) override {
    last_include_ = {session_.places.Of(range.getBegin()), session_.places.Of(range.getEnd())};
    if (last_include_.end <= last_include_.begin) last_include_ = session_.places.OfToken(range.getBegin());
    last_include_name_ = name.str();
    if (file) return;
    const bool in_main = session_.sources().isInMainFile(hash);
    session_.output.missing.push_back({name.str(), last_include_, !angled, in_main});
  }

  void MacroDefined(const clang::Token& name, const clang::MacroDirective* macro) override {
    if (session_.places.InProduct(name.getLocation())) return;
    NoteName(name);
    const clang::MacroDirective* before = macro->getPrevious();
    const bool defined = before != nullptr && before->getKind() == clang::MacroDirective::MD_Define;
    if (defined && !IsSame(*before->getMacroInfo(), *macro->getMacroInfo())) {
      const source::Range other = session_.places.OfToken(before->getMacroInfo()->getDefinitionLoc());
      Finding& finding = session_.findings().Report(session_.places.OfToken(name.getLocation()),
                                                    diag::HncMacroRedefined, name.getIdentifierInfo()->getName());
      if (other.begin != 0) finding.notes.push_back({other, "the other one is here"});
    }
    IdOf(*macro->getMacroInfo(), *name.getIdentifierInfo());
  }

  void MacroExpands(const clang::Token& name, const clang::MacroDefinition& macro, clang::SourceRange range,
                    const clang::MacroArgs* /*arguments*/) override {
    if (name.getLocation().isMacroID() || session_.places.InProduct(name.getLocation())) return;
    const clang::MacroInfo* info = macro.getMacroInfo();
    if (info == nullptr) return;
    if (info->isBuiltinMacro()) {  // __LINE__ is another one where lines were added in front of it
      session_.output.builtin_uses.push_back(session_.places.Of(range).begin);
      return;
    }
    const MacroId id = IdOf(*info, *name.getIdentifierInfo());
    const source::Range place = session_.places.Of(range);
    session_.macro_uses.Add(place.begin, session_.output.unit.macro_uses.Add({id, place}));
  }

  void SourceRangeSkipped(clang::SourceRange range, clang::SourceLocation /*endif*/) override {
    session_.output.left_out.push_back({session_.places.Of(range.getBegin()), session_.places.Of(range.getEnd())});
  }

  void MacroUndefined(const clang::Token& name, const clang::MacroDefinition& /*macro*/,
                      const clang::MacroDirective* /*undefined*/) override {
    NoteName(name);
  }
  void Defined(const clang::Token& name, const clang::MacroDefinition& /*macro*/,
               clang::SourceRange /*range*/) override {
    NoteName(name);
  }
  void Ifdef(clang::SourceLocation /*place*/, const clang::Token& name,
             const clang::MacroDefinition& /*macro*/) override {
    NoteName(name);
  }
  void Ifndef(clang::SourceLocation /*place*/, const clang::Token& name,
              const clang::MacroDefinition& /*macro*/) override {
    NoteName(name);
  }

  void PragmaDirective(clang::SourceLocation place, clang::PragmaIntroducerKind introducer) override;

  /// The uses of macros in a body that the text does not have.
  void PassElided(uint32_t index) {
    const KeptBodies& kept = *session_.input.kept;
    const ElidedBody& elided = kept.elided[index];
    const FunctionBody& body = (*kept.bodies)[elided.body];
    const source::Offset distance = elided.inside.begin - body.inside.begin;
    Unit& unit = session_.output.unit;
    // The files are opened while they are read.
    session_.elided_uses.resize(kept.elided.size(), Session::kNotElided);
    session_.elided_uses[index] = unit.macro_uses.size();
    for (uint32_t i = 0; i < body.macro_uses.count; ++i) {
      const MacroUse& use = kept.unit->macro_uses[MacroUseId(body.macro_uses.first + i)];
      const clang::IdentifierInfo* name = preprocessor_.getIdentifierInfo(kept.unit->macros[use.macro].name);
      const clang::MacroInfo* info = preprocessor_.getMacroInfo(name);
      if (info == nullptr) {
        session_.output.kept_fits = false;
        return;
      }
      unit.macro_uses.Add({IdOf(*info, *name), {use.range.begin + distance, use.range.end + distance}});
    }
  }

 private:
  void NoteName(const clang::Token& name) {
    session_.NoteName(name.getIdentifierInfo()->getName().str(), name.getLocation());
  }
  void ReadPragma(clang::SourceLocation place);
  /// The same parameters and the same tokens, however they are spaced.
  bool IsSame(const clang::MacroInfo& a, const clang::MacroInfo& b) const {
    const bool same_kind = a.isFunctionLike() == b.isFunctionLike() && a.isVariadic() == b.isVariadic();
    if (!same_kind || !std::ranges::equal(a.params(), b.params())) return false;
    return std::ranges::equal(a.tokens(), b.tokens(), [&](const clang::Token& x, const clang::Token& y) {
      return x.getKind() == y.getKind() && preprocessor_.getSpelling(x) == preprocessor_.getSpelling(y);
    });
  }
  MacroId IdOf(const clang::MacroInfo& info, const clang::IdentifierInfo& name) {
    const auto known = ids_.find(&info);
    if (known != ids_.end()) return known->second;
    const bool system = session_.places.InProduct(info.getDefinitionLoc());
    const MacroId id = session_.output.unit.macros.Add(
        {.name = name.getName().str(),
         .has_parameters = info.isFunctionLike(),
         .is_system = system,
         .range = system ? source::Range{} : session_.places.OfToken(info.getDefinitionLoc())});
    ids_.emplace(&info, id);
    return id;
  }

  Session& session_;
  clang::Preprocessor& preprocessor_;
  unsigned depth_ = 0;  // the main source is 1
  bool too_deep_ = false;
  source::Range last_include_;
  std::string last_include_name_;
  std::unordered_map<const clang::MacroInfo*, MacroId> ids_;  // only asked
};

/// All that a pragma does is done here: Clang has meanings of its own for many of them.
void Watcher::PragmaDirective(clang::SourceLocation place, clang::PragmaIntroducerKind /*introducer*/) {
  ReadPragma(place);
  preprocessor_.DiscardUntilEndOfDirective();
}

void Watcher::ReadPragma(clang::SourceLocation place) {
  const source::Range range = session_.places.OfToken(place);
  const auto [file, offset] = session_.sources().getDecomposedExpansionLoc(place);
  std::string_view line = session_.sources().getBufferData(file).substr(offset);
  size_t end = line.find('\n');
  while (end != std::string_view::npos && end > 0 && line[end - 1] == '\\') end = line.find('\n', end + 1);
  line = line.substr(0, end);
  const source::Range all{range.begin, session_.places.Of(place.getLocWithOffset(static_cast<int>(line.size())))};
  line.remove_prefix(std::min<size_t>(line.size(), 1));  // the '#'
  NextWord(line);                                        // pragma
  const std::string word(NextWord(line));
  for (const char* known : {"inline", "argsused", "warn", "option", "hdrfile", "hdrstop", "saveregs"}) {
    if (word == known) return;
  }
  if (word == "startup" || word == "exit") {
    session_.findings().Report(all, diag::HncPragma, word);
    return;
  }
  if (word != "plcxx" || NextWord(line) != "loop_bound") {
    session_.findings().Report(all, diag::HncWithoutMeaning, word.empty() ? "#pragma" : "#pragma " + word);
    return;
  }
  const size_t open = line.find('(');
  std::string_view number = open == std::string_view::npos ? std::string_view() : line.substr(open + 1);
  number = NextWord(number);
  uint32_t rounds = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), rounds);
  if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || rounds == 0 || rounds > 65535) {
    session_.findings().Report(all, diag::HncPragma, "plcxx loop_bound: the bound is a number from 1 to 65535");
    return;
  }
  session_.loop_bounds.push_back({rounds, all});
}

/// Ends the run at a number of tokens, or at a token that macros made too long. What is in a macro's arguments counts,
/// too: an argument is expanded completely before the macro that gets it, so `M(M(M(x)))` doubles while one token is
/// read.
class Limit {
 public:
  explicit Limit(Session& session) : session_(session), preprocessor_(session.clang.getPreprocessor()) {
    preprocessor_.setPreprocessToken(true);
    preprocessor_.setTokenWatcher([this](const clang::Token& token) { Count(token); });
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  size_t tokens() const { return tokens_; }
  ~Limit() {
    preprocessor_.setPreprocessToken(false);
    preprocessor_.setTokenWatcher(nullptr);
  }

 private:
  void Count(const clang::Token& token) {
    ++tokens_;
    if (token.is(clang::tok::numeric_constant) && preprocessor_.isParsingIfOrElifDirective()) LeaveOutSuffix(token);
    const bool too_long =
        !token.isAnnotation() && token.getLength() > kMostCharacters && token.getLocation().isMacroID();
    if (too_long) Stop(token, "macros make a token of more than " + std::to_string(kMostCharacters) + " characters");
    if (tokens_ > kMostTokens) {
      const std::string_view what =
          token.getLocation().isMacroID() ? "macros expand to" : "the files have, with their headers,";
      Stop(token, std::string(what) + " more than " + std::to_string(kMostTokens) + " tokens");
    }
    if (!stopped_) return;
    // From here on every token is the last one: each argument that is being expanded ends at once, and then the file.
    // A directive still ends where its line does.
    if (token.isNot(clang::tok::eod)) const_cast<clang::Token&>(token).setKind(clang::tok::eof);
  }

  /// #if computes in signed long (2.7); Clang would compute with what is written as unsigned in its unsigned type.
  void LeaveOutSuffix(const clang::Token& token) const {
    const std::string text = preprocessor_.getSpelling(token);
    std::string suffix = text.substr(text.find_last_not_of("uUlL") + 1);
    std::ranges::transform(suffix, suffix.begin(), [](char c) { return c == 'U' || c == 'u' ? 'u' : 'l'; });
    if (suffix != "u" && suffix != "ul" && suffix != "lu") return;
    preprocessor_.CreateString(text.substr(0, text.size() - suffix.size()), const_cast<clang::Token&>(token),
                               token.getLocation(), token.getLocation());
  }

  void Stop(const clang::Token& token, const std::string& why) {
    if (stopped_) return;
    session_.findings().Report(session_.places.OfToken(token.getLocation()), diag::HncPreprocessor, why);
    session_.stopped = stopped_ = true;
  }

  Session& session_;
  clang::Preprocessor& preprocessor_;
  size_t tokens_ = 0;
  bool stopped_ = false;
};

}  // namespace

uint32_t Session::ElidedAt(source::Offset brace) const {
  if (input.kept == nullptr || brace == 0) return kNotElided;
  const std::vector<ElidedBody>& elided = input.kept->elided;
  const auto at =
      std::ranges::lower_bound(elided, brace + 1, {}, [](const ElidedBody& body) { return body.inside.begin; });
  if (at == elided.end() || at->inside.begin != brace + 1) return kNotElided;
  return static_cast<uint32_t>(std::distance(elided.begin(), at));
}

void Preprocess(Session& session) {
  clang::Preprocessor& preprocessor = session.clang.getPreprocessor();
  auto made = std::make_unique<Watcher>(session);
  Watcher& watcher = *made;
  preprocessor.addPPCallbacks(std::move(made));
  preprocessor.setPragmasEnabled(false);  // the watcher reads them
  preprocessor.EnterMainSourceFile();
  const Limit limit(session);
  // As many as bytes where no macro makes more of them; what is not used costs nothing.
  const size_t bytes = session.sources().getBufferData(session.sources().getMainFileID()).size();
  session.tokens.reserve(std::min(bytes, kMostTokens));
  clang::Token token;
  do {
    preprocessor.Lex(token);
    session.tokens.push_back(token);
    if (session.input.kept == nullptr || token.isNot(clang::tok::l_brace) || token.getLocation().isMacroID()) continue;
    const uint32_t elided = session.ElidedAt(session.places.Of(token.getLocation()));
    if (elided != Session::kNotElided) watcher.PassElided(elided);
  } while (token.isNot(clang::tok::eof));
  session.macro_uses.Sort();
  session.output.token_count = limit.tokens();
}

}  // namespace plcxx::hnc
