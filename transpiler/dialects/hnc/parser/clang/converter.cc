#include "transpiler/dialects/hnc/parser/clang/converter.h"

#include <algorithm>
#include <charconv>

#include "transpiler/dialects/hnc/machine/product_names.h"

namespace plcxx::hnc {
namespace {

/// Comments such as /*@loop_bound 8@*/ say the same as #pragma plcxx loop_bound(8).
void AddLoopBounds(const std::vector<Comment>& comments, Findings& findings, std::vector<LoopBound>& bounds) {
  constexpr std::string_view kMark = "@loop_bound";
  for (const Comment& comment : comments) {
    std::string_view text = comment.text;
    if (!text.starts_with(kMark)) continue;
    text.remove_prefix(kMark.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    uint32_t rounds = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), rounds);
    if (read.ec == std::errc{} && rounds >= 1 && rounds <= 65535) {
      bounds.push_back({rounds, comment.range});
    } else {
      findings.Report(comment.range, diag::HncPragma, "loop_bound: the bound is a number from 1 to 65535");
    }
  }
}

}  // namespace

void Converter::CollectComments() {
  const std::vector<source::Range>& left_out = session_.output.left_out;
  const auto counts = [&](const Comment& comment) {
    return std::ranges::none_of(left_out, [&](source::Range group) {
      return group.begin <= comment.range.begin && comment.range.begin < group.end;
    });
  };
  for (const std::string& path : session_.output.read) {
    const SourceText* text = session_.input.open(path);
    if (text == nullptr) continue;
    std::ranges::copy_if(text->comments, std::back_inserter(unit_.comments), counts);
  }
  const auto place = [](const Comment& comment) { return comment.range.begin; };
  std::ranges::sort(unit_.comments, {}, place);
  // A file that is included twice is read twice.
  const auto repeated = std::ranges::unique(unit_.comments, {}, place);
  unit_.comments.erase(repeated.begin(), repeated.end());
}

void Converter::Declare(const clang::Decl* declaration) {
  if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration)) {
    if (std::string_view(variable->getName()).starts_with(kProductPrefix)) return;
    if (InProduct(variable)) return;  // when it is used
    if (variable->isInvalidDecl()) return;
    variables_.VariableOf(variable);
    variables_.CheckSystemVariable(variable);
  } else if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
    if (std::string_view(function->getName()).starts_with(kProductPrefix)) return;
    if (InProduct(function) || function->isImplicit()) return;
    functions_.FunctionOf(function);
    functions_.CheckFunction(function);
    if (function->doesThisDeclarationHaveABody()) functions_.Define(function);
  } else if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(declaration)) {
    checker_.CheckMembers(record);
  } else if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(declaration)) {
    checker_.CheckEnumerators(enumeration);
  }
}

std::vector<LoopBound> Converter::CollectLoopBounds() {
  std::vector<LoopBound> bounds = session_.loop_bounds;
  AddLoopBounds(unit_.comments, findings(), bounds);
  std::ranges::sort(bounds, {}, [](const LoopBound& bound) { return bound.range.begin; });
  return bounds;
}

void Converter::CollectNames() {
  for (const clang::Decl* declaration : context_.getTranslationUnitDecl()->decls()) {
    const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
    if (named == nullptr || named->getDeclName().isEmpty()) continue;
    const std::string name = named->getNameAsString();
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration);
    if (function != nullptr && function->doesThisDeclarationHaveABody()) now_.bodies.insert(name);
    if (name.starts_with(kExpectedPrefix)) now_.expected.emplace(name.substr(kExpectedPrefix.size()), named);
  }
}

void Converter::Run() {
  CollectComments();
  statements_.SetLoopBounds(CollectLoopBounds());
  unit_.char_is_signed = context_.getLangOpts().CharIsSigned != 0;
  CollectNames();
  if (!bodies_.CollectNames()) return;
  for (const clang::Decl* declaration : context_.getTranslationUnitDecl()->decls()) Declare(declaration);
  if (!session_.stopped) calls_.CheckCalls();
  CheckEntries();
}

void Converter::CheckEntries() {
  const bool syntax = std::ranges::any_of(findings().all(), [](const Finding& finding) {
    return finding.phase != Phase::kMeaning && finding.row.severity == diag::Severity::kError;
  });
  if (syntax || session_.stopped) return;  // it may stand in what was not understood
  const auto check = [&](FunctionId entry, const char* name) {
    if (!entry.valid()) findings().Report(unit_.last_token, diag::HncMissingEntry, name);
  };
  check(unit_.init, "init");
  check(unit_.plc1, "plc1");
  check(unit_.plc2, "plc2");
}

}  // namespace plcxx::hnc
