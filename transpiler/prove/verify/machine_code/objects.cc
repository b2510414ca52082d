#include "transpiler/prove/verify/machine_code/objects.h"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/Object/Archive.h>
#include <llvm/Support/MemoryBuffer.h>

#include <algorithm>
#include <utility>

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

}  // namespace

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
  }
}

void Objects::ReadSymbols(const llvm::object::ELFObjectFileBase& file,
                          const std::unordered_map<uint64_t, uint32_t>& section_of) {
  for (const llvm::object::ELFSymbolRef symbol : file.symbols()) {
    const auto name = ValueOr(symbol.getName());
    const auto section = ValueOr(symbol.getSection());
    if (!name || !section || *section == file.section_end()) continue;
    const auto found = section_of.find((*section)->getIndex());
    if (found == section_of.end()) continue;
    const uint64_t value = ValueOr(symbol.getValue()).value_or(0);
    if (file.getEMachine() == llvm::ELF::EM_ARM && (name->starts_with("$t") || name->starts_with("$d")))
      sections_[found->second].data_begins[value] = name->starts_with("$d");
    if (symbol.getELFType() != llvm::ELF::STT_FUNC) continue;
    const Place place{found->second, WithoutThumbBit(file, value)};
    const auto number = static_cast<uint32_t>(functions_.size());
    functions_.push_back({.symbol = name->str(), .place = place, .bytes = symbol.getSize()});
    function_at_.emplace(place, number);
    if (symbol.getBinding() != llvm::ELF::STB_LOCAL) global_functions_[name->str()].push_back(number);
  }
}

void Objects::ReadLinks(const llvm::object::ELFObjectFileBase& file,
                        const std::unordered_map<uint64_t, uint32_t>& section_of) {
  for (const llvm::object::SectionRef notes : file.sections()) {
    const auto target = ValueOr(notes.getRelocatedSection());
    if (!target || *target == file.section_end()) continue;
    const auto found = section_of.find((*target)->getIndex());
    if (found == section_of.end()) continue;
    for (const llvm::object::ELFRelocationRef note : notes.relocations()) {
      Link link{.type = note.getType(), .symbol = {}, .defined = {}};
      link.addend = ValueOr(note.getAddend()).value_or(0);
      const llvm::object::ELFSymbolRef symbol(*note.getSymbol());
      if (note.getSymbol() != file.symbol_end()) {
        link.symbol = ValueOr(symbol.getName()).value_or("").str();
        const auto section = ValueOr(symbol.getSection());
        if (section && *section != file.section_end()) {
          const auto defined = section_of.find((*section)->getIndex());
          if (defined != section_of.end())
            link.defined = {defined->second, WithoutThumbBit(file, ValueOr(symbol.getValue()).value_or(0))};
        }
      }
      sections_[found->second].links.emplace(note.getOffset(), std::move(link));
    }
  }
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

bool Objects::AreAlike(const Function& a, const Function& b) const {
  const Section &in_a = sections_[a.place.section], &in_b = sections_[b.place.section];
  if (a.bytes != b.bytes || in_a.bytes.substr(a.place.offset, a.bytes) != in_b.bytes.substr(b.place.offset, b.bytes))
    return false;
  auto link = in_a.links.lower_bound(a.place.offset), other = in_b.links.lower_bound(b.place.offset);
  const auto end = in_a.links.lower_bound(a.place.offset + a.bytes);
  const auto other_end = in_b.links.lower_bound(b.place.offset + b.bytes);
  const auto within = [](const Link& one, const Function& function) -> std::optional<uint64_t> {
    const bool inside = one.defined && one.defined->section == function.place.section;
    return inside ? std::optional(one.defined->offset - function.place.offset) : std::nullopt;
  };
  for (; link != end && other != other_end; ++link, ++other) {
    const Link &one = link->second, &two = other->second;
    const std::optional<uint64_t> inside = within(one, a);
    const bool same_place = inside ? inside == within(two, b) : !one.symbol.empty() && one.symbol == two.symbol;
    const bool for_the_linker = one.symbol.empty() && !one.defined && two.symbol.empty() && !two.defined;
    if (link->first - a.place.offset != other->first - b.place.offset || one.type != two.type ||
        one.addend != two.addend || (!same_place && !for_the_linker))
      return false;
  }
  return link == end && other == other_end;
}

std::optional<uint32_t> Objects::FunctionAt(const Place& place) const {
  const auto found = function_at_.find(place);
  return found == function_at_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<uint32_t> Objects::FunctionOf(const Link& link) const {
  const auto own = link.defined ? FunctionAt(*link.defined) : std::nullopt;
  const auto found = global_functions_.find(own ? functions_[*own].symbol : link.symbol);
  if (found == global_functions_.end()) return own;
  // Of an inline function that several files have the linker takes any.
  const std::vector<uint32_t>& all = found->second;
  if (own && std::find(all.begin(), all.end(), *own) == all.end()) return own;  // of the same name, but its file's own
  const auto differs = [&](uint32_t one) { return !AreAlike(functions_[all.front()], functions_[one]); };
  if (std::any_of(all.begin() + 1, all.end(), differs)) return std::nullopt;
  return own ? own : std::optional(all.front());
}

}  // namespace plcxx::prove::verify::machine_code
