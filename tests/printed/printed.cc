#include "tests/printed/printed.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "tests/printed/groups.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::printed {
namespace {

/// A program without statements, of each language.
struct Plain {
  std::string_view dialect, file, text;
};
constexpr std::array kPlain = {
    Plain{"nc110", "p.plc", "$\n"},
    Plain{"technol", "p.plc", "        MODULE_MAIN\n        MODULE_MAIN_END\n        STOP\n"},
    Plain{"host50", "p.il", "SLOW\nEND_SLOW\n"},
    Plain{"prostep", "p.plc", ":MOD PM 0\n:END PM 0\n"},
    Plain{"hnc", "p.cld", "#include \"plc.h\"\nvoid init() { }\nvoid plc1() { }\nvoid plc2() { }\n"},
};

const Phase* PhaseByName(std::string_view name) {
  const auto found = std::ranges::find(Phases(), name, &Phase::name);
  return found == Phases().end() ? nullptr : &*found;
}

std::string ReadText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Printed once for each language and phase.
const std::string& OfPlainProgram(const Phase& phase, std::string_view dialect) {
  static std::map<std::pair<std::string_view, std::string_view>, std::string> printed;
  const auto* const plain = std::ranges::find(kPlain, dialect, &Plain::dialect);
  static const std::string nothing;
  if (plain == kPlain.end()) return nothing;
  const auto [found, is_new] = printed.try_emplace({phase.name, plain->dialect});
  if (is_new) {
    Input input;
    input.request.dialect = plain->dialect;
    input.request.sources = {std::string(plain->file)};
    input.request.texts = {{std::string(plain->file), std::string(plain->text)}};
    found->second = phase.print(input);
  }
  return found->second;
}

}  // namespace

std::optional<Input> InputOf(const fs::path& file) {
  Input input;
  if (file.extension() == ".ir") {
    input.ir = ReadText(file);
    return input;
  }
  if (file.extension() == ".c") {
    const std::string name = file.filename().string();  // no place of this machine is in what is printed
    input.request.sources = {name};
    const std::string text = ReadText(file);
    const bool includes = text.find("#include \"plc.h\"") != std::string::npos;  // else it is avr-gcc's, too
    input.request.texts = {{name, includes ? text : "#include \"plc.h\"\n" + text}};
    input.request.dialect = "hnc";
    return input;
  }
  const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(file.string());
  const auto* const scenario = std::get_if<scenarios::Scenario>(&read);
  if (scenario == nullptr) return std::nullopt;
  input.request = scenarios::RequestOf(*scenario, {});
  return input;
}

std::string OwnTextOf(const Phase& phase, const Input& input) {
  return OwnLines(phase.print(input), {OfPlainProgram(phase, input.request.dialect)});
}

std::vector<Row> ReadCorpus(const fs::path& file) {
  std::vector<Row> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const size_t space = line.find(' ');
    if (line.empty() || line.front() == '#' || space == std::string::npos) continue;
    Row row{{}, line.substr(space + 1)};
    std::istringstream phases(line.substr(0, space));
    for (std::string phase; std::getline(phases, phase, ',');) row.phases.push_back(phase);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string_view> PhaseNames() {
  std::vector<std::string_view> names;
  for (const Phase& phase : Phases()) names.push_back(phase.name);
  return names;
}

std::string PrintedText(const fs::path& root, const Row& row) {
  const std::optional<Input> input = InputOf(root / row.path);
  if (!input) return "cannot be read: " + row.path + '\n';
  std::map<std::string_view, std::string> printed;
  const auto print = [&](const Phase& phase) -> const std::string& {
    const auto [found, is_new] = printed.try_emplace(phase.name);
    if (is_new) found->second = phase.print(*input);
    return found->second;
  };
  std::string text;
  for (const std::string& name : row.phases) {
    const Phase* const phase = PhaseByName(name);
    if (phase == nullptr) return "no phase: " + name + '\n';
    const std::vector<std::string_view> known = {OfPlainProgram(*phase, input->request.dialect)};
    if (const Phase* const beside = PhaseByName(phase->beside)) {
      // What is added in the middle of a statement gives all later values other numbers.
      const std::string own = WithoutNumbers(print(*phase)), other = WithoutNumbers(print(*beside)),
                        plain = WithoutNumbers(known.front());
      text += "=== " + name + '\n' + OwnLines(own, {plain, other});
    } else {
      text += "=== " + name + '\n' + OwnLines(print(*phase), known);
    }
  }
  return text;
}

}  // namespace plcxx::printed
