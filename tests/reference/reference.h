// A second reading of a dialect's specification: an interpreter of the syntax tree, to run beside the simulator.
//
// In: the parsed sources and their options. Out: memory as the host sees it, elements (timers, counters) by the names
// of their fields, host calls. Written from the tables of the specification alone: nothing in here may include a
// lowering, the IR's operations or runtime_support. Not its job: time, inputs, comparing (reference_engine.h).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::reference {

/// One address space of the control. A forced bit keeps its value against the program, the inputs and the host.
class AddressSpace {
 public:
  AddressSpace(std::string name, uint32_t bytes) : name_(std::move(name)), bytes_(bytes), forced_(bytes) {}

  const std::string& name() const { return name_; }
  uint32_t size() const { return static_cast<uint32_t>(bytes_.size()); }
  uint8_t operator[](uint32_t offset) const { return bytes_.at(offset); }
  const std::vector<uint8_t>& bytes() const { return bytes_; }
  uint8_t forced(uint32_t offset) const { return forced_.at(offset); }

  /// The bits of `mask` become those of `value`.
  void Write(uint32_t offset, uint8_t mask, uint8_t value) {
    const auto open = static_cast<uint8_t>(mask & ~forced_.at(offset));
    bytes_[offset] = static_cast<uint8_t>((bytes_[offset] & ~open) | (value & open));
  }
  void Force(uint32_t offset, uint8_t mask) { forced_.at(offset) = static_cast<uint8_t>(forced_[offset] | mask); }
  void Release(uint32_t offset, uint8_t mask) { forced_.at(offset) = static_cast<uint8_t>(forced_[offset] & ~mask); }
  void Clear() {
    for (uint32_t i = 0; i < size(); ++i) Write(i, 0xFF, 0);
  }

 private:
  std::string name_;
  std::vector<uint8_t> bytes_, forced_;
};

/// A value of a timer, counter ... that a scenario can name, as raw bits.
struct Element {
  std::function<uint64_t()> read;
  std::function<void(uint64_t value)> write;
};

/// What a host function gives back: its result, and its second one where it has one.
struct Answer {
  uint64_t result = 0;
  std::optional<uint64_t> out;
};

/// What the specification leaves to the tool, so that a reference takes it from the program: by the position of a
/// statement's first character (source::Range::begin).
struct Choices {
  std::map<uint32_t, uint32_t> statement_ids;
  std::map<uint32_t, uint32_t> slices;  // of the statements outside of blocks; empty: one slice
  uint32_t slice_count = 1;
};

/// Makes a host call by the function's name in the specification; arguments as raw bits.
using HostCalls = std::function<Answer(std::string_view function, const std::vector<uint64_t>& arguments)>;

class Reference {
 public:
  explicit Reference(HostCalls host) : host_(std::move(host)) {}
  virtual ~Reference() = default;
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  /// Before anything runs.
  virtual void Take(const Choices& /*choices*/) {}

  // As sim::Engine has them.
  virtual void PowerOn() = 0;
  virtual void RunPeriod(uint32_t now_ms) = 0;
  virtual void RunFastOnly(uint32_t now_ms) = 0;
  virtual void RunElapse(uint32_t /*now_ms*/) {}
  virtual void SendText(std::string_view /*text*/) {}
  /// The host takes the retentive memory into its store; the next PowerOn finds it there.
  virtual void StoreRetentive() {}

  std::vector<AddressSpace>& memories() { return memories_; }
  /// A field of an element ("T5", "done"), with the names that the program gives them; none: not known here.
  virtual std::optional<Element> FindElement(std::string_view /*instance*/, std::string_view /*field*/) {
    return std::nullopt;
  }

  /// The element has the value from now on, whatever the program does.
  void ForceElement(const std::string& name, Element element, uint64_t value) {
    ReleaseElement(name);
    forced_.push_back({name, std::move(element), value});
    PutBackForced();
  }
  /// The host has written an element: one that is forced keeps its value.
  void HostWrote() { PutBackForced(); }
  void ReleaseElement(const std::string& name) {
    std::erase_if(forced_, [&](const ForcedElement& forced) { return forced.name == name; });
  }

  /// What of the program this reading passes over. Not empty: it says nothing about the program.
  const std::vector<std::string>& unsupported() const { return unsupported_; }

 protected:
  Answer Call(std::string_view function, const std::vector<uint64_t>& arguments = {}) {
    return host_(function, arguments);
  }
  /// To be called after everything that may have changed an element.
  void PutBackForced() {
    for (const ForcedElement& forced : forced_) forced.element.write(forced.value);
  }
  void Unsupported(std::string what) { unsupported_.push_back(std::move(what)); }

  std::vector<AddressSpace> memories_;

 private:
  struct ForcedElement {
    std::string name;
    Element element;
    uint64_t value;
  };

  HostCalls host_;
  std::vector<ForcedElement> forced_;
  std::vector<std::string> unsupported_;
};

}  // namespace plcxx::reference
