#include "transpiler/driver/one_of.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/near_words.h"

namespace plcxx::driver {

CLI::Validator OneOf(std::vector<std::string> words) {
  const std::string description = CLI::detail::generate_set(words);  // "{text,json}", as command_table.cc reads it
  const auto refusal = [words = std::move(words)](const std::string& value) {
    return std::ranges::find(words, value) != words.end()
               ? std::string()
               : "'" + value + "' is no value of it" + support::ThereAre(value, words);
  };
  return CLI::Validator(refusal, description);
}

}  // namespace plcxx::driver
