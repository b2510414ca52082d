#include "transpiler/compile/audit/object_reader.h"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/Support/Endian.h>
#include <llvm/Support/MemoryBuffer.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "transpiler/compile/audit_module.h"

namespace plcxx::compile::audit {
namespace {

namespace elf = llvm::ELF;

SectionKind KindOf(llvm::StringRef name, uint64_t flags, uint32_t type) {
  if (name.starts_with(".init_array") || name.starts_with(".preinit_array") || name.starts_with(".ctors")) {
    return SectionKind::kConstructors;
  }
  const bool tables = name.starts_with(".eh_frame") || name.starts_with(".ARM.exidx") ||
                      name.starts_with(".ARM.extab") || name.starts_with(".gcc_except_table");
  if (tables) return SectionKind::kUnwinding;
  if ((flags & elf::SHF_ALLOC) == 0) return SectionKind::kOther;
  if ((flags & elf::SHF_EXECINSTR) != 0) return SectionKind::kCode;
  if ((flags & elf::SHF_WRITE) != 0) return type == elf::SHT_NOBITS ? SectionKind::kZeroes : SectionKind::kData;
  return SectionKind::kConstants;
}

/// Clang marks every function of ARM that exceptions end at, which is 8 bytes each; they tell no way to unwind.
bool EndsUnwindingOnly(llvm::StringRef table) {
  constexpr uint32_t kCannotUnwind = 1;
  constexpr size_t kEntry = 8;
  for (size_t at = 0; at + kEntry <= table.size(); at += kEntry) {
    if (llvm::support::endian::read32le(table.data() + at + kEntry / 2) != kCannotUnwind) return false;
  }
  return true;
}

template <class T>
T ValueOr(llvm::Expected<T> value, T otherwise) {
  if (value) return *value;
  llvm::consumeError(value.takeError());
  return otherwise;
}

}  // namespace

void ObjectReader::ReadSections() {
  for (const llvm::object::ELFSectionRef section : object_.sections()) {
    const llvm::StringRef name = ValueOr<llvm::StringRef>(section.getName(), "");
    const uint32_t type = section.getType();
    const bool content = type == elf::SHT_PROGBITS || type == elf::SHT_NOBITS || type == elf::SHT_INIT_ARRAY ||
                         type == elf::SHT_PREINIT_ARRAY || type == elf::SHT_ARM_EXIDX || type == elf::SHT_X86_64_UNWIND;
    if (!content || section.getSize() == 0) continue;
    SectionKind kind = KindOf(name, section.getFlags(), type);
    const bool index = type == elf::SHT_ARM_EXIDX;
    if (index && EndsUnwindingOnly(ValueOr<llvm::StringRef>(section.getContents(), ""))) kind = SectionKind::kConstants;
    if (kind == SectionKind::kConstants) {
      constants_at_.emplace(section.getIndex(), static_cast<uint32_t>(facts_.sections.size()));
    }
    facts_.sections.push_back({name.str(), kind, section.getSize()});
  }
}

void ObjectReader::ReadSymbols() {
  for (const llvm::object::ELFSymbolRef symbol : object_.symbols()) {
    const llvm::StringRef name = ValueOr<llvm::StringRef>(symbol.getName(), "");
    const uint32_t flags = ValueOr<uint32_t>(symbol.getFlags(), 0);
    const llvm::object::section_iterator section = ValueOr(symbol.getSection(), object_.section_end());
    const bool defined = section != object_.section_end();
    uint64_t address = ValueOr<uint64_t>(symbol.getValue(), 0);
    if (defined && (name.starts_with("$") || symbol.getELFType() == elf::STT_FILE)) {
      const bool data = name.starts_with("$d");
      if (name.starts_with("$")) islands_[section->getIndex()].push_back({address, data});
      continue;
    }
    const bool is_function = defined && symbol.getELFType() == elf::STT_FUNC && symbol.getSize() > 0;
    if (is_function && machine_.is_arm()) address &= ~uint64_t{1};
    const auto index = static_cast<uint32_t>(facts_.symbols.size());
    symbol_index_[symbol.getRawDataRefImpl().d.b] = index;
    CodeSymbol known{name.str(), llvm::demangle(name.str()), defined,
                     (flags & llvm::object::SymbolRef::SF_Global) == 0};
    if (known.name.empty() && defined) known.name = ValueOr<llvm::StringRef>(section->getName(), "").str();
    if (is_function) {
      const auto [at, added] = function_at_.try_emplace({section->getIndex(), address}, index);
      if (added) {
        known.function = static_cast<uint32_t>(facts_.functions.size());
        CodeFunction function;
        function.symbol = index;
        function.bytes = static_cast<uint32_t>(symbol.getSize());
        facts_.functions.push_back(std::move(function));
        const llvm::StringRef bytes = ValueOr<llvm::StringRef>(section->getContents(), "");
        const uint64_t end = std::min<uint64_t>(address + symbol.getSize(), bytes.size());
        places_.push_back({section->getIndex(), address, end, bytes});
      } else {
        known.function = facts_.symbols[at->second].function;  // two names of one function
      }
    }
    facts_.symbols.push_back(std::move(known));
  }
  for (auto& [section, islands] : islands_) std::ranges::stable_sort(islands, {}, &Island::begin);
}

void ObjectReader::ReadReferences() {
  for (const llvm::object::SectionRef& table : object_.sections()) {
    const llvm::object::section_iterator section = ValueOr(table.getRelocatedSection(), object_.section_end());
    if (section == object_.section_end()) continue;
    const uint64_t flags = llvm::object::ELFSectionRef(*section).getFlags();
    if ((flags & elf::SHF_ALLOC) == 0) continue;  // tables for debuggers
    for (const llvm::object::RelocationRef& relocation : table.relocations()) {
      const llvm::object::symbol_iterator symbol = relocation.getSymbol();
      if (symbol == object_.symbol_end()) continue;
      const auto known = symbol_index_.find(symbol->getRawDataRefImpl().d.b);
      if (known == symbol_index_.end()) continue;
      Reference reference{.symbol = known->second};
      const llvm::object::section_iterator target = ValueOr(symbol->getSection(), object_.section_end());
      if (target != object_.section_end()) {
        reference.section = target->getIndex();
        reference.address = ValueOr<uint64_t>(symbol->getValue(), 0);
        if (machine_.is_arm()) reference.address &= ~uint64_t{1};
        const bool is_section = llvm::object::ELFSymbolRef(*symbol).getELFType() == elf::STT_SECTION;
        if (is_section && machine_.is_x86()) {
          // Counted from the end of the instruction, which these four bytes are.
          const int64_t addend = ValueOr<int64_t>(llvm::object::ELFRelocationRef(relocation).getAddend(), 0);
          reference.address += static_cast<uint64_t>(addend + 4);
        }
      }
      references_[section->getIndex()].try_emplace(relocation.getOffset(), reference);
    }
  }
  std::map<uint64_t, std::string> section_names;
  for (const llvm::object::SectionRef& section : object_.sections()) {
    section_names[section.getIndex()] = ValueOr<llvm::StringRef>(section.getName(), "").str();
  }
  for (const auto& [section, all] : references_) {
    for (const auto& [offset, reference] : all) {
      const CodeSymbol& symbol = facts_.symbols[reference.symbol];
      if (symbol.defined || symbol.name.empty()) continue;
      SymbolUse use{section_names[section], reference.symbol};
      const auto behind = function_at_.upper_bound({section, offset});
      if (behind != function_at_.begin() && std::prev(behind)->first.first == section) {
        use.user = facts_.symbols[std::prev(behind)->second].text;
      }
      const auto same = [&](const SymbolUse& other) { return other.user == use.user && other.symbol == use.symbol; };
      if (std::ranges::none_of(facts_.uses, same)) facts_.uses.push_back(std::move(use));
    }
  }
}

void ObjectReader::ReadFunction(uint32_t index) {
  CodeFunction& function = facts_.functions[index];
  const Place& place = places_[index];
  const auto frame = frames_.find({place.section, place.begin});
  if (frame != frames_.end()) {
    function.frame_bytes = static_cast<uint32_t>(frame->second.bytes);
    function.frame_known = frame->second.known;
  }
  function.constants = ConstantsOf(place);
  MakeBlocks(place, function);
}

std::vector<uint32_t> ObjectReader::ConstantsOf(const Place& place) const {
  std::set<uint32_t> sections;
  const auto all = references_.find(place.section);
  if (all == references_.end()) return {};
  for (auto at = all->second.lower_bound(place.begin); at != all->second.end() && at->first < place.end; ++at) {
    const auto found = constants_at_.find(at->second.section);
    if (facts_.symbols[at->second.symbol].defined && found != constants_at_.end()) sections.insert(found->second);
  }
  return {sections.begin(), sections.end()};
}

void ObjectReader::Run() {
  ReadSections();
  ReadSymbols();
  ReadReferences();
  frames_ = ReadFrames(object_, *context_, machine_.StackPointer());
  for (uint32_t i = 0; i < facts_.functions.size(); ++i) ReadFunction(i);
  facts_.timing = timing_.Text();
}

namespace {

void Read(const ObjectRequest& request, ObjectFacts& facts) {
  const llvm::MemoryBufferRef buffer(llvm::StringRef(request.bytes.data(), request.bytes.size()), "object");
  llvm::Expected<std::unique_ptr<llvm::object::ObjectFile>> object =
      llvm::object::ObjectFile::createELFObjectFile(buffer);
  if (!object) {
    facts.failure = llvm::toString(object.takeError());
    return;
  }
  const auto& elf_object = llvm::cast<llvm::object::ELFObjectFileBase>(**object);
  const auto machine = MachineCode::Make(elf_object, std::string(request.processor), facts.failure);
  if (machine != nullptr) ObjectReader(elf_object, *machine, facts).Run();
}

}  // namespace
}  // namespace plcxx::compile::audit

extern "C" __attribute__((visibility("default"))) void plcxx_read_object(const plcxx::compile::ObjectRequest& request,
                                                                         plcxx::compile::ObjectFacts& facts) {
  plcxx::compile::audit::Read(request, facts);
}
