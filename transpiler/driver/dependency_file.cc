#include "transpiler/driver/dependency_file.h"

namespace plcxx::driver {
namespace {

std::string EscapedForMake(const std::string& path) {
  std::string escaped;
  for (size_t i = 0; i < path.size(); ++i) {
    switch (path[i]) {
      case ' ':
      case '\t':
        // Make reads backslashes before a blank as escapes, elsewhere as themselves.
        for (size_t j = i; j > 0 && path[j - 1] == '\\'; --j) escaped += '\\';
        escaped += '\\';
        break;
      case '#':
        escaped += '\\';
        break;
      case '$':
        escaped += '$';
        break;
      default:
        break;
    }
    escaped += path[i];
  }
  return escaped;
}

}  // namespace

std::string DependencyRule(const std::vector<std::string>& targets, const std::vector<std::string>& dependencies) {
  std::string rule;
  for (const std::string& target : targets) rule += (rule.empty() ? "" : " ") + EscapedForMake(target);
  rule += ":";
  for (const std::string& dependency : dependencies) rule += " \\\n  " + EscapedForMake(dependency);
  return rule + "\n";
}

}  // namespace plcxx::driver
