#include "transpiler/dialects/hnc/parser/kept_program.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

/// Macros that make more tokens have a limit for the whole program (preprocess.cc), far above this.
constexpr size_t kMaxTokens = 2'000'000;

/// Where two texts begin to differ, and how much behind that is the same again.
struct Difference {
  size_t begin = 0, same_end = 0;
};

Difference Compare(std::string_view a, std::string_view b) {
  const size_t shorter = std::min(a.size(), b.size());
  const auto first = std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shorter), b.begin());
  Difference difference{.begin = static_cast<size_t>(first.first - a.begin()), .same_end = 0};
  const auto rest = static_cast<std::ptrdiff_t>(shorter - difference.begin);
  const auto last = std::mismatch(a.rbegin(), a.rbegin() + rest, b.rbegin());
  difference.same_end = static_cast<size_t>(last.first - a.rbegin());
  return difference;
}

/// Bodies by place.
class BodiesByPlace {
 public:
  explicit BodiesByPlace(const std::vector<FunctionBody>& bodies) : bodies_(bodies) {
    for (uint32_t i = 0; i < bodies.size(); ++i) order_.push_back(i);
    std::ranges::sort(order_, {}, [&](uint32_t i) { return bodies[i].inside.begin; });
  }

  /// False: a file that is included twice has the same bodies twice.
  bool AreApart() const {
    for (size_t i = 0; i + 1 < order_.size(); ++i) {
      if (bodies_[order_[i]].inside.end >= bodies_[order_[i + 1]].inside.begin) return false;
    }
    return true;
  }
  /// Index of the body, with its braces, in which a place is; none: it is outside of all.
  std::optional<uint32_t> At(source::Offset place) const {
    const auto after =
        std::ranges::upper_bound(order_, place + 1, {}, [&](uint32_t i) { return bodies_[i].inside.begin; });
    if (after == order_.begin()) return std::nullopt;
    const uint32_t index = *std::prev(after);
    return place <= bodies_[index].inside.end ? std::optional(index) : std::nullopt;
  }

 private:
  const std::vector<FunctionBody>& bodies_;
  std::vector<uint32_t> order_;
};

/// Calls found(place) for each place of the texts where one of the names is a word.
template <class Found>
void ForEachMention(const source::SourceManager& sources, const std::vector<const SourceText*>& texts,
                    const std::vector<std::string>& names, Found found) {
  for (const SourceText* text : texts) {
    const std::string& written = sources.Get(text->file).text;
    for (const std::string& name : names) {
      for (size_t at = written.find(name); at != std::string::npos; at = written.find(name, at + 1)) {
        const size_t end = at + name.size();
        const bool goes_on = end < written.size() && IsWord(written[end]);
        if (!goes_on && (at == 0 || !IsWord(written[at - 1]))) found(text->base + static_cast<source::Offset>(at));
      }
    }
  }
}

/// A name that a body declares for others, too, may be put together by a macro.
bool JoinsNames(const source::SourceManager& sources, const std::vector<const SourceText*>& texts) {
  return std::ranges::any_of(
      texts, [&](const SourceText* text) { return sources.Get(text->file).text.find("##") != std::string::npos; });
}

/// What a directive in a body says is said to all that follows it.
bool HasDirective(std::string_view text, source::Range inside, source::Offset base) {
  return text.substr(inside.begin - base, inside.end - inside.begin).find('#') != std::string_view::npos;
}

/// Which uses of macros are in which body: all, in the order of their numbers.
bool FindMacroUses(const Unit& unit, const BodiesByPlace& by_place, std::vector<FunctionBody>& bodies) {
  for (FunctionBody& body : bodies) body.macro_uses = {};
  for (uint32_t i = 0; i < unit.macro_uses.size(); ++i) {
    const std::optional<uint32_t> at = by_place.At(unit.macro_uses[MacroUseId(i)].range.begin);
    if (!at) continue;
    Segment& uses = bodies[*at].macro_uses;
    if (uses.count == 0) uses.first = i;
    if (uses.first + uses.count != i) return false;
    ++uses.count;
  }
  return true;
}

/// What a tree has of large memory, without what was in it: assigned nothing, a vector keeps its memory.
void MakeSpare(Unit& used, Unit& spare) {
  const Unit none;
  spare.expressions = std::move(used.expressions);
  spare.expressions = none.expressions;
}

}  // namespace

std::string SettingsOf(const dialects::Request& request) {
  std::string all;
  const auto add = [&](std::string_view text) {
    all += text;
    all += '\0';
  };
  for (const auto& [key, value] : request.options) {
    add(key);
    add(value);
  }
  add("-I");
  for (const std::string& folder : request.include_directories) add(folder);
  add("-D");
  for (const dialects::MacroOption& macro : request.macros) {
    add(macro.name);
    add(macro.text ? "=" + *macro.text : "");
  }
  add(request.encoding ? source::Name(*request.encoding) : "");
  return all;
}

struct Reuse::Change {
  source::Offset begin = 0, end = 0;  // of what went, as a place of the run before; both 0: nothing has changed
  source::Offset grown = 0;           // unsigned, and back again: a text may have become shorter

  bool IsSome() const { return end != 0; }
  bool IsIn(source::Range inside) const { return IsSome() && inside.begin <= begin && end <= inside.end; }
};

Reuse::Reuse(KeptProgram& before, const std::vector<uint32_t>& stale)
    : before_(before), is_stale_(before.bodies.size()), expected_(before.bodies.size()) {
  kept_.unit = &before.unit;
  kept_.bodies = &before.bodies;
  for (const uint32_t i : stale) is_stale_[i] = true;
}

std::vector<uint32_t> Reuse::BodiesIn(const KeptProgram::File& file) const {
  std::vector<uint32_t> within;
  for (uint32_t i = 0; i < before_.bodies.size(); ++i) {
    const source::Range inside = before_.bodies[i].inside;
    if (inside.begin >= file.base && inside.end <= file.base + file.text.size()) within.push_back(i);
  }
  std::ranges::sort(within, {}, [&](uint32_t i) { return before_.bodies[i].inside.begin; });
  return within;
}

std::optional<source::Range> Reuse::NowAt(source::Range inside, const Change& change) {
  if (!change.IsSome() || inside.end < change.begin) return inside;  // with its '}'
  if (change.IsIn(inside)) return source::Range{inside.begin, inside.end + change.grown};
  if (inside.begin > change.end) return source::Range{inside.begin + change.grown, inside.end + change.grown};
  return std::nullopt;
}

std::optional<SourceText> Reuse::TextOf(const source::SourceManager& sources, source::FileId file) {
  const source::File& now = sources.Get(file);
  const auto known = std::ranges::find(before_.files, now.path, &KeptProgram::File::path);
  if (known == before_.files.end() || !fits_ || known->encoding != now.encoding || !now.replaced.empty()) {
    Misfit();
    return std::nullopt;
  }
  const std::string& old = known->text;
  const Difference difference = Compare(old, now.text);
  Change change;
  if (old.size() != now.text.size() || difference.begin != old.size()) {
    change = {.begin = known->base + static_cast<source::Offset>(difference.begin),
              .end = known->base + static_cast<source::Offset>(old.size() - difference.same_end),
              .grown = static_cast<source::Offset>(now.text.size() - old.size())};
  }
  bool is_outside = change.IsSome();
  std::vector<LeftOutText> parts;
  for (const uint32_t i : BodiesIn(*known)) {
    const FunctionBody& body = before_.bodies[i];
    const std::optional<source::Range> at = NowAt(body.inside, change);
    if (!at) continue;
    const source::Range inside{at->begin - known->base, at->end - known->base};
    expected_[i] = {inside.begin + now.base, inside.end + now.base};
    if (change.IsIn(body.inside)) {
      is_outside = HasDirective(old, body.inside, known->base) || HasDirective(now.text, expected_[i], now.base);
      continue;
    }
    if (!body.is_reusable || is_stale_[i]) continue;
    kept_.elided.push_back({expected_[i], i});
    LeftOutText part{.begin = inside.begin, .end = inside.end, .comments = {}};
    for (const Comment* comment : CommentsIn(before_.unit, body.inside)) {
      const source::Offset distance = expected_[i].begin - body.inside.begin;
      part.comments.push_back({{comment->range.begin + distance, comment->range.end + distance}, comment->text});
    }
    parts.push_back(std::move(part));
  }
  if (is_outside) kept_.is_changed_outside = true;
  std::optional<SourceText> text = RewriteWithout(sources, file, std::move(parts));
  if (!text) Misfit();
  return text;
}

/// All that was left out has been taken over; whatever else there is was read.
bool Reuse::FitsOutside(const ParserOutput& output) const {
  const auto taken = std::ranges::count_if(output.bodies, &FunctionBody::was_taken_over);
  return static_cast<size_t>(taken) == kept_.elided.size();
}

bool Reuse::Fits(const source::SourceManager& sources, const std::vector<const SourceText*>& texts,
                 const ParserOutput& output) const {
  const bool same = fits_ && output.kept_fits && output.can_keep && output.missing.empty() &&
                    output.read == before_.read && output.token_count + before_.token_count <= kMaxTokens;
  if (!same || !output.stale_bodies.empty()) return false;
  if (kept_.is_changed_outside) {
    if (!FitsOutside(output)) return false;
  } else if (!std::ranges::equal(output.bodies, expected_, {}, &FunctionBody::inside)) {
    return false;
  }
  const BodiesByPlace by_place(output.bodies);
  bool fits = by_place.AreApart();
  const auto check = [&](source::Offset place) {
    const std::optional<uint32_t> at = by_place.At(place);
    if (place == 0 || (at && output.bodies[*at].was_taken_over)) fits = false;
  };
  for (const Finding& finding : output.findings.all()) check(finding.range.begin);
  if (output.open_names.empty()) return fits;
  if (JoinsNames(sources, texts)) return false;
  ForEachMention(sources, texts, output.open_names, [&](source::Offset place) {
    const std::optional<uint32_t> at = by_place.At(place);
    if (!at || output.bodies[*at].was_taken_over) fits = false;
  });
  return fits;
}

std::unique_ptr<KeptProgram> KeepProgram(const dialects::Request& request, const std::vector<const SourceText*>& texts,
                                         ParserOutput& output, KeptProgram* before) {
  auto program = std::make_unique<KeptProgram>();
  program->token_count = output.token_count + (before == nullptr ? 0 : before->token_count);
  program->bodies = std::move(output.bodies);
  std::vector<FunctionBody>& bodies = program->bodies;
  const BodiesByPlace by_place(bodies);
  if (!output.can_keep || !output.missing.empty() || program->token_count > kMaxTokens || !by_place.AreApart()) {
    return nullptr;
  }
  for (const FunctionBody& body : bodies) program->taken_over += body.was_taken_over ? 1 : 0;
  bool keeps = FindMacroUses(output.unit, by_place, bodies);
  const auto refuse_at = [&](source::Offset place) {
    if (place == 0) keeps = false;
    if (const std::optional<uint32_t> at = by_place.At(place)) bodies[*at].is_reusable = false;
  };
  for (const Finding& finding : output.findings.all()) refuse_at(finding.range.begin);
  for (const source::Offset use : output.builtin_uses) refuse_at(use);
  for (const SourceText* text : texts) {
    if (!text->moved.empty()) return nullptr;
    for (const Finding& finding : text->findings.all()) refuse_at(finding.range.begin);
    const source::File& file = request.sources->Get(text->file);
    if (!file.replaced.empty()) return nullptr;
    program->files.push_back({file.path, file.text, file.encoding, file.base});
    // A directive in a body is one for what follows it.
    for (size_t at = file.text.find('#'); at != std::string::npos; at = file.text.find('#', at + 1)) {
      refuse_at(file.base + static_cast<source::Offset>(at));
    }
  }
  if (!output.open_names.empty()) {
    if (JoinsNames(*request.sources, texts)) return nullptr;
    ForEachMention(*request.sources, texts, output.open_names, [&](source::Offset place) {
      keeps = keeps && by_place.At(place).has_value();
      refuse_at(place);
    });
  }
  if (!keeps) return nullptr;
  if (before != nullptr) MakeSpare(before->unit, program->spare);
  program->settings = SettingsOf(request);
  program->read = output.read;
  return program;
}

}  // namespace plcxx::hnc
