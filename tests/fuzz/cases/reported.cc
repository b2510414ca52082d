// In place of plcxx: the fault that PLCXX_FAULT names, which a sanitizer must report, or none.
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

// Nothing here is known to the compiler, which would otherwise leave out what has no effect.
volatile int one = 1;
void* (*volatile allocate)(size_t) = std::malloc;
void (*volatile release)(void*) = std::free;

int Address() {
  auto* const bytes = static_cast<volatile char*>(allocate(8));
  release(const_cast<char*>(bytes));
  return bytes[one];
}

int Undefined() {
  const int sum = INT_MAX + one;
  return sum == 0 ? 1 : 0;
}

int Leak() {
  void* volatile lost = allocate(100);
  lost = nullptr;
  return lost == nullptr ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string_view(argv[2]) == "--help") {  // of which run.py makes its words
    std::puts("  --quiet  says nothing\nOptions of the dialects:\n  prostep  strict");
    return 0;
  }
  const char* const named = std::getenv("PLCXX_FAULT");
  const std::string_view fault = named == nullptr ? "" : named;
  if (fault == "address") return Address();
  if (fault == "undefined") return Undefined();
  if (fault == "leak") return Leak();
  std::puts("no fault");
  return 0;
}
