#include "transpiler/scenarios/heading.h"

#include <filesystem>
#include <vector>

#include "transpiler/project/reach.h"
#include "transpiler/yaml/words.h"

namespace plcxx::scenarios {
namespace {

std::string HeadingWord(const std::string& text) { return yaml::YamlWord(text, "_./"); }

std::string PathFrom(const std::string& directory, const std::filesystem::path& path) {
  const std::filesystem::path full = std::filesystem::absolute(path);
  const std::filesystem::path from = std::filesystem::absolute(directory.empty() ? "." : directory);
  const std::filesystem::path relative = full.lexically_normal().lexically_relative((from / "").lexically_normal());
  return relative.empty() ? full.generic_string() : relative.generic_string();
}

/// `path`, which the request names, from `directory`.
std::string PathFrom(const std::string& directory, const compilation::CompilationRequest& request,
                     const std::string& path) {
  return PathFrom(directory, std::filesystem::path(request.base_directory) / path);
}

}  // namespace

std::string ScenarioHeading(const compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                            const std::string& directory) {
  std::vector<std::string> sources;
  std::string names, texts, separator;
  for (const std::string& source : request.sources) {
    if (const auto written = request.texts.find(source); written != request.texts.end()) {
      const std::string name = std::filesystem::path(source).filename().string();
      texts += "\n  " + HeadingWord(name) + ": " + yaml::YamlText(written->second, 4);
      continue;
    }
    sources.push_back(PathFrom(directory, request, source));
    names += separator + HeadingWord(sources.back());
    separator = ", ";
  }
  std::string text = project::ReplayComment(directory, sources) + "dialect: " + std::string(compilation.dialect->name) +
                     "\nsources:" + (texts.empty() ? " [" + names + "]" : texts) + "\n";
  separator.clear();
  std::string options;
  for (const auto& [key, value] : compilation.options) {
    std::string written = value;
    // A file that the option names stands where the sources do.
    const std::filesystem::path file = std::filesystem::path(request.base_directory) / value;
    std::error_code none;
    if (!value.empty() && std::filesystem::is_regular_file(file, none)) written = PathFrom(directory, request, value);
    options += separator + HeadingWord(key) + ": " + HeadingWord(written);
    separator = ", ";
  }
  if (request.encoding) options += separator + "encoding: " + std::string(source::Name(*request.encoding));
  if (!options.empty()) text += "options: {" + options + "}\n";
  return text;
}

std::string PlantHeading(const BoundPlant* plant, const std::string& directory) {
  if (plant == nullptr) return {};
  return "plant: " + HeadingWord(PathFrom(directory, plant->model().path())) + "\n";
}

}  // namespace plcxx::scenarios
