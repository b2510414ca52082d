// What `plcxx diff` is to compare: two files, two directories, two revisions of git, or what git hands to a diff tool.
//
// In: words of the command line. Out: two requests, or the first thing that is wrong. Revisions are copied into a
// temporary directory, which lives as long as the result.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/project/reach.h"

namespace plcxx::review::diff {

struct DiffWords {
  std::vector<std::string> paths;    // OLD NEW, or with `revisions` the sources
  std::vector<std::string> sources;  // --sources: of both directories, relative to them
  std::string revisions;             // --git A..B
  bool external = false;             // --git-external: paths are the words that git gives to a diff tool
  std::string project;               // with `revisions` and no sources: plcxx.yaml; each revision has its own
  std::string program;               // the name of one of its programs; empty: the only one
  project::Reach reach = project::Reach::kProject;
};

struct DiffRequest {
  std::string label;
  compilation::CompilationRequest compilation;
  std::string hidden_prefix, file_name;  // of paths, see DiffSide
};

struct DiffRequests {
  DiffRequest old_side, new_side;
  std::vector<std::string> not_looked_at;  // see Diff
  std::string one_sided;                   // not empty: git compares a file with none, and this is to be said of it
  std::vector<std::unique_ptr<compile::TemporaryDirectory>> copies;
};

/// Why git has not the versions "A..B" of the work tree's project; empty when it has them.
std::string WhyNoRevisions(const std::string& revisions);

/// `common`: what the options of the command line say for both.
std::variant<DiffRequests, std::string> ResolveDiff(const DiffWords& words,
                                                    const compilation::CompilationRequest& common);

}  // namespace plcxx::review::diff
