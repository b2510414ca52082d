// The files of a program: the main source, what it includes, and the product's headers (specification 1, 9.1).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/parser/kept_program.h"
#include "transpiler/dialects/hnc/source/source_text.h"

namespace plcxx::hnc {

/// How sources of the dialect are read.
source::LoadOptions LoadOptionsOf(std::optional<source::Encoding> chosen);

class ProgramFiles {
 public:
  /// `reuse` may be null. `loaded`: what was loaded before by this path, and what is loaded.
  ProgramFiles(dialects::Request& request, const Settings& settings, LoadedFiles& loaded, Reuse* reuse);

  /// The main source's name below kMainFolder.
  const std::string& main_name() const { return main_name_; }
  /// By a path below one of the folders of module.h, in any letter case, with '/' or '\'. Null where there is no
  /// such file.
  const SourceText* Open(const std::string& path);
  /// Another name of the system header: an include that cannot be found is taken for it.
  void TakeForSystemHeader(std::string name) { assumed_header_ = std::move(name); }
  /// Has some include given the system header?
  bool system_header_read() const { return system_header_read_; }
  const SourceText& main() const { return *main_; }
  /// Those of the program itself.
  std::vector<const SourceText*> texts() const;

 private:
  const SourceText* OpenProduct(const std::string& name);
  const SourceText* OpenBelow(const std::string& folder, const std::string& path);
  std::unique_ptr<SourceText> TextOf(source::FileId file);

  dialects::Request& request_;
  Settings settings_;
  LoadedFiles& loaded_;
  Reuse* reuse_;
  std::string main_folder_;  // of the main source, with its '/' or empty
  std::string main_name_;
  std::string assumed_header_;
  bool system_header_read_ = false;
  const SourceText* main_ = nullptr;
  std::map<std::string, const SourceText*> known_;            // by path
  std::map<std::string, std::unique_ptr<SourceText>> texts_;  // by the file's path, or the header's name
};

}  // namespace plcxx::hnc
