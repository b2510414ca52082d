// Clang for the language of Borland C++ 3.1 (specification 3.7): a target with 16-bit int, C of 1989, no structure
// padding, bit-fields that do not straddle units, and no look at the file system but through ParserInput::open.
#include <clang/Basic/FileManager.h>
#include <clang/Basic/TargetInfo.h>
#include <clang/Basic/TargetOptions.h>
#include <clang/Lex/HeaderSearchOptions.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Lex/PreprocessorOptions.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/VirtualFileSystem.h>
#include <llvm/TargetParser/Triple.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/machine/headers.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/diagnoser.h"
#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {
namespace {

constexpr const char* kTriple = "msp430";

class TextFile : public llvm::vfs::File {
 public:
  TextFile(const SourceText& text, llvm::vfs::Status status) : text_(text), status_(std::move(status)) {}
  llvm::ErrorOr<llvm::vfs::Status> status() override { return status_; }
  llvm::ErrorOr<std::unique_ptr<llvm::MemoryBuffer>> getBuffer(const llvm::Twine& name, int64_t /*size*/,
                                                               bool /*terminated*/, bool /*is_volatile*/) override {
    return llvm::MemoryBuffer::getMemBuffer(text_.text, name.str());
  }
  std::error_code close() override { return {}; }

 private:
  const SourceText& text_;
  llvm::vfs::Status status_;
};

/// The files that `open` gives; everything else is a folder, since Clang asks for the folder of a file first.
class TextFileSystem : public llvm::vfs::FileSystem {
 public:
  explicit TextFileSystem(const ParserInput& input) : input_(input) {}

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override {
    const std::string name = path.str();
    if (const SourceText* text = input_.open(name)) return StatusOf(name, *text);
    return llvm::vfs::Status(name, {kFolderDevice, std::hash<std::string>()(name)}, {}, 0, 0, 0,
                             llvm::sys::fs::file_type::directory_file, llvm::sys::fs::perms::all_read);
  }
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override {
    const std::string name = path.str();
    const SourceText* text = input_.open(name);
    if (text == nullptr) return std::make_error_code(std::errc::no_such_file_or_directory);
    return std::unique_ptr<llvm::vfs::File>(std::make_unique<TextFile>(*text, StatusOf(name, *text)));
  }
  llvm::vfs::directory_iterator dir_begin(const llvm::Twine& /*path*/, std::error_code& error) override {
    error = std::make_error_code(std::errc::no_such_file_or_directory);
    return {};
  }
  std::error_code setCurrentWorkingDirectory(const llvm::Twine& /*path*/) override { return {}; }
  llvm::ErrorOr<std::string> getCurrentWorkingDirectory() const override { return std::string(kMainFolder); }

 private:
  static constexpr uint64_t kFileDevice = 1, kFolderDevice = 2;

  static llvm::vfs::Status StatusOf(const std::string& name, const SourceText& text) {
    return {name,
            {kFileDevice, reinterpret_cast<uintptr_t>(&text)},
            {},
            0,
            0,
            text.text.size(),
            llvm::sys::fs::file_type::regular_file,
            llvm::sys::fs::perms::all_read};
  }

  const ParserInput& input_;
};

/// For what Clang computes itself: sums stay apart from products, and variables keep their names.
void SetCode(clang::CompilerInvocation& invocation) {
  invocation.getLangOpts().setDefaultFPContractMode(clang::LangOptions::FPM_Off);
  clang::CodeGenOptions& code = invocation.getCodeGenOpts();
  code.OptimizationLevel = 0;
  code.DisableO0ImplyOptNone = true;
  code.DiscardValueNames = false;
}

void SetLanguage(const ParserInput& input, clang::CompilerInvocation& invocation) {
  clang::LangOptions& language = invocation.getLangOpts();
  std::vector<std::string> includes;
  clang::LangOptions::setLangDefaults(language, clang::Language::C, llvm::Triple(kTriple), includes,
                                      clang::LangStandard::lang_gnu89);
  language.GNUKeywords = 0;  // inline, typeof and asm are names
  language.Digraphs = 0;
  language.DollarIdents = 0;
  language.Trigraphs = 0;
  language.CharIsSigned = input.char_is_signed ? 1 : 0;
  language.setSignedOverflowBehavior(clang::LangOptions::SOB_Defined);
  language.setFPEvalMethod(clang::LangOptions::FEM_Double);  // operands are widened first (6.1)
  language.Freestanding = 1;
  language.NoBuiltin = 1;
  language.PackStruct = 1;
  language.MSBitfields = 1;
  language.SpellChecking = 0;
  language.RecoveryAST = 0;
  language.RecoveryASTType = 0;
  language.BracketDepth = 100000;  // FilterTokens keeps the limit of the language
  for (const std::string_view folder : {kMainFolder, kProductFolder}) {
    language.MacroPrefixMap[std::string(folder) + "/"] = "";
  }
  for (uint32_t i = 0; i < input.include_folders; ++i) {
    language.MacroPrefixMap[std::string(kIncludeFolder) + std::to_string(i) + "/"] = "";
  }
  invocation.getTargetOpts().Triple = kTriple;
}

void SetFolders(const ParserInput& input, clang::HeaderSearchOptions& search) {
  search.Sysroot.clear();
  search.UseBuiltinIncludes = 0;
  search.UseStandardSystemIncludes = 0;
  search.UseStandardCXXIncludes = 0;
  for (uint32_t i = 0; i < input.include_folders; ++i) {
    search.AddPath(std::string(kIncludeFolder) + std::to_string(i), clang::frontend::Angled, false, true);
  }
  search.AddPath(kProductFolder, clang::frontend::Angled, false, true);
}

/// The names that Clang itself gives a meaning in the preprocessor; the language has two of them.
std::vector<std::string> BuiltinNames(const clang::Preprocessor& preprocessor) {
  std::vector<std::string> names;
  for (const auto& macro : preprocessor.macros(false)) {
    const clang::MacroInfo* info = preprocessor.getMacroInfo(macro.first);
    if (info == nullptr || !info->isBuiltinMacro()) continue;
    std::string name = macro.first->getName().str();
    const bool is_own = name == "__LINE__" || name == "__FILE__" || name == "__DATE__" || name == "__TIME__";
    if (!is_own) names.push_back(std::move(name));
  }
  std::ranges::sort(names);
  return names;
}

/// 2.7; the declarations are for what FilterTokens writes.
std::string Predefines(const ParserInput& input, const clang::Preprocessor& preprocessor) {
  std::string text =
      "#define __TURBOC__ 0x0410\n#define __BORLANDC__ 0x0410\n#define __MSDOS__ 1\n#define __TINY__ 1\n"
      "#define __CDECL__ 1\n#define __PLCXX__ 1\n"
      "#define __DATE__ \"Jan 01 1980\"\n#define __TIME__ \"00:00:00\"\n";
  for (const std::string& name : BuiltinNames(preprocessor)) text += "#undef " + name + "\n";
  if (!input.char_is_signed) text += "#define _CHAR_UNSIGNED 1\n";
  text += "void " + std::string(kCliName) + "(void);\nvoid " + std::string(kStiName) + "(void);\nextern int " +
          std::string(kPoisonName) + ";\n";
  text += ExpectedDeclarations(kExpectedPrefix);
  for (const dialects::MacroOption& macro : input.macros) {
    text += macro.text ? "#define " + macro.name + " " + *macro.text + "\n" : "#undef " + macro.name + "\n";
  }
  return text;
}

}  // namespace

void SetUp(Session& session) {
  clang::CompilerInstance& clang = session.clang;
  auto invocation = std::make_shared<clang::CompilerInvocation>();
  SetLanguage(session.input, *invocation);
  if (session.until == ParseUntil::kCode) SetCode(*invocation);
  SetFolders(session.input, invocation->getHeaderSearchOpts());
  clang.setInvocation(std::move(invocation));

  clang.createDiagnostics(new Diagnoser(session), /*ShouldOwnClient=*/true);
  clang::DiagnosticsEngine& diagnostics = clang.getDiagnostics();
  diagnostics.setExtensionHandlingBehavior(clang::diag::Severity::Warning);  // much of 3.5 is known by these
  diagnostics.setFatalsAsError(true);
  diagnostics.setErrorLimit(0);
  // Accepted here or found in the tree; as errors they would cost parts of it.
  for (const char* group : {"int-conversion", "incompatible-pointer-types", "incompatible-function-pointer-types",
                            "return-mismatch", "implicit-int", "implicit-function-declaration"}) {
    diagnostics.setSeverityForGroup(clang::diag::Flavor::WarningOrError, group, clang::diag::Severity::Warning);
  }

  clang.setTarget(clang::TargetInfo::CreateTargetInfo(diagnostics, clang.getInvocation().TargetOpts));
  clang.createFileManager(llvm::makeIntrusiveRefCnt<TextFileSystem>(session.input));
  clang.createSourceManager(clang.getFileManager());
  const std::string main = std::string(kMainFolder) + "/" + session.input.main_path;
  clang.InitializeSourceManager(clang::FrontendInputFile(main, clang::InputKind(clang::Language::C)));
  clang.createPreprocessor(clang::TU_Complete);
  clang.getPreprocessor().setPredefines(Predefines(session.input, clang.getPreprocessor()));
  clang.getDiagnosticClient().BeginSourceFile(clang.getLangOpts(), &clang.getPreprocessor());
}

}  // namespace plcxx::hnc
