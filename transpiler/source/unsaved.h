// Files as an editor holds them: what is read in place of the bytes on the disk.
//
// An editor gives the text in UTF-8, whatever its file is written in; a program says what its bytes on the disk will
// say. So a text is given in the encoding that the caller names, as the editor will save it.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "transpiler/source/source.h"

namespace plcxx::source {

/// By FileIdentity of their paths.
using UnsavedBytes = std::map<std::string, std::string, std::less<>>;

/// While one lives, ReadBytes gives the bytes of these files; `bytes` outlives it. Only one thread makes scopes, but
/// whoever works for it in other threads reads the same.
class UnsavedScope {
 public:
  explicit UnsavedScope(const UnsavedBytes& bytes);
  ~UnsavedScope();
  UnsavedScope(const UnsavedScope&) = delete;
  UnsavedScope& operator=(const UnsavedScope&) = delete;

 private:
  const UnsavedBytes* before_;
};

/// Those of the innermost scope; null: none of the file, or no scope.
const std::string* UnsavedBytesOf(const std::string& path);

/// `utf8` in the bytes of an encoding; '?' for what it does not have.
std::string Encoded(std::string_view utf8, Encoding encoding);

}  // namespace plcxx::source
