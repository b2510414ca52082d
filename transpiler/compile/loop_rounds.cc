#include "transpiler/compile/loop_rounds.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "transpiler/compile/runtime_files.h"

namespace plcxx::compile {
namespace {

/// N of "at most N rounds" in a line.
std::optional<uint64_t> RoundsInComment(std::string_view line, uint64_t elements) {
  constexpr std::string_view kWords = "// at most ";
  const size_t at = line.find(kWords);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view number = line.substr(at + kWords.size());
  if (number.starts_with("one round for each element")) return elements;
  uint64_t rounds = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), rounds);
  const std::string_view rest = number.substr(static_cast<size_t>(end - number.data()));
  if (error != std::errc() || !rest.starts_with(" rounds")) return std::nullopt;
  return rounds;
}

/// Calls take(line, its text) for each line until it gives true.
template <class Take>
void ForEachLine(std::string_view text, Take&& take) {
  uint32_t line = 1;
  for (size_t at = 0; at < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', at), text.size());
    if (take(line, text.substr(at, end - at))) return;
    at = end + 1;
  }
}

bool Contains(const KnownLoop& loop, uint32_t line) { return loop.first <= line && line <= loop.last; }

bool IsInside(const KnownLoop& inner, const KnownLoop& outer) {
  return &inner != &outer && inner.file == outer.file && outer.first <= inner.first && inner.last <= outer.last;
}

class Search {
 public:
  Search(const ObjectFacts& object, const CodeFunction& function, const std::vector<KnownLoop>& known)
      : object_(object), function_(function), known_(known) {}

  /// The loops of the text that this one may be.
  std::vector<const KnownLoop*> Candidates(const PathLoop& loop) const {
    const std::vector<CodeLine> lines = LinesOf(loop);
    std::vector<const KnownLoop*> found;
    for (const KnownLoop& known : known_) {
      if (std::ranges::any_of(lines, [&](const CodeLine& line) { return IsIn(line, known); })) found.push_back(&known);
    }
    // One that has a line of the text around a loop is not that loop, but one around it.
    std::erase_if(found, [&](const KnownLoop* inner) {
      return std::ranges::any_of(found, [&](const KnownLoop* outer) {
        return IsInside(*inner, *outer) && std::ranges::any_of(lines, [&](const CodeLine& line) {
                 return IsIn(line, *outer) && !IsIn(line, *inner);
               });
      });
    });
    // What the loop around it is for certain, this one is not, and nothing around that either.
    if (loop.around != nullptr) {
      const std::vector<const KnownLoop*> around = Candidates(*loop.around);
      if (around.size() == 1) {
        std::erase_if(found, [&](const KnownLoop* candidate) {
          return candidate == around.front() || IsInside(*around.front(), *candidate);
        });
      }
    }
    return found;
  }

 private:
  bool IsIn(const CodeLine& line, const KnownLoop& loop) const {
    return Contains(loop, line.line) && object_.files[line.file] == loop.file;
  }

  std::vector<CodeLine> LinesOf(const PathLoop& loop) const {
    std::vector<CodeLine> lines;
    for (const uint32_t block : loop.nodes) {
      for (const CodeLine& line : function_.blocks[block].lines) {
        if (line.line != 0 && line.file < object_.files.size()) lines.push_back(line);
      }
    }
    return lines;
  }

  const ObjectFacts& object_;
  const CodeFunction& function_;
  const std::vector<KnownLoop>& known_;
};

}  // namespace

KnownLoop LoopAt(const std::string& file, std::string_view text, uint32_t line, std::optional<uint64_t> rounds) {
  KnownLoop loop{.file = file, .first = line, .last = line, .rounds = rounds};
  size_t indent = 0;
  bool opens = false;
  ForEachLine(text, [&](uint32_t at, std::string_view row) {
    const size_t begin = std::min(row.find_first_not_of(' '), row.size());
    if (at == line) {
      indent = begin;
      opens = row.find('{') != std::string_view::npos;
      return !opens;
    }
    if (at < line || begin != indent || !row.substr(begin).starts_with('}')) return false;
    loop.last = at;
    return true;
  });
  return loop;
}

void AddRuntimeLoops(std::vector<KnownLoop>& loops, uint64_t elements) {
  for (const RuntimeFile& header : RuntimeFiles()) {
    ForEachLine(header.text, [&](uint32_t line, std::string_view row) {
      const std::string_view head = row.substr(std::min(row.find_first_not_of(' '), row.size()));
      // Those without a bound are known, too, so that a loop inside is not taken for them.
      if (head.starts_with("for (") || head.starts_with("while (")) {
        loops.push_back(LoopAt(header.name, header.text, line, RoundsInComment(row, elements)));
      }
      return false;
    });
  }
}

Rounds RoundsOf(const ObjectFacts& object, const CodeFunction& function, const PathLoop& loop,
                const LoopBounds& bounds) {
  const Search search(object, function, bounds.loops);
  const std::vector<const KnownLoop*> candidates = search.Candidates(loop);
  if (candidates.empty() && loop.around != nullptr && !search.Candidates(*loop.around).empty()) {
    return {.most = 0, .same_as_around = true};  // compilers jump back to several places of one loop
  }
  if (candidates.empty()) {
    const bool clears = loop.nodes.size() == 1 && function.blocks[loop.header].calls.empty();
    return {.most = clears && bounds.largest_object > 0 ? std::optional(bounds.largest_object) : std::nullopt};
  }
  Rounds rounds;
  rounds.where = candidates.front()->file + ":" + std::to_string(candidates.front()->first);
  for (const KnownLoop* candidate : candidates) {
    const bool other_budget = candidate->budget && rounds.budget && candidate->budget != rounds.budget;
    if (other_budget || (!candidate->rounds && !candidate->budget)) return {.where = rounds.where};
    if (candidate->budget) rounds.budget = candidate->budget;
    rounds.most = std::max(rounds.most.value_or(0), candidate->rounds.value_or(0));
  }
  return rounds;
}

}  // namespace plcxx::compile
