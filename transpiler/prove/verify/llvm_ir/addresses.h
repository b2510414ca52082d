// Pointers as numbers, as machine code has them.
//
// An object's address is a variable that nothing is known of: what is proved is so wherever it is. A number is a
// pointer again when it is such a variable plus some offset; one that is put together otherwise is refused.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"

namespace plcxx::prove::verify::llvm_ir {

class Addresses : private ExecutionPart {
 public:
  Addresses(Execution& execution, CodeValues& values) : ExecutionPart(execution), values_(values) {}

  terms::TermId NumberOf(const CodeValue& pointer, uint8_t width);
  CodeValue PointerAt(terms::TermId number);
  /// Of locals that the number leads into, all bytes below it.
  void ForgetBelow(terms::TermId number);
  /// That it is an address in the local that `other` leads into, or its end.
  void RequireWithin(terms::TermId number, terms::TermId other);
  /// That it is none below `limit`, in the local that this leads into.
  void RequireNotBelow(terms::TermId number, terms::TermId limit);

 private:
  terms::TermId AddressOf(uint32_t object, uint8_t width);
  std::vector<Target> TargetsOf(terms::TermId number);

  CodeValues& values_;
  std::unordered_map<uint32_t, terms::TermId> addresses_;      // by object; looked up only
  std::unordered_map<uint32_t, uint32_t> object_at_;           // by term of an address; looked up only
  std::unordered_map<uint32_t, std::vector<Target>> targets_;  // by term; looked up only
};

}  // namespace plcxx::prove::verify::llvm_ir
