#include "transpiler/dialects/hnc/parser/clang/environment.h"

#include <clang/AST/Attr.h>
#include <clang/AST/PrettyPrinter.h>
#include <clang/AST/Type.h>
#include <clang/Lex/Preprocessor.h>
#include <llvm/ADT/DenseSet.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/syntax/characters.h"
#include "transpiler/support/fnv1a.h"

namespace plcxx::hnc {
namespace {

clang::PrintingPolicy WithoutPlaces(const clang::ASTContext& context) {
  clang::PrintingPolicy policy = context.getPrintingPolicy();
  policy.AnonymousTagLocations = 0;  // a line in front of it makes no other type of it
  return policy;
}

std::string_view NameOfRecord(const clang::RecordDecl* record) {
  if (record->getIdentifier() != nullptr) return record->getName();
  const clang::TypedefNameDecl* alias = record->getTypedefNameForAnonDecl();
  return alias == nullptr ? std::string_view() : std::string_view(alias->getName());
}

/// A type with all that it is made of. Records have numbers in the order in which they are met, for they may be
/// circles.
class TypeDigester {
 public:
  TypeDigester(const clang::ASTContext& context, Digest& digest)
      : context_(context), policy_(WithoutPlaces(context)), digest_(digest) {}

  void Add(clang::QualType written) {
    digest_.Add(written.getAsString(policy_));  // with the names of typedefs
    Walk(written);
  }

 private:
  enum class Mark : uint8_t { kPointer, kArray, kUnbounded, kPrototype, kNoPrototype, kRecord, kKnown, kEnum, kOther };

  void Put(Mark mark) { digest_.Add(static_cast<uint64_t>(mark)); }

  void Walk(clang::QualType any) {
    const clang::QualType type = any.getCanonicalType();
    digest_.Add(type.getCVRQualifiers());
    if (const auto* pointer = type->getAs<clang::PointerType>()) {
      Put(Mark::kPointer);
      Walk(pointer->getPointeeType());
    } else if (const clang::ArrayType* array = context_.getAsArrayType(type)) {
      WalkArray(*array);
    } else if (const auto* function = type->getAs<clang::FunctionType>()) {
      WalkFunction(*function);
    } else if (const auto* record = type->getAs<clang::RecordType>()) {
      WalkRecord(record->getDecl());
    } else if (const auto* enumeration = type->getAs<clang::EnumType>()) {
      const clang::QualType integer = enumeration->getDecl()->getIntegerType();
      Put(Mark::kEnum);
      digest_.Add(enumeration->getDecl()->getName());
      if (!integer.isNull()) Walk(integer);
    } else {
      Put(Mark::kOther);
      digest_.Add(static_cast<uint64_t>(type->getTypeClass()));
      digest_.Add(type.getAsString(policy_));
    }
  }

  void WalkArray(const clang::ArrayType& array) {
    const auto* constant = llvm::dyn_cast<clang::ConstantArrayType>(&array);
    Put(constant == nullptr ? Mark::kUnbounded : Mark::kArray);
    if (constant != nullptr) digest_.Add(constant->getSize().getLimitedValue());
    Walk(array.getElementType());
  }

  void WalkFunction(const clang::FunctionType& function) {
    const auto* prototype = llvm::dyn_cast<clang::FunctionProtoType>(&function);
    Put(prototype == nullptr ? Mark::kNoPrototype : Mark::kPrototype);
    Walk(function.getReturnType());
    if (prototype == nullptr) return;
    digest_.Add(uint64_t{prototype->isVariadic()});
    digest_.Add(uint64_t{prototype->getNumParams()});
    for (const clang::QualType parameter : prototype->getParamTypes()) Walk(parameter);
  }

  void WalkRecord(const clang::RecordDecl* any) {
    const clang::RecordDecl* definition = any->getDefinition();
    const auto* record = definition != nullptr ? definition : llvm::cast<clang::RecordDecl>(any->getCanonicalDecl());
    const auto [known, is_new] = numbers_.try_emplace(record, numbers_.size());
    Put(is_new ? Mark::kRecord : Mark::kKnown);
    digest_.Add(known->second);
    if (!is_new) return;
    digest_.Add(NameOfRecord(record));
    digest_.Add(static_cast<uint64_t>(record->getTagKind()));
    digest_.Add(uint64_t{definition != nullptr} | uint64_t{record->isInvalidDecl()} << 1);
    if (definition == nullptr) return;
    for (const clang::FieldDecl* field : definition->fields()) {
      digest_.Add(field->getName());
      digest_.Add(uint64_t{field->isInvalidDecl()} | uint64_t{field->isBitField()} << 1);
      if (field->isBitField() && !field->isInvalidDecl()) digest_.Add(uint64_t{field->getBitWidthValue(context_)});
      Add(field->getType());
    }
  }

  const clang::ASTContext& context_;
  clang::PrintingPolicy policy_;
  Digest& digest_;
  llvm::DenseMap<const clang::RecordDecl*, uint64_t> numbers_;
};

/// A name that the product makes for itself; those of enumerations are counted, and mean nothing.
bool IsMade(const clang::NamedDecl* declaration) {
  return declaration->getIdentifier() != nullptr && declaration->getName().starts_with(kProductPrefix);
}

}  // namespace

void Digest::Add(uint64_t value) {
  constexpr uint64_t kFactor = 0x9E3779B97F4A7C15;
  value_ = (value_ ^ value) * kFactor;
  value_ ^= value_ >> 29;
  value_ += kFactor;
}

void Digest::Add(std::string_view text) {
  Add(uint64_t{text.size()});
  Add(support::HashOf64(text));
}

void Environment::Collect() {
  uint32_t order = 0;
  for (const clang::Decl* declaration : context_.getTranslationUnitDecl()->decls()) Add(declaration, order++);
}

void Environment::Add(const clang::Decl* declaration, uint32_t order) {
  const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
  if (named == nullptr) {
    if (!llvm::isa<clang::EmptyDecl>(declaration)) nameless_.Add(uint64_t{declaration->getKind()});
    return;
  }
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
    if (function->doesThisDeclarationHaveABody()) orders_[function] = order;
  }
  AddMeaning(named, DigestOf(named), order);
  if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(declaration)) {
    for (const clang::EnumConstantDecl* one : enumeration->enumerators()) AddMeaning(one, DigestOf(one), order);
  }
  if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(declaration)) AddMembers(record, order);
}

/// The tags that are declared in a record are those of the file.
void Environment::AddMembers(const clang::RecordDecl* record, uint32_t order) {
  for (const clang::Decl* inner : record->decls()) {
    if (llvm::isa<clang::TagDecl>(inner)) Add(inner, order);
  }
}

void Environment::AddMeaning(const clang::NamedDecl* declaration, const Digest& digest, uint32_t order) {
  const clang::IdentifierInfo* name = declaration->getIdentifier();
  if (name != nullptr && !IsMade(declaration)) meanings_[name].push_back({digest.value(), order});
}

Digest Environment::DigestOf(const clang::NamedDecl* declaration) const {
  Digest digest;
  digest.Add(uint64_t{declaration->getKind()});
  digest.Add(uint64_t{declaration->isInvalidDecl()} | uint64_t{declaration->isImplicit()} << 1 |
             uint64_t{InProduct(declaration)} << 2);
  for (const clang::Attr* attribute : declaration->attrs()) digest.Add(uint64_t{attribute->getKind()});
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
    DigestFunction(digest, function);
  } else if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration)) {
    DigestVariable(digest, variable);
  } else if (const auto* value = llvm::dyn_cast<clang::EnumConstantDecl>(declaration)) {
    TypeDigester(context_, digest).Add(value->getType());
    digest.Add(static_cast<uint64_t>(value->getInitVal().getExtValue()));
  } else if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(declaration)) {
    TypeDigester(context_, digest).Add(alias->getUnderlyingType());
  } else if (const auto* tag = llvm::dyn_cast<clang::TagDecl>(declaration)) {
    digest.Add(uint64_t{tag->isThisDeclarationADefinition()});
    TypeDigester(context_, digest).Add(context_.getTypeDeclType(tag));
  }
  return digest;
}

void Environment::DigestFunction(Digest& digest, const clang::FunctionDecl* function) const {
  digest.Add(static_cast<uint64_t>(function->getStorageClass()));
  digest.Add(uint64_t{function->doesThisDeclarationHaveABody()} | uint64_t{function->hasWrittenPrototype()} << 1);
  TypeDigester types(context_, digest);
  types.Add(function->getType());
  for (const clang::ParmVarDecl* parameter : function->parameters()) types.Add(parameter->getType());
}

void Environment::DigestVariable(Digest& digest, const clang::VarDecl* variable) const {
  digest.Add(static_cast<uint64_t>(variable->getStorageClass()));
  digest.Add(static_cast<uint64_t>(variable->isThisDeclarationADefinition()));
  TypeDigester(context_, digest).Add(variable->getType());
  const clang::Expr* init = variable->getInit();
  if (init == nullptr || !context_.getBaseElementType(variable->getType()).isConstQualified()) return;
  // Clang counts with the values of constants.
  std::string text;
  llvm::raw_string_ostream out(text);
  init->printPretty(out, nullptr, WithoutPlaces(context_));
  const clang::APValue* value = variable->isInvalidDecl() ? nullptr : variable->evaluateValue();
  if (value != nullptr) value->printPretty(out, context_, variable->getType());
  digest.Add(out.str());
}

bool Environment::DigestMacro(Digest& digest, const clang::MacroInfo& macro,
                              std::vector<clang::IdentifierInfo*>& names) const {
  const clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  digest.Add(uint64_t{macro.isFunctionLike()} | uint64_t{macro.isVariadic()} << 1 |
             uint64_t{session_.places.InProduct(macro.getDefinitionLoc())} << 2);
  digest.Add(uint64_t{macro.getNumParams()});
  for (const clang::IdentifierInfo* parameter : macro.params()) digest.Add(parameter->getName());
  digest.Add(uint64_t{macro.getNumTokens()});
  for (const clang::Token& token : macro.tokens()) {
    if (token.is(clang::tok::hashhash)) return false;
    digest.Add(uint64_t{token.getKind()} | uint64_t{token.hasLeadingSpace()} << 16);
    digest.Add(preprocessor.getSpelling(token));
    if (token.getIdentifierInfo() != nullptr) names.push_back(token.getIdentifierInfo());
  }
  return true;
}

BodyWords Environment::WordsOf(const clang::CompoundStmt* body) const {
  const clang::SourceManager& sources = session_.sources();
  const auto [file, begin] = sources.getDecomposedLoc(body->getLBracLoc());
  const auto [end_file, end] = sources.getDecomposedLoc(body->getRBracLoc());
  if (file != end_file || end < begin) return nullptr;
  std::string_view text = sources.getBufferData(file);
  text = text.substr(begin, end - begin);
  if (text.find("\\\n") != std::string_view::npos) return nullptr;
  std::unordered_set<std::string_view> seen;  // only asked
  auto words = std::make_shared<std::vector<std::string>>();
  for (size_t at = 0; at < text.size();) {
    if (!IsWord(text[at])) {
      ++at;
      continue;
    }
    size_t behind = at;
    while (behind < text.size() && IsWord(text[behind])) ++behind;
    const std::string_view word = text.substr(at, behind - at);
    const bool is_number = word.front() >= '0' && word.front() <= '9';
    if (!is_number && seen.insert(word).second) words->emplace_back(word);
    at = behind;
  }
  return words;
}

uint64_t Environment::Of(const clang::FunctionDecl* function, const std::vector<std::string>& words) {
  clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  const auto order = orders_.find(function);
  if (order == orders_.end()) return 0;
  Digest digest;
  digest.Add(nameless_.value());
  digest.Add(uint64_t{session_.input.char_is_signed});
  digest.Add(DigestOf(function).value());
  for (const clang::ParmVarDecl* parameter : function->parameters()) digest.Add(parameter->getName());
  std::vector<clang::IdentifierInfo*> names;  // grows while macros name more
  if (function->getIdentifier() != nullptr) names.push_back(function->getIdentifier());
  for (const std::string& word : words) names.push_back(&preprocessor.getIdentifierTable().get(word));
  llvm::DenseSet<const clang::IdentifierInfo*> seen;
  for (size_t i = 0; i < names.size(); ++i) {
    clang::IdentifierInfo* name = names[i];
    if (!seen.insert(name).second) continue;
    digest.Add(name->getName());
    if (name->hadMacroDefinition()) {
      const clang::SourceLocation open = function->getBody()->getBeginLoc();
      const clang::MacroInfo* macro = preprocessor.getMacroDefinitionAtLoc(name, open).getMacroInfo();
      digest.Add(uint64_t{macro != nullptr});
      if (macro != nullptr && !DigestMacro(digest, *macro, names)) return 0;
    }
    const auto found = meanings_.find(name);
    if (found == meanings_.end()) continue;
    uint64_t before = 0;
    for (const Meaning& meaning : found->second) {
      digest.Add(meaning.digest);
      if (meaning.order <= order->second) ++before;
    }
    digest.Add(before);
  }
  return std::max<uint64_t>(digest.value(), 1);
}

}  // namespace plcxx::hnc
