// What a body needs beside its own expressions and statements, noted while it is converted (kept_bodies.h).
#pragma once

#include <clang/AST/Decl.h>
#include <llvm/ADT/DenseMap.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/parser/kept_bodies.h"

namespace plcxx::hnc {

/// Declarations at file level by their names: how a body that is taken over finds them again. Null: several.
struct FileNames {
  template <class Declaration>
  using ByName = llvm::DenseMap<const clang::IdentifierInfo*, const Declaration*>;

  void Add(const clang::NamedDecl* declaration);

  ByName<clang::FunctionDecl> functions;
  ByName<clang::VarDecl> variables;
  ByName<clang::RecordDecl> tags;
  ByName<clang::RecordDecl> typedefs;  // of records without a tag
};

class BodyRecorder {
 public:
  /// A body begins, as number serial() > 0.
  void Begin(uint32_t index) {
    index_ = index;
    ++serial_;
    is_recording_ = true;
    is_reusable_ = true;
    needs_.clear();
  }
  /// Its needs in their order.
  std::vector<Need> End() {
    is_recording_ = false;
    return std::move(needs_);
  }

  bool is_recording() const { return is_recording_; }
  bool is_reusable() const { return is_reusable_; }
  /// Of the body among ParserOutput::bodies.
  uint32_t index() const { return index_; }
  /// What was last noted with this number is noted; 0 for what never was.
  uint32_t serial() const { return serial_; }

  void Add(NeedKind kind, uint32_t id, std::string text = {}) { needs_.push_back({kind, id, std::move(text)}); }
  /// The body has to be read again each time.
  void Refuse() { is_reusable_ = false; }

  FileNames names;

 private:
  uint32_t serial_ = 0, index_ = 0;
  bool is_recording_ = false, is_reusable_ = false;
  std::vector<Need> needs_;
};

}  // namespace plcxx::hnc
