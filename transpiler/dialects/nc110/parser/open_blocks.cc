#include "transpiler/dialects/nc110/parser/open_blocks.h"

#include <algorithm>

#include "transpiler/support/near_words.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kMaxName = 128;
constexpr size_t kSignificantName = 6;

/// What shows where the end of the block may be missing.
void NoteLoneWords(source::Range lone_end, const std::vector<source::Range>& lone_does, std::string_view end_word,
                   diag::Diagnostic& report) {
  if (lone_end.begin != 0) {
    report.notes.push_back({lone_end, "this is no end of a block: write " + std::string(end_word)});
  }
  if (!lone_does.empty()) report.notes.push_back({lone_does.front(), "this DOE is in front of it"});
}

/// "ENED" for "ENDE".
bool HasNeighboursExchanged(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  const auto [at, in_word] = std::ranges::mismatch(text, word);
  if (at == text.end() || at + 1 == text.end()) return false;
  return at[0] == in_word[1] && at[1] == in_word[0] && std::equal(at + 2, text.end(), in_word + 2);
}

}  // namespace

std::string_view HeadWord(BlockKind kind) {
  switch (kind) {
    case BlockKind::kDof:
      return "DOF";
    case BlockKind::kDoe:
      return "DOE";
    case BlockKind::kDow:
      return "DOW";
  }
  PLCXX_UNREACHABLE();
}

std::string_view EndWord(BlockKind kind) {
  switch (kind) {
    case BlockKind::kDof:
      return "ENDF";
    case BlockKind::kDoe:
      return "ENDE";
    case BlockKind::kDow:
      return "ENDW";
  }
  PLCXX_UNREACHABLE();
}

std::string_view OpenBlocks::NameAt(source::Range range) const {
  const auto mapped = mapped_names_.find(range.begin);
  return mapped != mapped_names_.end() ? std::string_view(mapped->second) : sources_.Text(range);
}

bool OpenBlocks::SameName(source::Range a, source::Range b) const {
  return NameAt(a).substr(0, kSignificantName) == NameAt(b).substr(0, kSignificantName);
}

source::Range OpenBlocks::TakeName() {
  const Token& token = Take();
  if (token.mapped) {
    mapped_names_[token.range.begin] = TextOf(token);
  }
  if (TextOf(token).size() > kMaxName) {
    Fault(token.range, diag::Nc110BlockNameTooLong, static_cast<diag::Number>(TextOf(token).size()));
  }
  return token.range;
}

void OpenBlocks::Close(BlockEnd& end, const Token& word) {
  const Block& innermost = program_.blocks[open_.back().block];
  if (innermost.kind != end.kind) {
    Fault(word.range, diag::Nc110BlockKind, EndWord(end.kind), HeadWord(innermost.kind))
        .notes.push_back({innermost.keyword, "the block begins here"});
  }
  CheckEndName(end);
  end.block = open_.back().block;
  if (const source::Range lone = open_.back().lone_end; lone.begin != 0) {
    const std::string text(sources_.Text(lone));
    const std::string cause = CauseOfUnknown(text);
    if (cause.empty()) {
      diagnostics_.Report(lone, diag::Nc110UnknownIdentifier, text);
    } else {
      diagnostics_.Report(lone, diag::Nc110UnknownIdentifierCause, text, cause);
    }
  }
  for (const source::Range doe : open_.back().lone_does) diagnostics_.Report(doe, diag::Nc110DoeWithoutDof);
  open_.pop_back();
  program_.blocks[end.block].end = ItemId(program_.items.size());
}

/// A wrong name may mean that ends are missing: then the blocks in between are closed too, without more messages.
void OpenBlocks::CheckEndName(const BlockEnd& end) {
  if (end.name.begin == end.name.end) {
    return;
  }
  const Block& innermost = program_.blocks[open_.back().block];
  const std::string_view name = NameAt(end.name);
  const bool named = innermost.name.begin != innermost.name.end;
  if (named && SameName(innermost.name, end.name)) {
    if (NameAt(innermost.name) != name) {
      Warn(end.name, diag::Nc110BlockNameTail, name, NameAt(innermost.name));
    }
    return;
  }
  const std::string expected =
      named ? "the open block is " + Quoted(NameAt(innermost.name)) : "the open block has no name";
  Fault(end.name, diag::Nc110BlockName, EndWord(end.kind), name, expected)
      .notes.push_back({innermost.keyword, "the open block begins here"});
  for (size_t depth = open_.size(); depth-- > 0;) {
    const Block& outer = program_.blocks[open_[depth].block];
    if (outer.name.begin != outer.name.end && SameName(outer.name, end.name) && outer.kind == end.kind) {
      open_.resize(depth + 1);
      return;
    }
  }
}

bool OpenBlocks::IsMeantEnd(std::string_view run, source::Range range) {
  constexpr std::string_view kEnds[] = {"ENDF", "ENDE", "ENDW"};
  const std::string capitals = Capitals(run);
  const auto is_near = [&](std::string_view end) {
    return support::EditDistance(capitals, end) == 1 || HasNeighboursExchanged(capitals, end);
  };
  const bool is_end = capitals == "END" || capitals == "ENDIF" || std::ranges::any_of(kEnds, is_near);
  if (now_.failed || open_.empty() || !is_end) {
    return false;
  }
  OpenBlock& open = open_.back();
  if (open.reported || open.lone_end.begin != 0) {
    return false;
  }
  open.lone_end = range;
  return true;
}

bool OpenBlocks::KeepLoneDoe(source::Range doe) {
  if (open_.empty() || open_.back().reported) {
    return false;
  }
  open_.back().lone_does.push_back(doe);
  return true;
}

void OpenBlocks::ReportAtMark(source::Range mark) {
  for (OpenBlock& open : open_) {
    if (!std::exchange(open.reported, true)) {
      const Block& block = program_.blocks[open.block];
      diag::Diagnostic& report =
          diagnostics_.Report(block.keyword, diag::Nc110BlockCycleMark, HeadWord(block.kind), EndWord(block.kind));
      report.notes.push_back({mark, "'$' stands here"});
      NoteLoneWords(open.lone_end, open.lone_does, EndWord(block.kind), report);
    }
  }
}

void OpenBlocks::ReportAtEnd() {
  for (const OpenBlock& open : open_) {
    if (!open.reported) {
      const Block& block = program_.blocks[open.block];
      NoteLoneWords(
          open.lone_end, open.lone_does, EndWord(block.kind),
          diagnostics_.Report(block.keyword, diag::Nc110BlockOpen, HeadWord(block.kind), EndWord(block.kind)));
    }
  }
}

void OpenBlocks::ReportAcrossFiles() {
  for (OpenBlock& open : open_) {
    if (!std::exchange(open.continued, true) && !open.reported) {
      const Block& block = program_.blocks[open.block];
      diagnostics_.Report(block.keyword, diag::Nc110BlockAcrossFiles, Plain(block.keyword));
    }
  }
}

}  // namespace plcxx::nc110
