#include "transpiler/lsp/documents.h"

#include <algorithm>
#include <utility>

#include "transpiler/source/find_file.h"

namespace plcxx::lsp {
namespace {

constexpr size_t kMaxDocumentBytes = size_t{64} << 20;

void CheckSize(std::string_view text) {
  if (text.size() > kMaxDocumentBytes) {
    throw rpc::Error(rpc::kInvalidParams, "a document is larger than " + std::to_string(kMaxDocumentBytes) + " bytes");
  }
}

void Apply(const Json& change, Units units, std::string& text) {
  const std::string with = rpc::TextOf(change, "text");
  if (!change.contains("range") || change["range"].is_null()) {
    text = with;
    return;
  }
  const Json& range = rpc::ObjectOf(change, "range");
  const Lines lines(text, units);
  const size_t begin = lines.Offset(ReadPosition(rpc::ObjectOf(range, "start")));
  const size_t end = lines.Offset(ReadPosition(rpc::ObjectOf(range, "end")));
  text.replace(std::min(begin, end), std::max(begin, end) - std::min(begin, end), with);
}

}  // namespace

std::string PathOfDocument(const Json& params) { return PathOfItem(rpc::ObjectOf(params, "textDocument")); }

std::string PathOfItem(const Json& item) {
  const std::string uri = rpc::TextOf(item, "uri");
  std::string path = PathOfUri(uri);
  if (path.empty()) throw rpc::Error(rpc::kInvalidParams, "'" + uri + "' names no file of this machine");
  return path;
}

const Document& Documents::Open(const Json& params) {
  const Json& item = rpc::ObjectOf(params, "textDocument");
  Document document;
  document.path = PathOfDocument(params);
  document.uri = rpc::TextOf(item, "uri");
  document.text = rpc::TextOf(item, "text");
  document.language = rpc::OptionalText(item, "languageId").value_or("");
  document.version = rpc::OptionalNumber(item, "version").value_or(0);
  CheckSize(document.text);
  return documents_[source::FileIdentity(document.path)] = std::move(document);
}

const Document& Documents::Change(const Json& params, Units units) {
  const std::string path = PathOfDocument(params);
  const auto found = documents_.find(source::FileIdentity(path));
  if (found == documents_.end()) throw rpc::Error(rpc::kInvalidParams, "'" + path + "' is not open");
  std::string text = found->second.text;
  for (const Json& change : rpc::ArrayOf(params, "contentChanges")) {
    Apply(change, units, text);
    CheckSize(text);
  }
  Document& document = found->second;
  document.text = std::move(text);
  document.version = rpc::OptionalNumber(params["textDocument"], "version").value_or(document.version + 1);
  return document;
}

std::string Documents::Close(const Json& params) {
  const auto found = documents_.find(source::FileIdentity(PathOfDocument(params)));
  if (found == documents_.end()) return {};
  std::string path = found->second.path;
  documents_.erase(found);
  return path;
}

void Documents::Replace(const std::string& identity, std::string text) {
  Document& document = documents_[identity];
  if (document.path.empty()) document.path = identity;
  document.text = std::move(text);
}

const Document* Documents::Find(std::string_view identity) const {
  const auto found = documents_.find(identity);
  return found == documents_.end() ? nullptr : &found->second;
}

}  // namespace plcxx::lsp
