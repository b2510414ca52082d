// What a random program of dialect technol has loaded, and what reads flags.
#pragma once

#include <array>
#include <cstdint>

namespace plcxx::reference::technol_code {

/// RLO, flags, and the low byte, high byte and upper half of each register.
using Loaded = uint32_t;
constexpr Loaded kRlo = 1, kCf = 2, kZf = 4, kSf = 8, kOf = 16, kAf = 32;
constexpr Loaded kAllFlags = kCf | kZf | kSf | kOf | kAf;
constexpr uint32_t kEax = 0, kEbx = 1, kEcx = 2, kEdx = 3;
constexpr Loaded Parts(uint32_t reg, Loaded parts) { return parts << (6 + 3 * reg); }
constexpr Loaded Whole(uint32_t reg) { return Parts(reg, 7); }
constexpr Loaded Word(uint32_t reg) { return Parts(reg, 3); }
constexpr Loaded kDr = Whole(kEcx);

/// A jump of the assembler, and the flags that it reads.
struct FlagJump {
  const char* word;
  Loaded reads;
};
constexpr std::array kFlagJumps = {FlagJump{"JE", kZf},
                                   FlagJump{"JZ", kZf},
                                   FlagJump{"JNE", kZf},
                                   FlagJump{"JNZ", kZf},
                                   FlagJump{"JC", kCf},
                                   FlagJump{"JB", kCf},
                                   FlagJump{"JNAE", kCf},
                                   FlagJump{"JNC", kCf},
                                   FlagJump{"JAE", kCf},
                                   FlagJump{"JNB", kCf},
                                   FlagJump{"JA", kCf | kZf},
                                   FlagJump{"JNBE", kCf | kZf},
                                   FlagJump{"JBE", kCf | kZf},
                                   FlagJump{"JNA", kCf | kZf},
                                   FlagJump{"JG", kZf | kSf | kOf},
                                   FlagJump{"JNLE", kZf | kSf | kOf},
                                   FlagJump{"JGE", kSf | kOf},
                                   FlagJump{"JNL", kSf | kOf},
                                   FlagJump{"JL", kSf | kOf},
                                   FlagJump{"JNGE", kSf | kOf},
                                   FlagJump{"JLE", kZf | kSf | kOf},
                                   FlagJump{"JNG", kZf | kSf | kOf},
                                   FlagJump{"JS", kSf},
                                   FlagJump{"JNS", kSf},
                                   FlagJump{"JO", kOf},
                                   FlagJump{"JNO", kOf}};

}  // namespace plcxx::reference::technol_code
