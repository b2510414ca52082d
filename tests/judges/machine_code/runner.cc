// Executes functions of an object as plcxx verify does, on numbers: object, processor, file of headers, file of the
// memory's pattern, number of functions, states of each, file for the results.
//
// Each result is a byte (0: executed, 1: refused, 2: an obligation does not hold) and the block afterwards. What is
// refused is printed with its reason.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/object_code.h"
#include "transpiler/symbolic/terms/samples.h"
#include "transpiler/symbolic/terms/terms.h"

namespace {

using namespace plcxx;
namespace verify = prove::verify;

constexpr uint32_t kBlock = 352, kHeader = 76, kScratch = 96;

std::string Read(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The block, and no host.
class Block : public verify::CodeEnvironment {
 public:
  Block(terms::Terms& all, std::string_view header, std::string_view pattern)
      : terms_(all), header_(header), pattern_(pattern) {}
  terms::TermId Initial(uint32_t slot) override {
    const char byte = slot < kHeader ? header_[slot] : slot < kScratch ? '\0' : pattern_[slot - kScratch];
    return terms_.Const(static_cast<uint8_t>(byte), 8);
  }
  terms::TermId CallHost(verify::CodeMemory&, const verify::HostRequest& request, std::string& refusal) override {
    refusal = "a call of " + std::string(request.function);
    return {};
  }

 private:
  terms::Terms& terms_;
  std::string_view header_, pattern_;
};

struct Result {
  char status = 0;
  std::string bytes = std::string(kBlock, '\0');
};

Result Execute(verify::CompiledCode& code, const std::string& function, std::string_view header,
               std::string_view pattern) {
  Result result;
  terms::Terms all;
  Block block(all, header, pattern);
  verify::CodeRun run;
  run.function = function;
  run.state_bytes = kBlock;
  run.arguments = {{.kind = verify::CodeArgument::Kind::kState, .name = "m", .value = {}}};
  const verify::CodeOutcome outcome = code.Execute(all, block, run);
  if (!outcome.refusal.empty()) {
    std::printf("%s: %s\n", function.c_str(), outcome.refusal.c_str());
    result.status = 1;
    return result;
  }
  std::vector<terms::TermId> roots = outcome.slots;
  for (const verify::Obligation& obligation : outcome.obligations) {
    // The instances keep no convention: what callers rely on is not theirs to keep.
    if (obligation.text.starts_with("an assumption") || obligation.text.find("stack pointer") != std::string::npos)
      continue;
    roots.push_back(obligation.never);
  }
  const std::vector<uint64_t> values = terms::SampleValues(all, roots, 1).front();
  for (size_t i = 0; i < values.size(); ++i) {
    if (i < kBlock) {
      result.bytes[i] = static_cast<char>(values[i]);
    } else if (values[i] != 0) {
      result.status = 2;
    }
  }
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 8) {
    std::fputs("usage: runner OBJECT PROCESSOR HEADERS PATTERN FUNCTIONS STATES RESULTS\n", stderr);
    return 2;
  }
  const std::array<std::string, 1> objects = {Read(arguments[1])};
  const std::string headers = Read(arguments[3]), pattern = Read(arguments[4]);
  const auto functions = static_cast<size_t>(std::atoi(arguments[5]));
  const auto states = static_cast<size_t>(std::atoi(arguments[6]));
  std::vector<verify::Signature> signatures;
  for (size_t i = 0; i < functions; ++i)
    signatures.push_back({.function = "t" + std::to_string(i), .parameters = {{.name = "m"}}});
  const verify::LoadedCode loaded =
      verify::LoadObjectCode({.objects = objects, .signatures = signatures, .processor = arguments[2]});
  if (loaded.code == nullptr) {
    std::fprintf(stderr, "%s\n", loaded.reason.c_str());
    return 1;
  }
  std::ofstream results(arguments[7], std::ios::binary);
  for (size_t i = 0; i < functions; ++i) {
    for (size_t k = 0; k < states; ++k) {
      const std::string_view header = std::string_view(headers).substr((i * states + k) * kHeader, kHeader);
      const Result result = Execute(*loaded.code, signatures[i].function, header, pattern);
      results.put(result.status);
      results << result.bytes;
    }
  }
  return results.good() ? 0 : 1;
}
