// What Clang itself makes of the program, for plcxx verify: unoptimized code for a processor with 16-bit int, from the
// very tokens that the tree is made of.
#include <clang/Basic/TargetInfo.h>
#include <clang/Basic/Version.h>
#include <clang/CodeGen/ModuleBuilder.h>
#include <clang/Frontend/CompilerInstance.h>
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/raw_ostream.h>

#include <memory>

#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {
namespace {

/// Where C leaves the order of a call's arguments open, the language says from right to left (6.2), as Clang does for
/// Microsoft's ABI. That ABI would also lay out structures in its own way: those of the tree have their layouts by now.
struct OrderOfArguments : clang::TargetInfo {
  static void FromRightToLeft(clang::TargetInfo& target) {
    (target.*(&OrderOfArguments::TheCXXABI)).set(clang::TargetCXXABI::Microsoft);
  }
};

}  // namespace

std::string GenerateCode(Session& session, const Declarations& declarations) {
  clang::CompilerInstance& clang = session.clang;
  if (clang.getDiagnostics().hasErrorOccurred() || session.stopped) return {};
  OrderOfArguments::FromRightToLeft(clang.getTarget());
  llvm::LLVMContext context;
  const std::unique_ptr<clang::CodeGenerator> generator(clang::CreateLLVMCodeGen(
      clang.getDiagnostics(), "program", &clang.getVirtualFileSystem(), clang.getHeaderSearchOpts(),
      clang.getPreprocessorOpts(), clang.getCodeGenOpts(), context));
  generator->Initialize(clang.getASTContext());
  for (const clang::DeclGroupRef group : declarations.groups) generator->HandleTopLevelDecl(group);
  for (clang::VarDecl* variable : declarations.tentative) generator->CompleteTentativeDefinition(variable);
  generator->HandleTranslationUnit(clang.getASTContext());
  const std::unique_ptr<llvm::Module> module(generator->ReleaseModule());
  if (module == nullptr) return {};
  session.output.compiler = clang::getClangFullVersion() + " for " + module->getTargetTriple();
  std::string bitcode;
  llvm::raw_string_ostream stream(bitcode);
  llvm::WriteBitcodeToFile(*module, stream);
  return bitcode;
}

}  // namespace plcxx::hnc
