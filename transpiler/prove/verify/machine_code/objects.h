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
#include <utility>
#include <vector>

namespace plcxx::prove::verify::machine_code {

/// A place in a section of one of the files.
struct Place {
  uint32_t section = 0;
  uint64_t offset = 0;
  bool operator==(const Place&) const = default;
  auto operator<=>(const Place&) const = default;
};

/// What the linker takes for a symbol.
enum class Resolution : uint8_t {
  kOutside,  // none of these files has it: it is the host's or a library's
  kPlace,
  kUnclear  // no place in what is loaded, several that differ, or of a weak reference that nobody need answer
};

/// A note for the linker: what it will write there.
struct Link {
  uint64_t type = 0;                                                                 // as ELF numbers the target's
  std::string symbol;                                                                // may be empty of a local place
  enum class Binding : uint8_t { kNone, kLocal, kGlobal } binding = Binding::kNone;  // none: it names no symbol
  Resolution resolution = Resolution::kUnclear;
  bool is_of_section = false;    // the symbol: its addend says what is meant
  std::optional<Place> defined;  // kPlace: where the symbol is, without addend
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
  // From and to where the linker takes bytes away to align what follows, in order.
  std::vector<std::pair<uint64_t, uint64_t>> may_go;
  // The linker puts constants of so many bytes, or texts of such characters, beside others than here; 0: it does not.
  uint64_t merges = 0;
  bool has_texts = false;

  /// The first byte of what stays together around that place, and how many there are.
  std::pair<uint64_t, uint64_t> MergedAt(uint64_t offset) const;
};

struct Function {
  std::string symbol;
  Place place;
  uint64_t bytes = 0;
};

/// A symbol that other files can refer to.
struct Definition {
  std::optional<Function> at;  // none: it is in nothing that is loaded
  enum class Strength : uint8_t { kWeak, kStrong } strength = Strength::kStrong;
};

struct Linked {
  Resolution resolution = Resolution::kOutside;
  std::optional<Place> place;
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
  /// The function that a link leads to, in whichever file; none: there is no function there.
  std::optional<uint32_t> FunctionOf(const Link& link) const {
    return link.defined ? FunctionAt(*link.defined) : std::nullopt;
  }
  /// What the linker takes for a symbol that files share, seen from a file that has it itself at `own`.
  Linked LinkedAs(const std::string& symbol, std::optional<Place> own) const;
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
  /// When all files are read.
  void Resolve();
  bool AreAlike(const Function& a, const Function& b, unsigned depth) const;
  /// Of what each of two files has for itself.
  bool AreAlike(const Place& a, const Place& b, unsigned depth) const;

  std::vector<std::unique_ptr<llvm::object::ELFObjectFileBase>> files_;
  std::vector<std::unique_ptr<llvm::object::Archive>> archives_;
  std::vector<Section> sections_;
  std::vector<Function> functions_;
  std::map<Place, uint32_t> function_at_;
  std::unordered_map<std::string, std::vector<Definition>> definitions_;  // of symbols that files share; looked up only
};

}  // namespace plcxx::prove::verify::machine_code
