// The module's one function: text to tokens to Clang's tree to ours.
#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclLookups.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Parse/ParseAST.h>
#include <clang/Parse/Parser.h>
#include <clang/Sema/Scope.h>
#include <clang/Sema/Sema.h>

#include <memory>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/converter.h"
#include "transpiler/dialects/hnc/parser/clang/record_layout.h"
#include "transpiler/dialects/hnc/parser/clang/session.h"
#include "transpiler/support/beside_work.h"

namespace plcxx::hnc {
namespace {

/// Clang and the conversion follow the nesting of the program by recursion: chains of `else if`, sums and assignments
/// have no limit of their own.
constexpr size_t kStackBytes = size_t{512} << 20;

std::string_view KindOf(const clang::Token& token) {
  if (token.is(clang::tok::identifier)) return "name";
  if (token.getIdentifierInfo() != nullptr) return "keyword";
  if (token.is(clang::tok::numeric_constant)) return "number";
  if (token.is(clang::tok::char_constant)) return "character";
  if (token.is(clang::tok::string_literal)) return "string";
  return "sign";
}

void PutTokens(Session& session) {
  for (const clang::Token& token : session.tokens) {
    if (token.is(clang::tok::eof) || session.places.InProduct(token.getLocation())) continue;
    session.output.tokens.push_back(
        {session.places.Of(token.getLocation()), KindOf(token), session.clang.getPreprocessor().getSpelling(token)});
  }
}

/// Counts how often a name is declared at file level: Clang walks through all its declarations at the next one, and has
/// no message for most of them.
class Repetitions {
 public:
  explicit Repetitions(Session& session) : session_(session) {}

  void Count(clang::DeclGroupRef group) {
    for (const clang::Decl* declaration : group) {
      const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
      if (named == nullptr || named->getIdentifier() == nullptr) continue;
      if (session_.stopped || session_.places.InProduct(named->getLocation())) continue;
      if (++counts_[named->getIdentifier()] <= kMost) continue;
      session_.findings().SetPhase(Phase::kMeaning);
      session_.findings().Report(session_.places.OfToken(named->getLocation()), diag::HncRedefinition,
                                 named->getNameAsString());
      session_.Stop();
    }
  }

 private:
  static constexpr uint32_t kMost = 1000;

  Session& session_;
  std::unordered_map<const clang::IdentifierInfo*, uint32_t> counts_;  // only asked
};

void NoteUnclean(Session& session, clang::DeclGroupRef group) {
  for (const clang::Decl* declaration : group) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) session.unclean.insert(function);
  }
}

void Run(const ParserInput& input, ParseUntil until, ParserOutput& output) {
  Session session(input, until, output);
  SetUp(session);
  Preprocess(session);
  FilterTokens(session);
  if (until == ParseUntil::kTokens) return PutTokens(session);
  ParseTokens(session);
  if (session.stopped) output.can_keep = output.kept_fits = false;
}

/// Clang declares names of its own before the first token.
void ForgetOwnNames(clang::Sema& sema) {
  const std::vector<clang::Decl*> declarations(sema.TUScope->decls().begin(), sema.TUScope->decls().end());
  for (clang::Decl* declaration : declarations) {
    auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
    if (named == nullptr || !named->getDeclName()) continue;
    sema.TUScope->RemoveDecl(named);
    sema.IdResolver.RemoveDecl(named);
  }
}

/// What a body declares, and what is declared at file level, too, or in other bodies: they are one object.
void CollectOpenNames(Session& session) {
  const clang::ASTContext& context = session.clang.getASTContext();
  std::vector<std::string>& names = session.output.open_names;
  for (const auto& found : context.getExternCContextDecl()->noload_lookups(/*PreserveInternalState=*/true)) {
    for (const clang::NamedDecl* declaration : found) names.push_back(declaration->getNameAsString());
  }
  const auto is_within = [](const clang::Decl* declaration) {
    return declaration != nullptr && !declaration->getLexicalDeclContext()->isTranslationUnit();
  };
  for (const clang::Decl* declaration : context.getTranslationUnitDecl()->decls()) {
    const bool function = llvm::isa<clang::FunctionDecl>(declaration);
    if (!function && !llvm::isa<clang::VarDecl>(declaration)) continue;
    const bool open = is_within(declaration) || is_within(declaration->getPreviousDecl()) ||
                      is_within(declaration->getMostRecentDecl()) || (function && declaration->isImplicit());
    if (open) names.push_back(llvm::cast<clang::NamedDecl>(declaration)->getNameAsString());
  }
}

}  // namespace

void Session::Stop() {
  stopped = true;
  for (clang::Token& token : tokens) {
    const clang::SourceLocation place = token.getLocation();
    token.startToken();
    token.setKind(clang::tok::eof);
    token.setLocation(place);
  }
}

void ParseTokens(Session& session) {
  clang::CompilerInstance& clang = session.clang;
  clang.createASTContext();
  clang.getASTContext().setExternalSource(llvm::makeIntrusiveRefCnt<RecordLayouts>());
  auto declarations = std::make_unique<Declarations>();
  const Declarations& all = *declarations;
  clang.setASTConsumer(std::move(declarations));
  clang.createSema(clang::TU_Complete, nullptr);
  clang::Sema& sema = clang.getSema();
  clang::Preprocessor& preprocessor = clang.getPreprocessor();
  preprocessor.EnterTokenStream(session.tokens, /*DisableMacroExpansion=*/true, /*IsReinject=*/true);
  {
    clang::Parser parser(preprocessor, sema, /*SkipFunctionBodies=*/false);
    session.parser = &parser;
    parser.Initialize();
    ForgetOwnNames(sema);
    clang::Parser::DeclGroupPtrTy group;
    clang::Sema::ModuleImportState imports = clang::Sema::ModuleImportState::NotACXX20Module;
    clang::ASTConsumer& consumer = clang.getASTConsumer();
    Repetitions repetitions(session);
    size_t found = session.findings().all().size();
    uint32_t errors = session.errors;
    for (bool at_end = parser.ParseFirstTopLevelDecl(group, imports); !at_end;
         at_end = parser.ParseTopLevelDecl(group, imports)) {
      const bool clean = found == session.findings().all().size() && errors == session.errors;
      found = session.findings().all().size();
      errors = session.errors;
      if (!group) continue;
      if (!clean) NoteUnclean(session, group.get());
      repetitions.Count(group.get());
      consumer.HandleTopLevelDecl(group.get());
    }
    session.parser = nullptr;
    sema.ActOnEndOfTranslationUnit();
  }
  // About as many expressions as tokens, and growing copies all of them again and again; the tokens are read.
  constexpr size_t kTokensOfStatement = 8;
  size_t expressions = session.tokens.size(), statements = session.tokens.size() / kTokensOfStatement;
  if (session.input.kept != nullptr) {
    expressions += session.input.kept->unit->expressions.size();
    statements += session.input.kept->unit->statements.size();
    // Not other memory each time that a few more are needed.
    constexpr size_t kStep = size_t{1} << 14;
    expressions = (expressions / kStep + 1) * kStep;
    statements = (statements / kStep + 1) * kStep;
  }
  session.output.unit.expressions.Reserve(expressions);
  session.output.unit.statements.Reserve(statements);
  session.tokens = {};
  session.findings().SetPhase(Phase::kMeaning);
  if (session.input.keeps_bodies) CollectOpenNames(session);
  Conversion conversion{.session = session};
  Converter(conversion).Run();
  if (session.until == ParseUntil::kCode) session.output.bitcode = GenerateCode(session, all);
}

}  // namespace plcxx::hnc

extern "C" __attribute__((visibility("default"))) void plcxx_hnc_parse(const plcxx::hnc::ParserInput& input,
                                                                       plcxx::hnc::ParseUntil until,
                                                                       plcxx::hnc::ParserOutput& output) {
  plcxx::support::RunOnDeepStack(plcxx::hnc::kStackBytes, [&] { plcxx::hnc::Run(input, until, output); });
}
