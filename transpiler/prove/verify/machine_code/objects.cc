#include "transpiler/prove/verify/machine_code/objects.h"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/Object/Archive.h>
#include <llvm/Support/MemoryBuffer.h>

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::prove::verify::machine_code {
namespace {

/// Thumb functions are told by the lowest bit of their address.
uint64_t WithoutThumbBit(const llvm::object::ELFObjectFileBase& file, uint64_t address) {
  return file.getEMachine() == llvm::ELF::EM_ARM ? address & ~uint64_t{1} : address;
}

template <class T>
std::optional<T> ValueOr(llvm::Expected<T> value) {
  if (value) return std::move(*value);
  llvm::consumeError(value.takeError());
  return std::nullopt;
}

/// None: it is in nothing that is loaded, or has no section at all.
std::optional<uint32_t> SectionOf(const llvm::object::ELFObjectFileBase& file, const llvm::object::ELFSymbolRef& symbol,
                                  const std::unordered_map<uint64_t, uint32_t>& section_of) {
  const auto section = ValueOr(symbol.getSection());
  if (!section || *section == file.section_end()) return std::nullopt;
  const auto found = section_of.find((*section)->getIndex());
  return found == section_of.end() ? std::nullopt : std::optional(found->second);
}

uint64_t EntryBytes(const llvm::object::ELFObjectFileBase& file, const llvm::object::ELFSectionRef& section) {
  const auto of = [&](const auto& elf) { return uint64_t{elf.getSection(section.getRawDataRefImpl())->sh_entsize}; };
  if (const auto* narrow = llvm::dyn_cast<llvm::object::ELF32LEObjectFile>(&file)) return of(*narrow);
  if (const auto* wide = llvm::dyn_cast<llvm::object::ELF64LEObjectFile>(&file)) return of(*wide);
  return 1;
}

}  // namespace

std::pair<uint64_t, uint64_t> Section::MergedAt(uint64_t offset) const {
  if (merges == 0 || offset >= bytes.size()) return {0, bytes.size()};
  const uint64_t first = offset / merges * merges;
  uint64_t end = std::min<uint64_t>(first + merges, bytes.size());
  const auto is_end = [&](uint64_t at) {
    return bytes.substr(at, merges).find_first_not_of('\0') == llvm::StringRef::npos;
  };
  if (has_texts) {
    while (end < bytes.size() && !is_end(end - merges)) end = std::min<uint64_t>(end + merges, bytes.size());
  }
  return {first, end - first};
}

void Objects::ReadSections(const llvm::object::ELFObjectFileBase& file,
                           std::unordered_map<uint64_t, uint32_t>& section_of) {
  for (const llvm::object::ELFSectionRef section : file.sections()) {
    const uint64_t flags = section.getFlags();
    if ((flags & llvm::ELF::SHF_ALLOC) == 0) continue;
    section_of.emplace(section.getIndex(), static_cast<uint32_t>(sections_.size()));
    Section& read = sections_.emplace_back();
    read.name = ValueOr(section.getName()).value_or("").str();
    if (section.getType() != llvm::ELF::SHT_NOBITS) read.bytes = ValueOr(section.getContents()).value_or("");
    read.align = section.getAlignment().value();
    read.is_code = (flags & llvm::ELF::SHF_EXECINSTR) != 0;
    read.is_constant = (flags & llvm::ELF::SHF_WRITE) == 0;
    read.has_texts = (flags & llvm::ELF::SHF_STRINGS) != 0;
    if ((flags & llvm::ELF::SHF_MERGE) != 0) read.merges = std::max<uint64_t>(EntryBytes(file, section), 1);
  }
}

void Objects::ReadSymbols(const llvm::object::ELFObjectFileBase& file,
                          const std::unordered_map<uint64_t, uint32_t>& section_of) {
  const bool is_arm = file.getEMachine() == llvm::ELF::EM_ARM;
  for (const llvm::object::ELFSymbolRef symbol : file.symbols()) {
    const auto name = ValueOr(symbol.getName());
    const uint32_t flags = ValueOr(symbol.getFlags()).value_or(0);
    if (!name || (flags & llvm::object::BasicSymbolRef::SF_Undefined) != 0) continue;
    const std::optional<uint32_t> section = SectionOf(file, symbol, section_of);
    const bool is_shared = symbol.getBinding() != llvm::ELF::STB_LOCAL;
    Definition* shared = is_shared ? &definitions_[name->str()].emplace_back() : nullptr;
    if (shared != nullptr && (flags & llvm::object::BasicSymbolRef::SF_Weak) != 0)
      shared->strength = Definition::Strength::kWeak;
    if (!section) continue;
    const uint64_t value = ValueOr(symbol.getValue()).value_or(0);
    if (is_arm && (name->starts_with("$t") || name->starts_with("$d")))
      sections_[*section].data_begins[value] = name->starts_with("$d");
    const Function found{name->str(), {*section, WithoutThumbBit(file, value)}, symbol.getSize()};
    const bool is_data = !sections_[*section].is_code;
    // What is no function is not called, be it at the place of one: ARM's linker would change the instruction set.
    const bool is_function = symbol.getELFType() == llvm::ELF::STT_FUNC &&
                             (!is_arm || (flags & llvm::object::BasicSymbolRef::SF_Thumb) != 0);
    if (shared != nullptr && (is_data || is_function)) shared->at = found;
    if (!is_function) continue;
    function_at_.emplace(found.place, static_cast<uint32_t>(functions_.size()));
    functions_.push_back(found);
  }
}

void Objects::ReadLinks(const llvm::object::ELFObjectFileBase& file,
                        const std::unordered_map<uint64_t, uint32_t>& section_of) {
  for (const llvm::object::SectionRef notes : file.sections()) {
    const auto target = ValueOr(notes.getRelocatedSection());
    if (!target || *target == file.section_end()) continue;
    const auto found = section_of.find((*target)->getIndex());
    if (found == section_of.end()) continue;
    // ARM's linker has addends in what it writes into, RISC-V's in its notes; others are notes of no type that is
    // known.
    const auto usual = file.getEMachine() == llvm::ELF::EM_ARM ? llvm::ELF::SHT_REL : llvm::ELF::SHT_RELA;
    const bool is_usual = llvm::object::ELFSectionRef(notes).getType() == usual;
    for (const llvm::object::ELFRelocationRef note : notes.relocations()) {
      Link link{.type = is_usual ? note.getType() : ~uint64_t{0}, .symbol = {}, .defined = {}};
      link.addend = ValueOr(note.getAddend()).value_or(0);
      if (note.getSymbol() != file.symbol_end()) {
        const llvm::object::ELFSymbolRef symbol(*note.getSymbol());
        const uint32_t flags = ValueOr(symbol.getFlags()).value_or(0);
        const bool is_shared = symbol.getBinding() != llvm::ELF::STB_LOCAL;
        link.symbol = ValueOr(symbol.getName()).value_or("").str();
        link.is_of_section = symbol.getELFType() == llvm::ELF::STT_SECTION;
        link.binding = is_shared ? Link::Binding::kGlobal : Link::Binding::kLocal;
        if (const std::optional<uint32_t> section = SectionOf(file, symbol, section_of))
          link.defined = {*section, WithoutThumbBit(file, ValueOr(symbol.getValue()).value_or(0))};
        constexpr uint32_t kUndefined = llvm::object::BasicSymbolRef::SF_Undefined,
                           kWeak = llvm::object::BasicSymbolRef::SF_Weak;
        if (is_shared && (flags & kUndefined) != 0 && (flags & kWeak) == 0) link.resolution = Resolution::kOutside;
      }
      Section& section = sections_[found->second];
      if (file.getEMachine() == llvm::ELF::EM_RISCV && link.type == llvm::ELF::R_RISCV_ALIGN)
        section.may_go.emplace_back(note.getOffset(), note.getOffset() + static_cast<uint64_t>(link.addend));
      section.links.emplace(note.getOffset(), std::move(link));
    }
  }
}

void Objects::Resolve() {
  struct Answer {
    Link* link;
    Linked linked;
  };
  // What a file itself says of its notes is what others are compared with.
  std::vector<Answer> answers;
  for (Section& section : sections_) {
    for (auto& [offset, link] : section.links) {
      if (link.binding == Link::Binding::kNone) continue;
      Linked linked{link.defined ? Resolution::kPlace : Resolution::kUnclear, link.defined};
      if (link.binding == Link::Binding::kGlobal) {
        linked = LinkedAs(link.symbol, link.defined);
        if (linked.resolution == Resolution::kOutside) linked.resolution = link.resolution;
      }
      answers.push_back({&link, linked});
    }
  }
  for (const auto& [link, linked] : answers) {
    link->resolution = linked.resolution;
    link->defined = linked.place;
  }
}

Linked Objects::LinkedAs(const std::string& symbol, std::optional<Place> own) const {
  const auto found = definitions_.find(symbol);
  if (found == definitions_.end()) return {};
  std::vector<const Definition*> taken;
  for (const auto strength : {Definition::Strength::kStrong, Definition::Strength::kWeak}) {
    for (const Definition& one : found->second) {
      if (one.strength == strength) taken.push_back(&one);
    }
    if (!taken.empty()) break;
  }
  // Of an inline function that several files have the linker takes any.
  const Definition& first = *taken.front();
  const auto differs = [&](const Definition* one) { return !one->at || !first.at || !AreAlike(*first.at, *one->at); };
  if (!first.at || std::any_of(taken.begin() + 1, taken.end(), differs)) return {Resolution::kUnclear, std::nullopt};
  const auto is_own = [&](const Definition* one) { return own && one->at->place == *own; };
  return {Resolution::kPlace, std::ranges::any_of(taken, is_own) ? own : std::optional(first.at->place)};
}

bool Objects::ReadObject(llvm::MemoryBufferRef file, std::string& reason) {
  auto object = llvm::object::ObjectFile::createELFObjectFile(file);
  if (!object) {
    reason = "an object cannot be read: " + llvm::toString(object.takeError());
    return false;
  }
  files_.emplace_back(llvm::cast<llvm::object::ELFObjectFileBase>(object->release()));
  if (files_.back()->getEMachine() != files_.front()->getEMachine()) {
    reason = "the objects are for different processors";
    return false;
  }
  std::unordered_map<uint64_t, uint32_t> section_of;
  ReadSections(*files_.back(), section_of);
  ReadSymbols(*files_.back(), section_of);
  ReadLinks(*files_.back(), section_of);
  return true;
}

bool Objects::ReadFile(llvm::MemoryBufferRef file, std::string& reason) {
  if (!file.getBuffer().starts_with("!<arch>\n")) return ReadObject(file, reason);
  auto archive = llvm::object::Archive::create(file);
  if (!archive) {
    reason = "a library cannot be read: " + llvm::toString(archive.takeError());
    return false;
  }
  archives_.push_back(std::move(*archive));
  bool read = true;
  llvm::Error failure = llvm::Error::success();
  for (const llvm::object::Archive::Child& member : archives_.back()->children(failure)) {
    const auto buffer = ValueOr(member.getMemoryBufferRef());
    read = read && buffer && ReadObject(*buffer, reason);
  }
  if (failure) reason = "a library cannot be read: " + llvm::toString(std::move(failure));
  return read && reason.empty();
}

bool Objects::Read(std::span<const std::string> files, std::string& reason) {
  for (const std::string& bytes : files) {
    if (!ReadFile(llvm::MemoryBufferRef(bytes, "object"), reason)) return false;
  }
  if (files_.empty()) reason = "there are no objects";
  Resolve();
  return !files_.empty();
}

const Section* Objects::RunsByItself() const {
  constexpr llvm::StringRef kNames[] = {".init", ".fini", ".preinit_array", ".ctors", ".dtors"};
  const auto runs = [&](const Section& section) {
    const llvm::StringRef name = section.name;
    return !section.bytes.empty() &&
           std::ranges::any_of(kNames, [&](llvm::StringRef one) { return name.starts_with(one); });
  };
  const auto found = std::ranges::find_if(sections_, runs);
  return found == sections_.end() ? nullptr : &*found;
}

bool Objects::AreAlike(const Place& a, const Place& b, unsigned depth) const {
  constexpr unsigned kDeepest = 16;
  const Section &in_a = sections_[a.section], &in_b = sections_[b.section];
  if (a == b) return true;
  if (in_a.is_code || in_b.is_code) {
    const auto one = FunctionAt(a), other = FunctionAt(b);
    return one && other && depth < kDeepest && AreAlike(functions_[*one], functions_[*other], depth + 1);
  }
  return a.offset == b.offset && in_a.is_constant && in_b.is_constant && in_a.bytes == in_b.bytes &&
         in_a.links.empty() && in_b.links.empty();
}

bool Objects::AreAlike(const Function& a, const Function& b) const { return AreAlike(a, b, 0); }

bool Objects::AreAlike(const Function& a, const Function& b, unsigned depth) const {
  if (a.place == b.place) return true;
  const Section &in_a = sections_[a.place.section], &in_b = sections_[b.place.section];
  if (a.bytes != b.bytes || in_a.is_code != in_b.is_code || in_a.is_constant != in_b.is_constant ||
      in_a.bytes.substr(a.place.offset, a.bytes) != in_b.bytes.substr(b.place.offset, b.bytes))
    return false;
  auto link = in_a.links.lower_bound(a.place.offset), other = in_b.links.lower_bound(b.place.offset);
  const auto end = in_a.links.lower_bound(a.place.offset + a.bytes);
  const auto other_end = in_b.links.lower_bound(b.place.offset + b.bytes);
  const auto within = [](const Link& one, const Function& function) -> std::optional<uint64_t> {
    const bool inside = one.defined && one.defined->section == function.place.section;
    return inside ? std::optional(one.defined->offset - function.place.offset) : std::nullopt;
  };
  const auto lead_to_one = [&](const Link& one, const Link& two) {
    if (one.binding != two.binding) return false;
    if (const std::optional<uint64_t> inside = within(one, a)) return inside == within(two, b);
    switch (one.binding) {
      case Link::Binding::kNone:
        return true;
      case Link::Binding::kLocal:
        return one.defined && two.defined && AreAlike(*one.defined, *two.defined, depth);
      case Link::Binding::kGlobal:
        return one.symbol == two.symbol;
    }
    PLCXX_UNREACHABLE();
  };
  for (; link != end && other != other_end; ++link, ++other) {
    const Link &one = link->second, &two = other->second;
    if (link->first - a.place.offset != other->first - b.place.offset || one.type != two.type ||
        one.addend != two.addend || !lead_to_one(one, two))
      return false;
  }
  return link == end && other == other_end;
}

std::optional<uint32_t> Objects::FunctionAt(const Place& place) const {
  const auto found = function_at_.find(place);
  return found == function_at_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace plcxx::prove::verify::machine_code
