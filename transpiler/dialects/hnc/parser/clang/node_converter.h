// What all parts of the converter share: the program that is made, and the way from Clang's tree and its places to it.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>
#include <clang/AST/Stmt.h>

#include <string>
#include <unordered_map>
#include <unordered_set>

#include "transpiler/dialects/hnc/parser/clang/body_recorder.h"
#include "transpiler/dialects/hnc/parser/clang/extents.h"
#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {

/// Clang's tree on its way to ours.
struct Conversion {
  Session& session;
  Extents extents{};
  BodyRecorder recorder{};
  FunctionId function{};                                                // the one whose body is converted
  std::unordered_map<std::string, const clang::NamedDecl*> expected{};  // by name: what the product declares
  std::unordered_set<std::string> bodies{};     // functions that have one, also where it was refused
  std::unordered_set<std::string> undefined{};  // names that were reported
};

/// What a part of the converter sees. Refers to the conversion.
class NodeConverter {
 public:
  explicit NodeConverter(Conversion& conversion)
      : now_(conversion),
        session_(conversion.session),
        context_(conversion.session.clang.getASTContext()),
        unit_(conversion.session.output.unit) {}

 protected:
  Findings& findings() { return session_.findings(); }
  source::Range RangeOf(const clang::Expr* expr) const {
    return session_.places.Of(now_.extents.BeginOf(expr), now_.extents.EndOf(expr));
  }
  source::Range NameOf(const clang::NamedDecl* declaration) const {
    return session_.places.OfToken(declaration->getLocation());
  }
  std::string Written(source::Range range) const { return session_.input.text(range); }
  bool InProduct(const clang::Decl* declaration) const { return session_.places.InProduct(declaration->getLocation()); }
  /// What the product declares for the name; null where it has nothing of this kind.
  template <class Declaration>
  const Declaration* Expected(const std::string& name) const {
    const auto expected = now_.expected.find(name);
    return expected == now_.expected.end() ? nullptr : llvm::dyn_cast<Declaration>(expected->second);
  }
  bool IsPoison(ExprId expr) const { return unit_.expressions[expr].kind == ExprKind::kPoison; }

  /// Clang's own code of the function that is converted does what the language does not say.
  void NoteThatClangDiffers(const char* reason) {
    if (now_.function.valid()) unit_.functions[now_.function].clang_differs = reason;
  }

  Conversion& now_;
  Session& session_;
  clang::ASTContext& context_;
  Unit& unit_;
};

}  // namespace plcxx::hnc
