// One compilation of one program, with the places of its files as the client counts them.
//
// In: a request, the warnings that its project accepts, and the texts of open documents. Out: what `plcxx check` finds,
// and the program for everything else that an editor asks. It is never changed: after an edit there is a new one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/lsp/documents.h"
#include "transpiler/lsp/positions.h"
#include "transpiler/project/baseline.h"
#include "transpiler/source/unsaved.h"

namespace plcxx::lsp {

/// A range in one file.
struct FileRange {
  source::FileId file;
  Position begin, end;
};

class Names;

class Analysis {
 public:
  ~Analysis();
  Analysis(const compilation::CompilationRequest& request, const project::Baseline& baseline,
           const Documents& documents, Units units, std::unique_ptr<dialects::Kept>* kept);

  const compilation::Compilation& compilation() const { return compilation_; }
  const source::SourceManager& sources() const { return *compilation_.sources; }
  const ir::Program& program() const { return compilation_.program; }

  /// For the dialect's functions that read the sources again; diagnostics of its own are the caller's.
  dialects::Request MakeRequest() { return compilation_.MakeRequest(); }
  const source::UnsavedBytes& unsaved() const { return unsaved_; }
  /// As given; null: nothing is kept.
  std::unique_ptr<dialects::Kept>* kept() const { return kept_; }
  /// Made at the first call. `meaning`: see names.h. Only with a dialect.
  const Names& NamesWith(const Analysis& meaning);

  /// By FileIdentity; none: the program does not read it.
  source::FileId FileOf(std::string_view identity) const;
  const std::string& IdentityOf(source::FileId file) const { return identities_[file.index]; }
  const Lines& LinesOf(source::FileId file) const;
  /// {0, 0} is the beginning of the first file.
  FileRange Locate(source::Range range) const;
  source::Offset OffsetOf(source::FileId file, Position position) const;

 private:
  source::UnsavedBytes unsaved_;
  compilation::Compilation compilation_;
  Units units_;
  std::unique_ptr<dialects::Kept>* kept_;
  std::unique_ptr<Names> names_;
  std::vector<std::string> identities_;  // by FileId
  mutable std::vector<std::optional<Lines>> lines_;
};

Json ToJson(const FileRange& range);

}  // namespace plcxx::lsp
