// A program as the parser has read it, for the next run (kept_bodies.h): which of its bodies the next run need not
// read.
//
// In: the texts of both runs. Out: texts without the bodies that are as they were, and after the run whether the
// program was the one that it was taken for. Where the change is in one body, all else has to be as it was; where it is
// outside of them, the environment of each body that is taken over (kept_bodies.h).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/parser/kept_bodies.h"
#include "transpiler/dialects/hnc/parser/module.h"
#include "transpiler/dialects/hnc/source/source_text.h"

namespace plcxx::hnc {

/// By path.
using LoadedFiles = std::map<std::string, source::FileId>;

class KeptProgram : public dialects::Kept {
 public:
  struct File {
    std::string path, text;
    source::Encoding encoding{};  // literals have the bytes that the file has
    source::Offset base = 0;
  };

  std::string settings;  // all that a run depends on beside the files
  std::vector<File> files;
  std::vector<std::string> read;     // paths, as ParserOutput::read
  std::vector<FunctionBody> bodies;  // in the order of the definitions
  size_t token_count = 0;
  uint32_t taken_over = 0;  // how many of the bodies the run did not read
  Unit unit;
  Unit spare;                // empty, with the memory of the tree before: it would come from the system at each run
  bool is_complete = false;  // the unit is there: no fault came between
};

std::string SettingsOf(const dialects::Request& request);

/// One run that takes bodies over.
class Reuse {
 public:
  /// `stale`: bodies of the program before that are not to be taken over.
  Reuse(KeptProgram& before, const std::vector<uint32_t>& stale);
  Reuse(const Reuse&) = delete;
  Reuse& operator=(const Reuse&) = delete;

  const KeptBodies& bodies() const { return kept_; }
  /// For the tree of this run.
  Unit TakeSpare() { return std::move(before_.spare); }
  void Misfit() { fits_ = false; }
  bool fits() const { return fits_; }
  size_t elided_count() const { return kept_.elided.size(); }
  /// Without the bodies that are as before; none: the file is another one.
  std::optional<SourceText> TextOf(const source::SourceManager& sources, source::FileId file);
  /// After the run: it was the program before but for the bodies that were read again.
  bool Fits(const source::SourceManager& sources, const std::vector<const SourceText*>& texts,
            const ParserOutput& output) const;

 private:
  struct Change;

  /// The bodies of the program before in a file, by place.
  std::vector<uint32_t> BodiesIn(const KeptProgram::File& file) const;
  /// Where the body is now; none: the change has a part of it.
  static std::optional<source::Range> NowAt(source::Range inside, const Change& change);
  bool FitsOutside(const ParserOutput& output) const;

  KeptProgram& before_;
  KeptBodies kept_;
  std::vector<bool> is_stale_;           // by body of the program before
  std::vector<source::Range> expected_;  // likewise: where it is now
  bool fits_ = true;
};

/// What the next run may take over; null: nothing. The tree is still to be added. `before` may be null: the program was
/// read as a whole.
std::unique_ptr<KeptProgram> KeepProgram(const dialects::Request& request, const std::vector<const SourceText*>& texts,
                                         ParserOutput& output, KeptProgram* before);

}  // namespace plcxx::hnc
