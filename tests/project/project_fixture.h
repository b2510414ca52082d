// A folder with files and a plcxx.yaml, and what the reader says of it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/project/project.h"

namespace plcxx::project {

class Folder {
 public:
  Folder() {
    for (const char* name : {"a.sym", "b.plc", "c.plc"}) directory_.Write(name, "$\n");
  }

  void Write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories(std::filesystem::path(Path(name)).parent_path());
    directory_.Write(name, text);
  }
  std::string Path(std::string_view name) const { return directory_.File(name); }

  ProjectOrErrors Read(std::string_view text, Reach reach = Reach::kProject) const {
    Write("plcxx.yaml", text);
    return ReadProject(Path("plcxx.yaml"), reach);
  }

  /// "3:7: message\n  help: remedy", without the path of the folder.
  std::vector<std::string> Errors(std::string_view text) const {
    std::vector<std::string> lines;
    const ProjectOrErrors read = Read(text);
    if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
      for (yaml::Error error : *errors) {
        error.path.clear();
        std::string line = ToText(error).substr(1);
        for (size_t at; (at = line.find(directory_.path().string())) != std::string::npos;)
          line.replace(at, directory_.path().string().size(), "DIR");
        lines.push_back(std::move(line));
      }
    }
    return lines;
  }

  /// The only program; paths below the folder are without it.
  Program Only(std::string_view text) const {
    ProjectOrErrors read = Read(text);
    if (auto* project = std::get_if<Project>(&read)) return project->programs.at(0);
    return {.name = Errors(text).at(0)};
  }

 private:
  testing_support::TemporaryDirectory directory_;
};

}  // namespace plcxx::project
