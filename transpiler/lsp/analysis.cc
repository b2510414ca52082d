#include "transpiler/lsp/analysis.h"

#include <utility>
#include <variant>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/lsp/names.h"
#include "transpiler/source/decode.h"
#include "transpiler/source/find_file.h"
#include "transpiler/source/read_bytes.h"
#include "transpiler/source/unsaved.h"
#include "transpiler/support/byte_order_mark.h"

namespace plcxx::lsp {
namespace {

const dialects::Dialect* DialectOf(const compilation::CompilationRequest& request, const Documents& documents) {
  std::vector<std::string> paths;
  for (const std::string& path : request.sources) {
    paths.push_back(compilation::FromBase(request.base_directory, path));
  }
  return compilation::ChooseDialect(request.dialect, paths, [&](const std::string& path) {
    if (const Document* open = documents.Find(source::FileIdentity(path))) return open->text;
    source::SourceManager scratch;
    const auto loaded = scratch.Load(path, {});
    const auto* file = std::get_if<source::FileId>(&loaded);
    return file == nullptr ? std::string() : scratch.Get(*file).text;
  });
}

/// What the file will be when the editor saves it: in the encoding in which it is now.
std::string SavedBytes(const Document& document, const source::LoadOptions& options) {
  auto bytes = source::ReadBytes(document.path, options.max_bytes);
  if (!std::holds_alternative<std::string>(bytes)) return document.text;
  source::SourceManager scratch;
  const auto loaded = scratch.AddBytes(document.path, std::get<std::string>(bytes), options);
  const auto* id = std::get_if<source::FileId>(&loaded);
  if (id == nullptr) return document.text;
  const source::File& file = scratch.Get(*id);
  std::string saved = source::Encoded(document.text, file.encoding);
  if (file.had_bom && !saved.starts_with(support::kByteOrderMark)) saved.insert(0, support::kByteOrderMark);
  return saved;
}

source::UnsavedBytes UnsavedOf(const compilation::CompilationRequest& request, const Documents& documents) {
  source::LoadOptions options;
  if (const dialects::Dialect* dialect = DialectOf(request, documents)) options = dialect->load;
  if (request.encoding) options.encoding = request.encoding;
  source::UnsavedBytes bytes;
  for (const auto& [identity, document] : documents.all()) bytes[identity] = SavedBytes(document, options);
  return bytes;
}

compilation::Compilation CompileWith(compilation::CompilationRequest request, const project::Baseline& baseline,
                                     const source::UnsavedBytes& unsaved, std::unique_ptr<dialects::Kept>* kept) {
  const source::UnsavedScope scope(unsaved);
  request.lists = dialects::Lists::kNone;
  request.kept = kept;
  if (baseline.accepted.empty()) return compilation::Compile(request, compilation::Stage::kChecked);
  project::Accepted accepted;
  return project::CompileAccepting(request, compilation::Stage::kChecked, baseline, request.base_directory, accepted);
}

}  // namespace

Analysis::Analysis(const compilation::CompilationRequest& request, const project::Baseline& baseline,
                   const Documents& documents, Units units, std::unique_ptr<dialects::Kept>* kept)
    : unsaved_(UnsavedOf(request, documents)),
      compilation_(CompileWith(request, baseline, unsaved_, kept)),
      units_(units),
      kept_(kept),
      lines_(compilation_.sources->size()) {
  for (uint32_t i = 0; i < sources().size(); ++i) {
    identities_.push_back(source::FileIdentity(sources().Get(source::FileId(i)).path));
  }
}

Analysis::~Analysis() = default;

const Names& Analysis::NamesWith(const Analysis& meaning) {
  if (names_ == nullptr) names_ = std::make_unique<Names>(*this, meaning);
  return *names_;
}

source::FileId Analysis::FileOf(std::string_view identity) const {
  for (uint32_t i = 0; i < identities_.size(); ++i) {
    if (identities_[i] == identity) return source::FileId(i);
  }
  return {};
}

const Lines& Analysis::LinesOf(source::FileId file) const {
  std::optional<Lines>& lines = lines_[file.index];
  if (!lines) lines.emplace(sources().Get(file).text, units_);
  return *lines;
}

FileRange Analysis::Locate(source::Range range) const {
  const source::FileId file = sources().FileAt(range.begin);
  if (!file.valid()) return {source::FileId(0), {}, {}};
  const Lines& lines = LinesOf(file);
  const source::Offset base = sources().Get(file).base;
  const source::Offset end = sources().FileAt(range.end) == file && range.end > range.begin ? range.end : range.begin;
  return {file, lines.At(range.begin - base), lines.At(end - base)};
}

source::Offset Analysis::OffsetOf(source::FileId file, Position position) const {
  return sources().Get(file).base + static_cast<source::Offset>(LinesOf(file).Offset(position));
}

Json ToJson(const FileRange& range) { return {{"start", ToJson(range.begin)}, {"end", ToJson(range.end)}}; }

}  // namespace plcxx::lsp
