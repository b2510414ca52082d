#include "tests/reference/spellings.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

#include "tests/reference/runs.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/ir/printer.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::reference {
namespace {

bool IsWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '~' || c == '.' || c == '-' || c < 0;
}

/// The line with its words replaced; texts in quotes are left out.
template <class Replace>
std::string WithWords(const std::string& line, Replace&& replace) {
  std::string text;
  for (size_t i = 0; i < line.size();) {
    if (line[i] == '"') {
      i = line.find('"', i + 1);
      i = i == std::string::npos ? line.size() : i + 1;
    } else if (!IsWordCharacter(line[i])) {
      text += line[i++];
    } else {
      size_t end = i;
      while (end < line.size() && IsWordCharacter(line[end])) ++end;
      text += replace(line.substr(i, end - i));
      i = end;
    }
  }
  return text;
}

/// "0x1F" -> "31".
std::string Decimal(const std::string& word) {
  if (!word.starts_with("0x")) return word;
  return std::to_string(std::stoull(word.substr(2), nullptr, 16));
}

struct Compiled {
  scenarios::Scenario scenario;
  compilation::Compilation compilation;
};

std::variant<std::string, Compiled> CompileIn(const RandomProgram& program, std::string_view dialect,
                                              const std::string& directory) {
  std::filesystem::create_directories(directory);
  std::string scenario_text;
  for (const RenderedFile& file : Render(program, std::string(dialect))) {
    std::ofstream(directory + "/" + file.name, std::ios::binary) << file.text;
    scenario_text = file.text;
  }
  const scenarios::ScenarioOrErrors read = scenarios::ParseScenario(directory + "/scenario.yaml", scenario_text);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) return ToText(errors->front());
  const auto& scenario = std::get<scenarios::Scenario>(read);
  compilation::Compilation compilation = compilation::Compile(scenarios::RequestOf(scenario, {}));
  if (compilation.ok()) return Compiled{scenario, std::move(compilation)};
  return diag::RenderText(*compilation.sources, compilation.diagnostics.all(), {});
}

}  // namespace

std::string WithoutSpelling(const std::string& printed) {
  std::map<std::string, std::string> names, states;
  std::set<std::string> ids;
  std::string text;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, name, rest;
    words >> keyword >> name;
    if (keyword == "program") continue;
    if (keyword == "statement") {
      ids.insert(std::to_string(std::stoull(name.substr(1, name.find('~') - 1), nullptr, 16)));
      continue;
    }
    if (keyword == "stmt") continue;  // a comment has one of its own
    if (keyword == "state") {
      words >> rest;
      states[name] = "<" + rest + " " + std::to_string(states.size()) + ">";
      text += rest + "\n";
      continue;
    }
    if (keyword == "place") {
      std::getline(words, rest);
      rest = rest.substr(0, std::min(rest.find(" address "), rest.find(" named ")));
      names[name] = "<" +
                    WithWords(rest,
                              [&](const std::string& word) {
                                const auto state = states.find(word);
                                return state == states.end() ? word : state->second;
                              }) +
                    ">";
      continue;
    }
    text += WithWords(line, [&](const std::string& word) {
      if (const auto known = names.find(word); known != names.end()) return known->second;
      if (const auto known = states.find(word); known != states.end()) return known->second;
      const std::string number = Decimal(word);
      return ids.contains(number) ? std::string("<statement>") : number;
    });
    text += '\n';
  }
  return text;
}

std::string DifferentSpellings(const ReferenceDialect& dialect, uint64_t seed, ProgramSize size,
                               const std::string& directory) {
  std::string texts[2];
  std::vector<uint64_t> traces[2];
  for (const Spelling spelling : {Spelling::kAny, Spelling::kPlain}) {
    Random random(seed);
    const RandomProgram program = dialect.generate(random, size, spelling);
    const bool is_plain = spelling == Spelling::kPlain;
    auto compiled = CompileIn(program, dialect.name, directory + (is_plain ? "/plain" : "/any"));
    if (const auto* message = std::get_if<std::string>(&compiled)) return *message;
    auto& [scenario, compilation] = std::get<Compiled>(compiled);
    texts[is_plain ? 1 : 0] = WithoutSpelling(ir::Print(compilation.program));
    if (dialect.spelling_cuts_statements) traces[is_plain ? 1 : 0] = TraceOf(scenario, compilation);
  }
  if (texts[0] == texts[1] || (!traces[0].empty() && traces[0] == traces[1])) return "";
  std::istringstream any(texts[0]), plain(texts[1]);
  std::string routine, one, other;
  while (std::getline(any, one) && std::getline(plain, other) && one == other) {
    if (one.starts_with("routine")) routine = one;
  }
  return "seed " + std::to_string(seed) + ", two texts of one program, in " + routine + "\n  any:   " + one +
         "\n  plain: " + other;
}

}  // namespace plcxx::reference
