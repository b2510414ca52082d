#include "transpiler/dialects/hnc/parser/clang/type_converter.h"

#include <clang/AST/RecordLayout.h>

#include <algorithm>
#include <utility>

namespace plcxx::hnc {
namespace {

constexpr uint64_t kMostBytes = 0xFFFFFFFF;  // sizes count to here; far smaller ones are refused

}  // namespace

std::string TypeConverter::TextOf(clang::QualType type) const {
  return type.getUnqualifiedType().getAsString(context_.getPrintingPolicy());
}

TypeId TypeConverter::Add(Type type) {
  std::string key = std::to_string(static_cast<int>(type.kind));
  for (const uint32_t part :
       {uint32_t{type.bits}, uint32_t{type.is_signed}, type.element.index, type.count, type.record.index}) {
    key += ',' + std::to_string(part);
  }
  const auto known = types_.find(key);
  if (known != types_.end()) return known->second;
  const TypeId id = unit_.types.Add(std::move(type));
  types_.emplace(std::move(key), id);
  return id;
}

TypeId TypeConverter::Integer(unsigned bits, bool is_signed) {
  const char* const text = bits == 8    ? (is_signed ? "signed char" : "unsigned char")
                           : bits == 16 ? (is_signed ? "int" : "unsigned int")
                                        : (is_signed ? "long" : "unsigned long");
  const TypeId id = Add({.kind = TypeKind::kInteger,
                         .bits = static_cast<uint8_t>(bits),
                         .is_signed = is_signed,
                         .element = {},
                         .count = 0,
                         .record = {},
                         .size = bits / 8,
                         .text = text});
  uint32_t& noted = noted_integers_[bits / 8 * 2 + (is_signed ? 1 : 0)];
  if (now_.recorder.is_recording() && noted != now_.recorder.serial()) {
    noted = now_.recorder.serial();
    now_.recorder.Add(NeedKind::kType, id.index);
  }
  return id;
}

TypeId TypeConverter::TypeOf(clang::QualType qualified) {
  const clang::QualType type = qualified.getCanonicalType().getUnqualifiedType();
  const auto known = known_types_.find(type.getAsOpaquePtr());
  if (known != known_types_.end()) {
    Known& entry = known->second;  // stays where it is, unlike the iterator
    Note(type, entry);
    return entry.id;
  }
  const TypeId id = Describe(type);
  Note(type, known_types_.emplace(type.getAsOpaquePtr(), Known{.id = id}).first->second);
  return id;
}

/// Parts of a type before it, as Describe adds them.
void TypeConverter::Note(clang::QualType type, Known& known) {
  BodyRecorder& recorder = now_.recorder;
  if (!recorder.is_recording() || known.noted == recorder.serial()) return;
  known.noted = recorder.serial();
  const TypeId id = known.id;
  if (const auto* pointer = type->getAs<clang::PointerType>()) TypeOf(pointer->getPointeeType());
  if (const clang::ArrayType* array = context_.getAsArrayType(type)) TypeOf(array->getElementType());
  if (unit_.types[id].kind == TypeKind::kRecord) return NoteRecord(type, id);
  recorder.Add(NeedKind::kType, id.index, unit_.types[id].kind == TypeKind::kInteger ? std::string() : TextOf(type));
}

void TypeConverter::NoteRecord(clang::QualType type, TypeId id) {
  BodyRecorder& recorder = now_.recorder;
  const auto* record = llvm::cast<clang::RecordDecl>(type->getAs<clang::RecordType>()->getDecl()->getCanonicalDecl());
  const clang::TypedefNameDecl* alias = record->getTypedefNameForAnonDecl();
  const bool is_tagged = record->getIdentifier() != nullptr;
  const clang::IdentifierInfo* name = is_tagged          ? record->getIdentifier()
                                      : alias != nullptr ? alias->getIdentifier()
                                                         : nullptr;
  const auto& names = is_tagged ? recorder.names.tags : recorder.names.typedefs;
  const auto named = name == nullptr ? names.end() : names.find(name);
  if (named == names.end() || named->second != record) return recorder.Refuse();
  recorder.Add(is_tagged ? NeedKind::kTaggedRecord : NeedKind::kTypedefRecord, id.index, name->getName().str());
}

TypeId TypeConverter::Describe(clang::QualType type) {
  constexpr unsigned kWidest = 32;  // wider ones have been refused
  Type result;
  result.text = TextOf(type);
  if (type->isVoidType()) return Add(std::move(result));
  if (type->isIntegralOrEnumerationType()) {
    const unsigned bits = std::min(static_cast<unsigned>(context_.getTypeSize(type)), kWidest);
    return Integer(bits, type->isEnumeralType() || type->isSignedIntegerType());
  }
  if (type->isRealFloatingType()) {
    result.kind = TypeKind::kReal;
    result.bits = context_.getTypeSize(type) == 32 ? 32 : 64;
    result.size = result.bits / 8U;
    return Add(std::move(result));
  }
  if (const auto* pointer = type->getAs<clang::PointerType>()) {
    constexpr uint32_t kPointerBytes = 2;
    result.kind = TypeKind::kPointer;
    result.element = TypeOf(pointer->getPointeeType());
    result.size = kPointerBytes;
    return Add(std::move(result));
  }
  if (const clang::ArrayType* array = context_.getAsArrayType(type)) {
    result.kind = TypeKind::kArray;
    result.element = TypeOf(array->getElementType());
    if (const auto* constant = llvm::dyn_cast<clang::ConstantArrayType>(array)) {
      result.count = static_cast<uint32_t>(constant->getSize().getLimitedValue(0xFFFFFFFF));
    }
    const uint64_t size = uint64_t{result.count} * unit_.types[result.element].size;
    result.size = static_cast<uint32_t>(std::min<uint64_t>(size, kMostBytes));
    return Add(std::move(result));
  }
  if (const auto* record = type->getAs<clang::RecordType>()) {
    result.kind = TypeKind::kRecord;
    result.record = RecordOf(record->getDecl());
    result.size = unit_.records[result.record].size;
    return Add(std::move(result));
  }
  result.kind = type->isFunctionType() ? TypeKind::kFunction : TypeKind::kVoid;
  return Add(std::move(result));
}

RecordId TypeConverter::RecordOf(const clang::RecordDecl* any) {
  const clang::RecordDecl* definition = any->getDefinition();
  const clang::RecordDecl* record =
      definition != nullptr ? definition : llvm::cast<clang::RecordDecl>(any->getCanonicalDecl());
  const auto known = records_.find(record);
  if (known != records_.end()) return known->second;
  Record result;
  result.name = record->getNameAsString();
  if (result.name.empty() && record->getTypedefNameForAnonDecl() != nullptr) {
    result.name = record->getTypedefNameForAnonDecl()->getNameAsString();
  }
  result.is_union = record->isUnion();
  result.range = NameOf(record);
  const RecordId id = unit_.records.Add(std::move(result));
  records_.emplace(record, id);
  const bool sound =
      definition != nullptr && !definition->isInvalidDecl() &&
      std::ranges::none_of(definition->fields(), [](const auto* field) { return field->isInvalidDecl(); });
  if (sound) FillMembers(definition, id);
  return id;
}

void TypeConverter::FillMembers(const clang::RecordDecl* record, RecordId id) {
  const clang::ASTRecordLayout& layout = context_.getASTRecordLayout(record);
  std::vector<Member> members;
  uint64_t unit_begin = 0, unit_bits = 0;  // of the bit-field before; 0 bits: none, or closed
  for (const clang::FieldDecl* field : record->fields()) {
    Member member;
    member.name = field->getNameAsString();
    member.type = TypeOf(field->getType());
    member.range = NameOf(field);
    const uint64_t at = layout.getFieldOffset(field->getFieldIndex());
    member.offset = static_cast<uint32_t>(at / 8);
    if (!field->isBitField()) {
      unit_bits = 0;
    } else {
      const uint64_t width = field->getBitWidthValue(context_);
      const uint64_t bits = context_.getTypeSize(field->getType());
      const bool goes_on =
          !record->isUnion() && unit_bits == bits && at >= unit_begin && at + width <= unit_begin + bits;
      if (!goes_on) unit_begin = at;
      unit_bits = width == 0 ? 0 : bits;
      member.is_bit_field = true;
      member.offset = static_cast<uint32_t>(unit_begin / 8);
      member.bit_offset = static_cast<uint8_t>(at - unit_begin);
      member.bit_width = static_cast<uint8_t>(width);
    }
    members.push_back(std::move(member));
  }
  unit_.records[id].members = std::move(members);
  unit_.records[id].size =
      static_cast<uint32_t>(std::min<uint64_t>(kMostBytes, static_cast<uint64_t>(layout.getSize().getQuantity())));
}

}  // namespace plcxx::hnc
