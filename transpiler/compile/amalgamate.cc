#include "transpiler/compile/amalgamate.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/support/check.h"

namespace plcxx::compile {
namespace {

std::string_view RuntimeHeader(std::string_view name) {
  for (const RuntimeFile& header : RuntimeFiles()) {
    if (header.name == name) return header.text;
  }
  PLCXX_UNREACHABLE();  // the printer includes what is embedded
}

/// Letters in upper case, what is no letter or digit as '_'.
std::string InCapitals(std::string_view text) {
  std::string capitals;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    capitals += std::isalnum(letter) != 0 ? static_cast<char>(std::toupper(letter)) : '_';
  }
  return capitals;
}

/// Texts after each other, each included file once, where it is included first.
class Joiner {
 public:
  void Add(std::string_view text) {
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find('\n', at), text.size());
      Line(text.substr(at, end - at));
      at = end + 1;
    }
  }
  std::string Take() { return std::move(out_); }

 private:
  void Line(std::string_view line) {
    constexpr std::string_view kInclude = "#include ";
    if (line == "#pragma once") return;
    if (!line.starts_with(kInclude)) {
      // Where includes were, no more than one empty line stays.
      if (line.empty() && out_.ends_with("\n\n")) return;
      out_ += std::string(line) + "\n";
      return;
    }
    const std::string_view name = line.substr(kInclude.size() + 1, line.size() - kInclude.size() - 2);
    if (!included_.emplace(name).second) return;
    constexpr std::string_view kRuntime = "plcxx/";
    if (name.starts_with(kRuntime)) {
      // A source may include several programs.
      const std::string guard = "PLCXX_RUNTIME_" + InCapitals(name.substr(kRuntime.size()));
      out_ += "#ifndef " + guard + "\n#define " + guard + "\n";
      Add(RuntimeHeader(name));
      out_ += "#endif  // " + guard + "\n\n";
    } else if (line.find('<') != std::string_view::npos) {
      out_ += std::string(line) + "\n";
    }  // else the program's own header, which stands above
  }

  std::string out_;
  std::set<std::string, std::less<>> included_;
};

}  // namespace

std::string ImplementationMacro(const std::string& program) {
  std::string macro = InCapitals(program);
  if (std::isdigit(static_cast<unsigned char>(macro.front())) != 0) macro.insert(0, "PLCXX_");
  return macro + "_IMPLEMENTATION";
}

emit::OutputFile Amalgamate(const std::vector<emit::OutputFile>& files, const std::string& program) {
  PLCXX_CHECK(files.size() == 2);
  const std::string macro = ImplementationMacro(program);
  Joiner joined;  // of whose texts the #pragma lines are left out
  joined.Add(files[0].text);
  joined.Add("\n#ifdef " + macro + "\n\n");
  joined.Add(files[1].text);
  joined.Add("\n#endif  // " + macro + "\n");
  const std::string head =
      "// The whole program in one file: include it where it is needed, and in exactly one source with\n//   #define " +
      macro + "\n// in front of the #include: that source holds the code.\n#pragma once\n\n";
  return {files[0].name, head + joined.Take()};
}

}  // namespace plcxx::compile
