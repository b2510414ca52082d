#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>

#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {

const SourceText* Places::TextOf(clang::FileID file) const {
  const auto known = texts_.find(file.getHashValue());
  if (known != texts_.end()) return known->second;
  const auto entry = clang_.getSourceManager().getFileEntryRefForID(file);
  const SourceText* text = entry ? input_.open(entry->getName().str()) : nullptr;
  texts_.emplace(file.getHashValue(), text);
  return text;
}

source::Offset Places::OfSpelled(clang::SourceLocation place, unsigned ahead) const {
  if (place.isInvalid()) return 0;
  const auto [file, offset] = clang_.getSourceManager().getDecomposedLoc(place);
  const SourceText* text = TextOf(file);
  return text == nullptr ? 0 : text->Original(offset + ahead);
}

source::Offset Places::Of(clang::SourceLocation place) const {
  return OfSpelled(clang_.getSourceManager().getExpansionLoc(place), 0);
}

source::Range Places::Of(clang::SourceLocation first, clang::SourceLocation last) const {
  if (first.isInvalid()) return {};
  clang::SourceManager& sources = clang_.getSourceManager();
  const clang::SourceLocation begin = sources.getExpansionRange(first).getBegin();
  clang::SourceLocation end = sources.getExpansionRange(last.isValid() ? last : first).getEnd();
  if (sources.getFileID(begin) != sources.getFileID(end)) end = sources.getExpansionRange(first).getEnd();
  const unsigned length = clang::Lexer::MeasureTokenLength(end, sources, clang_.getLangOpts());
  const source::Range range{OfSpelled(begin, 0), OfSpelled(end, length)};
  return {range.begin, std::max(range.begin, range.end)};
}

bool Places::InProduct(clang::SourceLocation place) const {
  if (place.isInvalid()) return true;
  clang::SourceManager& sources = clang_.getSourceManager();
  const SourceText* text = TextOf(sources.getFileID(sources.getExpansionLoc(place)));
  return text == nullptr || !text->file.valid();
}

}  // namespace plcxx::hnc
