#include "transpiler/source/unsaved.h"

#include "transpiler/source/decode.h"
#include "transpiler/source/find_file.h"

namespace plcxx::source {
namespace {

/// Of the process: a front end may read what a source includes in a thread of its own (hnc).
const UnsavedBytes* innermost = nullptr;

}  // namespace

UnsavedScope::UnsavedScope(const UnsavedBytes& bytes) : before_(innermost) { innermost = &bytes; }
UnsavedScope::~UnsavedScope() { innermost = before_; }

const std::string* UnsavedBytesOf(const std::string& path) {
  if (innermost == nullptr || innermost->empty()) return nullptr;
  const auto found = innermost->find(FileIdentity(path));
  return found == innermost->end() ? nullptr : &found->second;
}

std::string Encoded(std::string_view utf8, Encoding encoding) {
  switch (encoding) {
    case Encoding::kUtf8:
      return std::string(utf8);
    case Encoding::kGb18030:
      return EncodeGb18030(utf8);
    case Encoding::kCp866:
    case Encoding::kCp1251:
    case Encoding::kKoi8R:
    case Encoding::kMazovia:
    case Encoding::kKamenicky:
    case Encoding::kCp852:
    case Encoding::kCp1250:
      return EncodeEightBit(utf8, encoding);
  }
  return std::string(utf8);
}

}  // namespace plcxx::source
