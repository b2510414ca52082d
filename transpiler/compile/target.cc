#include "transpiler/compile/target.h"

#include <algorithm>

namespace plcxx::compile {

const std::vector<Target>& Targets() {
  static const std::vector<Target> targets = {
#define PLCXX_TARGET(name, prefix, triple, flags, processor, meaning) {name, prefix, triple, flags, processor, meaning},
#include "transpiler/compile/targets.def"
#undef PLCXX_TARGET
  };
  return targets;
}

std::vector<std::string_view> TargetNames() {
  std::vector<std::string_view> names;
  for (const Target& target : Targets()) names.push_back(target.name);
  return names;
}

const Target* FindTarget(std::string_view name) {
  const auto found = std::ranges::find(Targets(), name, &Target::name);
  return found == Targets().end() ? nullptr : &*found;
}

std::vector<std::string> FlagsOf(const Target& target) {
  std::vector<std::string> flags;
  for (size_t at = 0; at < target.flags.size();) {
    const size_t end = std::min(target.flags.find(' ', at), target.flags.size());
    flags.emplace_back(target.flags.substr(at, end - at));
    at = end + 1;
  }
  return flags;
}

}  // namespace plcxx::compile
