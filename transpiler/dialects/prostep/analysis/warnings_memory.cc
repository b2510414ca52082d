// Memory as all modules use it together.

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "transpiler/dialects/prostep/analysis/accesses.h"
#include "transpiler/dialects/prostep/analysis/warnings.h"
#include "transpiler/dialects/prostep/machine/memory.h"
#include "transpiler/dialects/prostep/machine/signals.h"

namespace plcxx::prostep {
namespace {

constexpr uint32_t kBytes = 1000;   // of the largest space
constexpr uint32_t kMapSpaces = 4;  // I, O, F, D
constexpr uint32_t kLastNumberField = 255 + 6;

/// A mask of bits for each byte of I, O, F and D.
struct UsedBits {
  std::array<std::array<uint8_t, kBytes>, kMapSpaces> masks{};

  static uint8_t Of(const MemoryAccess& access) { return access.bytes == 1 ? access.bits : uint8_t{0xFF}; }
  void Add(const MemoryAccess& access) {
    for (uint32_t i = 0; i < access.bytes; ++i) {
      masks[static_cast<size_t>(access.space)][access.first + i] |= Of(access);
    }
  }
  void AddBytes(Space space, uint32_t first, uint32_t last) {
    for (uint32_t byte = first; byte <= last; ++byte) masks[static_cast<size_t>(space)][byte] = 0xFF;
  }
  bool Meets(const MemoryAccess& access) const {
    for (uint32_t i = 0; i < access.bytes; ++i) {
      if ((masks[static_cast<size_t>(access.space)][access.first + i] & Of(access)) != 0) return true;
    }
    return false;
  }
};

bool IsMemorySpace(Space space) {
  return space == Space::kI || space == Space::kO || space == Space::kF || space == Space::kD;
}
bool Reads(const MemoryAccess& access) { return access.access == Access::kRead || access.access == Access::kReadWrite; }
bool Writes(const MemoryAccess& access) {
  return access.access == Access::kWrite || access.access == Access::kReadWrite;
}

std::string TextOfAccess(const MemoryAccess& access) {
  if (access.bytes == 1 && access.bits != 0xFF) {
    uint8_t bit = 0;
    while ((access.bits >> bit & 1) == 0) ++bit;
    return AddressText(access.space, access.first, ir::Type::kBit, bit);
  }
  const ir::Type type = access.bytes == 1 ? ir::Type::kI8 : access.bytes == 2 ? ir::Type::kI16 : ir::Type::kI32;
  return AddressText(access.space, access.first, type, 0);
}

/// Calls visit(signal) for every row of the signal table that the access meets.
template <class Visit>
void ForEachSignal(const MemoryAccess& access, Visit&& visit) {
  for (const Signal& signal : Signals()) {
    if (signal.space != access.space) continue;
    const uint32_t bytes = signal.width <= 8 ? 1 : signal.width / 8u;
    if (signal.byte + bytes <= access.first || access.first + access.bytes <= signal.byte) continue;
    const uint32_t bits = signal.width >= 8 ? 0xFFu : ((1u << signal.width) - 1) << signal.bit;
    if (access.bytes == 1 && bytes == 1 && (access.bits & bits) == 0) continue;
    visit(signal);
  }
}

struct MemoryChecker {
  const Program& program;
  diag::Engine& diagnostics;
  std::vector<std::vector<MemoryAccess>> accesses = {};  // by InstructionId
  UsedBits read = {}, written = {}, interface = {}, fast = {};
  std::array<bool, kMapSpaces> read_somewhere{}, written_somewhere{};  // FM 15 to 18
  std::set<std::tuple<const void*, Space, uint32_t, uint32_t, uint8_t>> reported = {};

  template <class Message, class... Arguments>
  void ReportOnce(const MemoryAccess& access, const Message& message, const Arguments&... arguments) {
    if (!reported.emplace(&message, access.space, access.first, access.bytes, access.bits).second) return;
    diagnostics.Report(access.range, message, TextOfAccess(access), arguments...);
  }

  template <class Visit>
  void ForEachAccess(Visit&& visit) {
    for (const std::vector<MemoryAccess>& of_instruction : accesses) {
      for (const MemoryAccess& access : of_instruction) visit(access);
    }
  }

  void Collect();
  void Unused();
  void Directions();
  void RefreshedOutputs();
  void Shared();
};

void MemoryChecker::Collect() {
  for (const Instruction& instruction : program.instructions) accesses.push_back(AccessesOf(program, instruction));
  ForEachAccess([&](const MemoryAccess& access) {
    if (!IsMemorySpace(access.space)) return;
    const auto space = static_cast<size_t>(access.space);
    if (access.indirect) {
      (Reads(access) ? read_somewhere : written_somewhere)[space] = true;
      return;
    }
    if (Reads(access)) read.Add(access);
    if (Writes(access)) written.Add(access);
  });
  for (const DataDeclaration& declared : program.data) {
    written.AddBytes(Space::kD, declared.address, declared.address + declared.bytes - 1u);
  }
  for (const Signal& signal : Signals()) {
    if (!IsMemorySpace(signal.space)) continue;
    const uint32_t bytes = signal.width <= 8 ? 1 : signal.width / 8u;
    MemoryAccess all{.space = signal.space, .first = signal.byte, .bytes = bytes};
    if (signal.width < 8) all.bits = static_cast<uint8_t>(((1u << signal.width) - 1) << signal.bit);
    interface.Add(all);
  }
  // The NC reads the fields to which the program points.
  const MemoryAccess numbers{.space = Space::kF, .first = kFirstNumberByte, .bytes = kMessagesWithNumber};
  if (written.Meets(numbers) || written_somewhere[static_cast<size_t>(Space::kF)]) {
    read.AddBytes(Space::kD, 0, kLastNumberField);
  }
}

/// W37: nothing is said of inputs and of what the NC or the machine reads or writes.
void MemoryChecker::Unused() {
  ForEachAccess([&](const MemoryAccess& access) {
    if (!IsMemorySpace(access.space) || access.space == Space::kI || access.indirect || interface.Meets(access)) return;
    const auto space = static_cast<size_t>(access.space);
    if (Reads(access) && !written_somewhere[space] && !written.Meets(access)) {
      ReportOnce(access, diag::ProstepReadNeverWritten);
    }
    if (Writes(access) && !read_somewhere[space] && !read.Meets(access)) {
      ReportOnce(access, diag::ProstepWrittenNeverRead);
    }
  });
}

/// W38: what all signals that an access meets leave to somebody else.
void MemoryChecker::Directions() {
  const auto data = InitialData(program);
  const uint32_t refreshed = data[kInputCountAddress] | uint32_t{data[kInputCountAddress + 1]} << 8;
  ForEachAccess([&](const MemoryAccess& access) {
    if (!Writes(access) || !IsMemorySpace(access.space) || access.indirect) return;
    bool nc = false, machine = false, allowed = false;
    ForEachSignal(access, [&](const Signal& signal) {
      nc |= signal.direction == SignalDirection::kNcToPlc;
      machine |= signal.direction == SignalDirection::kMachineIn;
      allowed |= signal.direction == SignalDirection::kPlcToNc || signal.direction == SignalDirection::kMachineOut ||
                 signal.direction == SignalDirection::kInternal;
      // Handshakes: what one side sets and the other one clears.
      for (const std::string_view words : {"PLC clears", "cleared by the PLC", "set by the PLC"}) {
        allowed |= signal.meaning.find(words) != std::string_view::npos;
      }
    });
    if (allowed || !(nc || machine)) return;
    for (uint32_t port = 0; port < std::min(refreshed, kMostInputBytes); ++port) {
      if (MayWrite(access, Space::kI, InputByteOfPort(port), 0xFF)) return;  // W20 says more
    }
    diagnostics.Report(access.range, diag::ProstepAgainstDirection, TextOfAccess(access),
                       nc ? "the NC writes it" : "it is an input of the machine");
  });
}

void MemoryChecker::RefreshedOutputs() {
  const auto data = InitialData(program);
  const uint32_t declared = data[kOutputCountAddress] | uint32_t{data[kOutputCountAddress + 1]} << 8;
  const uint32_t refreshed = std::min(declared, kMostOutputBytes);
  ForEachAccess([&](const MemoryAccess& access) {
    if (access.space != Space::kP || !Writes(access) || access.first >= refreshed) return;
    diagnostics.Report(access.range, diag::ProstepDirectOutputRefreshed, TextOfAccess(access));
  });
}

void MemoryChecker::Shared() {
  const std::vector<bool> in_fast = ReachedFrom(program, 1, kFirstLoopModule - 1);
  const std::vector<bool> in_slow = ReachedFrom(program, kFirstLoopModule, kFirstSubroutine - 1);
  const auto for_each_write = [&](const std::vector<bool>& modules, auto&& visit) {
    for (uint32_t m = 0; m < modules.size(); ++m) {
      if (!modules[m]) continue;
      const Module& module = program.modules[ModuleId(m)];
      for (uint32_t i = module.begin_of().index; i < module.end_of().index; ++i) {
        for (const MemoryAccess& access : accesses[i]) {
          if (Writes(access) && IsMemorySpace(access.space) && !access.indirect) visit(access);
        }
      }
    }
  };
  for_each_write(in_fast, [&](const MemoryAccess& access) { fast.Add(access); });
  for_each_write(in_slow, [&](const MemoryAccess& access) {
    if (fast.Meets(access)) ReportOnce(access, diag::ProstepSharedByParts);
  });
}

}  // namespace

void CheckMemory(const Program& program, diag::Engine& diagnostics) {
  MemoryChecker checker{program, diagnostics};
  checker.Collect();
  checker.Unused();
  checker.Directions();
  checker.RefreshedOutputs();
  checker.Shared();
}

}  // namespace plcxx::prostep
