#include "transpiler/support/system_words.h"

#include <cctype>
#include <cstring>

namespace plcxx::support {

std::string SystemWords(int error) {
  std::string words = std::strerror(error);
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return words;
}

}  // namespace plcxx::support
