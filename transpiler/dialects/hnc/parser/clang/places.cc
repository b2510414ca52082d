#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <iterator>

#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {
namespace {

constexpr size_t kNear = 8;  // entries on both sides of the last one that are looked at before all are searched

/// Where Clang numbers the place, be it in a file or in an expansion.
unsigned NumberOf(clang::SourceLocation place) {
  constexpr unsigned kInExpansion = 1U << 31;
  return place.getRawEncoding() & ~kInExpansion;
}

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Of the token at the beginning of a text, where it is plain to see; 0: it is not.
unsigned PlainLength(std::string_view text) {
  if (text.empty()) return 0;
  if (std::string_view("()[]{},;").find(text.front()) != std::string_view::npos) return 1;
  if (!IsLetter(text.front()) && !IsDigit(text.front())) return 0;
  size_t end = 1;
  while (end < text.size() && (IsLetter(text[end]) || IsDigit(text[end]))) ++end;
  // What follows may belong to it: a point or an exponent's sign to a number, a literal to its prefix, a spliced line.
  constexpr std::string_view kEnds = " \t\n()[]{},;*/<>=!&|^:";
  const bool ends = end == text.size() || kEnds.find(text[end]) != std::string_view::npos;
  return ends ? static_cast<unsigned>(end) : 0;
}

}  // namespace

/// An expansion is within a use whose places were numbered before it.
void Places::AddEntries() const {
  const clang::SourceManager& sources = clang_.getSourceManager();
  while (entries_.size() < sources.local_sloc_entry_size()) {
    const clang::SrcMgr::SLocEntry& made = sources.getLocalSLocEntry(static_cast<unsigned>(entries_.size()));
    Entry entry{.begin = static_cast<unsigned>(made.getOffset()), .first = {}, .last = {}};
    if (made.isExpansion()) {
      const clang::CharSourceRange use = made.getExpansion().getExpansionLocRange();
      const auto around = [&](clang::SourceLocation place) -> const Entry& {
        return entries_[Search(NumberOf(place), last_expansion_)];
      };
      entry.first = use.getBegin().isFileID() ? use.getBegin() : around(use.getBegin()).first;
      entry.last = use.getEnd().isFileID() ? use.getEnd() : around(use.getEnd()).last;
    }
    entries_.push_back(entry);
  }
}

size_t Places::Search(unsigned number, size_t& last_found) const {
  const auto ends_before = [&](size_t i) { return i + 1 < entries_.size() && entries_[i + 1].begin <= number; };
  size_t at = last_found;
  for (size_t i = 0; i < kNear && entries_[at].begin > number; ++i) --at;
  for (size_t i = 0; i < kNear && ends_before(at); ++i) ++at;
  if (entries_[at].begin > number || ends_before(at)) {
    const auto next = std::ranges::upper_bound(entries_, number, {}, &Entry::begin);
    at = static_cast<size_t>(std::distance(entries_.begin(), next)) - 1;
  }
  last_found = at;
  return at;
}

size_t Places::EntryOf(clang::SourceLocation place) const {
  const unsigned number = NumberOf(place);
  const bool may_be_new = entries_.empty() || number >= entries_.back().begin;
  if (may_be_new && entries_.size() < clang_.getSourceManager().local_sloc_entry_size()) AddEntries();
  return Search(number, place.isFileID() ? last_file_ : last_expansion_);
}

clang::SourceLocation Places::FirstOf(clang::SourceLocation place) const {
  return place.isFileID() ? place : entries_[EntryOf(place)].first;
}

clang::SourceLocation Places::LastOf(clang::SourceLocation place) const {
  return place.isFileID() ? place : entries_[EntryOf(place)].last;
}

Places::File& Places::FileOf(clang::SourceLocation place, size_t entry) const {
  uint32_t& file = entries_[entry].file;
  if (file == kNotAsked) {
    const clang::SourceManager& sources = clang_.getSourceManager();
    const auto known = sources.getFileEntryRefForID(sources.getFileID(place));
    const SourceText* text = known ? input_.open(known->getName().str()) : nullptr;
    const auto same = std::ranges::find(files_, text, &File::text);  // a file may be included again and again
    file = static_cast<uint32_t>(std::distance(files_.begin(), same));
    if (same == files_.end()) files_.push_back({.text = text, .ends = {}});
  }
  return files_[file];
}

source::Offset Places::Of(clang::SourceLocation place) const {
  const clang::SourceLocation first = FirstOf(place);
  if (first.isInvalid()) return 0;
  const size_t entry = EntryOf(first);
  const SourceText* text = FileOf(first, entry).text;
  return text == nullptr ? 0 : text->Original(NumberOf(first) - entries_[entry].begin);
}

source::Offset Places::EndOfToken(clang::SourceLocation place, size_t entry) const {
  File& file = FileOf(place, entry);
  if (file.text == nullptr) return 0;
  if (file.ends.empty()) file.ends.resize(file.text->text.size() + 1);
  const unsigned at = NumberOf(place) - entries_[entry].begin;
  source::Offset& end = file.ends[at];
  if (end == 0) {
    unsigned length = PlainLength(std::string_view(file.text->text).substr(at));
    if (length == 0) {
      length = clang::Lexer::MeasureTokenLength(place, clang_.getSourceManager(), clang_.getLangOpts());
    }
    end = file.text->Original(at + length);
  }
  return end;
}

source::Range Places::Of(clang::SourceLocation first, clang::SourceLocation last) const {
  if (first.isInvalid()) return {};
  const clang::SourceLocation begin = FirstOf(first);
  clang::SourceLocation end = LastOf(last.isValid() ? last : first);
  if (EntryOf(begin) != EntryOf(end)) end = LastOf(first);
  const source::Range range{Of(begin), EndOfToken(end, EntryOf(end))};
  return {range.begin, std::max(range.begin, range.end)};
}

clang::SourceLocation Places::IncludedAt(clang::SourceLocation place) const {
  const clang::SourceManager& sources = clang_.getSourceManager();
  while (place.isValid() && InProduct(place)) place = sources.getIncludeLoc(sources.getFileID(FirstOf(place)));
  return place;
}

bool Places::InProduct(clang::SourceLocation place) const {
  if (place.isInvalid()) return true;
  const clang::SourceLocation first = FirstOf(place);
  const SourceText* text = FileOf(first, EntryOf(first)).text;
  return text == nullptr || !text->file.valid();
}

}  // namespace plcxx::hnc
