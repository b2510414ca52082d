// Functions of a Dialect (transpiler/dialects/dialect.h) that are the same in most of them.
#pragma once

#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::dialects {

/// A source that cannot be read, in the words that all dialects share.
void ReportCannotRead(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics);

/// For dialects without options for budgets.
void ReportNoBudget(Budget budget, uint64_t needed, uint64_t limit, source::FileId first,
                    const source::SourceManager& sources, diag::Engine& diagnostics);

/// The tokens of all files, one after the other. `kPrint(sources, file)` is the dialect's.
template <std::string (*kPrint)(const source::SourceManager&, source::FileId)>
std::string TokensOfFiles(Request& request) {
  std::string text;
  for (const source::FileId file : request.files) text += kPrint(*request.sources, file);
  return text;
}

}  // namespace plcxx::dialects
