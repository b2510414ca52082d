#include "scalar_time.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <string_view>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/engines/harness.h"
#include "transpiler/engines/platform.h"

namespace plcxx::bench {
namespace {

/// The harness obeys commands from this file's memory, again and again from behind its first `head` bytes, and what it
/// says goes nowhere.
constexpr std::string_view kConsole = R"(#pragma once
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
namespace plcxx_console {
static char script[1 << 26];
static size_t at = 0, head = 0, end = 0;
static double best = 1e18, begun = 0;
static int rounds = 0;
static double Seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}
[[noreturn]] inline void Quit() { exit(1); }
static void Load() {
  FILE* const file = fopen("script", "rb");
  if (file == nullptr || fread(&head, sizeof head, 1, file) != 1) Quit();
  end = fread(script, 1, sizeof script, file);
  fclose(file);
}
[[gnu::noinline]] static void EndRound() {
  const double now = Seconds();
  if (rounds > 0 && now - begun < best) best = now - begun;
  if (rounds++ == 7) {
    printf("%.12f\n", best);
    exit(0);
  }
  at = head;
  begun = Seconds();
}
inline void Read(void* bytes, size_t size) {
  if (end == 0) Load();
  if (at == end) EndRound();
  memcpy(bytes, script + at, size);
  at += size;
}
inline void Write(const void*, size_t) {}
inline void Flush() {}
inline void* Grow(void* bytes, size_t, size_t size) { return realloc(bytes, size); }
}
)";
constexpr int kSeconds = 300;
constexpr double kNsPerSecond = 1e9;
constexpr size_t kRoom = size_t{1} << 26;

class Script {
 public:
  explicit Script(const emit::layout::Layout& layout) : layout_(layout) {}

  void Letter(char letter) { text_ += letter; }
  void Word(uint32_t word) {
    for (int i = 0; i < 4; ++i) text_ += static_cast<char>(word >> 8 * i);
  }
  void SetAll(const std::vector<BitPlace>& bits) {
    // The harness writes a byte at a time.
    std::map<uint32_t, std::pair<uint32_t, uint32_t>> bytes;  // by offset: mask, value
    for (const BitPlace& bit : bits) {
      const emit::layout::ByteStorage& storage = layout_.bytes[bit.space.index][bit.offset];
      const bool is_whole = storage.whole.storage != emit::layout::Storage::kNone;
      const bool one = (random_() & 1) != 0;
      if (!is_whole && storage.bits[bit.bit].storage == emit::layout::Storage::kNone) continue;
      auto& [mask, value] = bytes[is_whole ? storage.whole.offset : storage.bits[bit.bit].offset];
      mask |= is_whole ? 1U << bit.bit : 0xFFU;
      if (one) value |= is_whole ? 1U << bit.bit : 1U;
    }
    for (const auto& [offset, byte] : bytes) {
      Letter('W');
      Word(offset);
      Word(byte.first);
      Word(byte.second);
    }
  }
  size_t size() const { return text_.size(); }
  const std::string& text() const { return text_; }

 private:
  const emit::layout::Layout& layout_;
  std::mt19937_64 random_{1};
  std::string text_;
};

std::string ScriptOf(const emit::Emittable& emittable, const std::vector<BitPlace>& seen,
                     const std::vector<BitPlace>& inputs, uint32_t periods) {
  Script script(emittable.layout);
  script.Word(0);
  script.Letter('I');
  script.SetAll(seen);
  const uint64_t head = script.size();
  uint32_t now_ms = 0;
  for (uint32_t i = 0; i < periods && script.size() < kRoom / 2; ++i) {
    if (i % kPeriodsOfAnInput == 0) script.SetAll(inputs);
    script.Letter('P');
    script.Word(now_ms += emittable.program->schedule.period_ms);
  }
  std::string text(reinterpret_cast<const char*>(&head), sizeof head);
  return text + script.text();
}

}  // namespace

std::optional<double> ScalarNs(const compilation::Compilation& compilation, const std::vector<BitPlace>& seen,
                               const std::vector<BitPlace>& inputs, uint32_t periods) {
  const emit::Emittable emittable =
      emit::legalize::Legalize(compilation.program, {.name = "program", .simulated = true});
  const compile::TemporaryDirectory directory;
  bool written = directory.valid() && compile::WriteRuntime(directory.path());
  std::vector<std::string> command{engines::FindCompiler(),
                                   "-std=c++17",
                                   "-O2",
                                   "-fno-exceptions",
                                   "-fno-rtti",
                                   "-w",
                                   "-I",
                                   directory.path(),
                                   "-o",
                                   directory.path() + "/scalar"};
  for (const emit::OutputFile& file : emit::print::PrintCpp(emittable, *compilation.sources)) {
    written = directory.Write(file.name, file.text) && written;
    if (file.name.ends_with(".cpp") && emittable.parts.size() > 1)
      command.push_back(directory.path() + "/" + file.name);
  }
  std::string harness = engines::HarnessText({&emittable, 1});
  constexpr std::string_view kUnoptimized = "optimize (\"O0\")";
  if (const size_t at = harness.find(kUnoptimized); at != std::string::npos)
    harness[at + kUnoptimized.size() - 3] = '2';
  written = directory.Write("harness.cpp", harness) && directory.Write("console.h", kConsole) &&
            directory.Write("script", ScriptOf(emittable, seen, inputs, periods)) && written;
  if (!written) {
    std::fprintf(stderr, "cannot write into a temporary directory\n");
    return std::nullopt;
  }
  command.push_back(directory.path() + "/harness.cpp");
  const compile::ProcessResult compiled = compile::RunProcess(command, kSeconds);
  if (compiled.exit_code != 0) {
    std::fprintf(stderr, "%s\n", compiled.output.c_str());
    return std::nullopt;
  }
  const compile::ProcessResult ran = compile::RunProcess({directory.path() + "/scalar"}, kSeconds, directory.path());
  if (ran.exit_code != 0) {
    std::fprintf(stderr, "the generated code cannot be run\n");
    return std::nullopt;
  }
  return std::strtod(ran.output.c_str(), nullptr) * kNsPerSecond / periods;
}

}  // namespace plcxx::bench
