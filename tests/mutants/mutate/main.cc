// plcxx_mutate --first N --out DIR --table FILE --root DIR FILE... -- COMPILER-OPTION...
//
// Rewrites the files, which are read as one translation unit, into DIR (their paths below the root), and appends a line
// for each mutant to the table: id, file, line, function, kind, text, with tabs between.

#include <clang/AST/ASTConsumer.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Tooling/Tooling.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/mutants/mutate/sites.h"

namespace plcxx::mutants {
namespace {

namespace fs = std::filesystem;

struct Request {
  unsigned first = 1;
  fs::path out, table, root;
  std::vector<std::string> files, options;
};

Request ReadArguments(int count, char** values) {
  Request request;
  int i = 1;
  for (; i < count && std::strcmp(values[i], "--") != 0; ++i) {
    const std::string word = values[i];
    const bool takes = word.starts_with("--") && i + 1 < count;
    if (!takes) {
      request.files.push_back(word);
      continue;
    }
    const std::string value = values[++i];
    if (word == "--first") request.first = static_cast<unsigned>(std::stoul(value));
    if (word == "--out") request.out = value;
    if (word == "--table") request.table = value;
    if (word == "--root") request.root = value;
  }
  for (++i; i < count; ++i) request.options.push_back(values[i]);
  return request;
}

void Write(const Request& request, const Rewritten& rewritten) {
  std::ofstream table(request.table, std::ios::app);
  for (const Mutant& mutant : rewritten.mutants) {
    table << mutant.id << '\t' << fs::path(mutant.file).lexically_relative(request.root).generic_string() << '\t'
          << mutant.line << '\t' << mutant.function << '\t' << mutant.kind << '\t' << mutant.text << '\n';
  }
  for (const auto& [path, edits] : rewritten.files) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const fs::path target = request.out / fs::path(path).lexically_relative(request.root);
    fs::create_directories(target.parent_path());
    std::ofstream(target, std::ios::binary) << "#include \"tests/mutants/mutation_points.h\"\n" << edits.Apply(text);
  }
}

class Consumer : public clang::ASTConsumer {
 public:
  explicit Consumer(const Request& request) : request_(request) {}
  void HandleTranslationUnit(clang::ASTContext& context) override {
    if (!context.getDiagnostics().hasErrorOccurred())
      Write(request_, FindSites(context, request_.files, request_.first));
  }

 private:
  const Request& request_;
};

class Action : public clang::ASTFrontendAction {
 public:
  explicit Action(const Request& request) : request_(request) {}
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&, llvm::StringRef) override {
    return std::make_unique<Consumer>(request_);
  }

 private:
  const Request& request_;
};

int Run(int count, char** values) {
  const Request request = ReadArguments(count, values);
  std::string text;
  for (const std::string& file : request.files) text += "#include \"" + file + "\"\n";
  std::vector<std::string> options = request.options;
  options.emplace_back("-w");
  const bool done = clang::tooling::runToolOnCodeWithArgs(std::make_unique<Action>(request), text, options,
                                                          "mutated.cc", "plcxx_mutate");
  return done ? 0 : 1;
}

}  // namespace
}  // namespace plcxx::mutants

int main(int count, char** values) { return plcxx::mutants::Run(count, values); }
