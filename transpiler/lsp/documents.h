// The files that the client has opened, as it holds them.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "transpiler/lsp/positions.h"

namespace plcxx::lsp {

struct Document {
  std::string uri;       // as the client spells it
  std::string path;      // absolute
  std::string text;      // UTF-8; bytes that are none are not in it
  std::string language;  // as the client calls it; the name of a dialect means this one
  int64_t version = 0;
};

class Documents {
 public:
  /// Parameters of textDocument/didOpen, didChange and didClose. Throw rpc::Error where they are wrong; a change that
  /// is wrong leaves the document as it was.
  const Document& Open(const Json& params);
  const Document& Change(const Json& params, Units units);
  /// Gives its path; empty when it was not open.
  std::string Close(const Json& params);

  /// Another text for a file, open or not: what would be, in a copy.
  void Replace(const std::string& identity, std::string text);

  /// By FileIdentity of the path; null: not open.
  const Document* Find(std::string_view identity) const;
  /// By identity.
  const std::map<std::string, Document, std::less<>>& all() const { return documents_; }

 private:
  std::map<std::string, Document, std::less<>> documents_;
};

/// The file that `textDocument.uri` of the parameters names; throws rpc::Error when it is none of this machine.
std::string PathOfDocument(const Json& params);
/// The same of `uri` of a call hierarchy's item.
std::string PathOfItem(const Json& item);

}  // namespace plcxx::lsp
