#include "transpiler/support/sha256.h"

#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/SHA256.h>

extern "C" [[gnu::visibility("default")]] void plcxx_sha256(std::string_view bytes, std::string& digits) {
  const auto* const begin = reinterpret_cast<const uint8_t*>(bytes.data());
  digits = llvm::toHex(llvm::SHA256::hash(llvm::ArrayRef<uint8_t>(begin, bytes.size())), /*LowerCase=*/true);
}
