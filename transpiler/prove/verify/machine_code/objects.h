// Objects of one target as the lifter reads them: functions, constants, and what places of theirs refer to.
//
// In: ELF files. Out: their sections with the linker's notes resolved to symbols of these files where one defines them.
// Not its job: instructions.
#pragma once

#include <llvm/Object/Archive.h>
#include <llvm/Object/ELFObjectFile.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace plcxx::prove::verify::machine_code {

/// A place in a section of one of the files.
struct Place {
  uint32_t section = 0;
  uint64_t offset = 0;
  bool operator==(const Place&) const = default;
  auto operator<=>(const Place&) const = default;
};

/// A note for the linker: what it will write there.
struct Link {
  uint64_t type = 0;             // as ELF numbers the target's
  std::string symbol;            // may be empty of a local place
  std::optional<Place> defined;  // where the symbol is, without addend
  int64_t addend = 0;
};

struct Section {
  std::string name;
  llvm::StringRef bytes;
  uint64_t align = 1;
  bool is_code = false;
  bool is_constant = false;              // loaded, and never written
  std::multimap<uint64_t, Link> links;   // by offset
  std::map<uint64_t, bool> data_begins;  // of ARM: where constants begin (true) and code (false)
};

struct Function {
  std::string symbol;
  Place place;
  uint64_t bytes = 0;
};

class Objects {
 public:
  /// ELF files, and archives of them. The reason is empty where it succeeds.
  bool Read(std::span<const std::string> files, std::string& reason);

  const llvm::object::ELFObjectFileBase& first() const { return *files_.front(); }
  const std::vector<Section>& sections() const { return sections_; }
  const std::vector<Function>& functions() const { return functions_; }
  /// The function that begins there; none.
  std::optional<uint32_t> FunctionAt(const Place& place) const;
  /// The function that a link leads to, in whichever file; none: it is the host's or a library's, or files have
  /// different ones of this name.
  std::optional<uint32_t> FunctionOf(const Link& link) const;
  /// Of the same bytes, and of the same that the linker will write into them.
  bool AreAlike(const Function& a, const Function& b) const;
  /// A section whose code or addresses are executed without a call; none.
  const Section* RunsByItself() const;

 private:
  bool ReadFile(llvm::MemoryBufferRef file, std::string& reason);
  bool ReadObject(llvm::MemoryBufferRef file, std::string& reason);
  void ReadSections(const llvm::object::ELFObjectFileBase& file, std::unordered_map<uint64_t, uint32_t>& section_of);
  void ReadSymbols(const llvm::object::ELFObjectFileBase& file,
                   const std::unordered_map<uint64_t, uint32_t>& section_of);
  void ReadLinks(const llvm::object::ELFObjectFileBase& file, const std::unordered_map<uint64_t, uint32_t>& section_of);

  std::vector<std::unique_ptr<llvm::object::ELFObjectFileBase>> files_;
  std::vector<std::unique_ptr<llvm::object::Archive>> archives_;
  std::vector<Section> sections_;
  std::vector<Function> functions_;
  std::map<Place, uint32_t> function_at_;
  std::unordered_map<std::string, std::vector<uint32_t>> global_functions_;  // looked up only
};

}  // namespace plcxx::prove::verify::machine_code
