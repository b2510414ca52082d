// What functions of compilers' own libraries do.
#include <llvm/IR/Intrinsics.h>

#include <array>
#include <string_view>
#include <utility>

#include "transpiler/prove/verify/machine_code/lifter.h"
#include "transpiler/support/check.h"

namespace plcxx::prove::verify::machine_code {
namespace {

enum class LibraryShape : uint8_t { kWide, kShift, kNarrow, kBits, kMemory, kFloat, kCompare, kConvert };

enum class LibraryOperation : uint8_t {
  kUnsignedQuotient,
  kUnsignedRest,
  kUnsignedBoth,  // the quotient, and after it the rest
  kSignedQuotient,
  kSignedRest,
  kSignedBoth,
  kProduct,
  kShiftLeft,
  kShiftRight,
  kShiftRightSigned,
  kLeadingZeros,
  kTrailingZeros,
  kOnes,
  kBytesSwapped,
  kCopy,             // to, from, length: gives `to`
  kCopyOnly,         // gives nothing
  kFill,             // to, byte, length: gives `to`
  kFillLengthFirst,  // to, length, byte: gives nothing
  kClear,            // to, length: gives nothing
  kAdd,
  kSub,
  kMul,
  kDiv,
  kNothing
};

enum class Comparison : uint8_t { kTruth, kZero, kBelow, kNotAbove, kAbove, kNotBelow };

struct LibraryRow {
  std::string_view symbol;
  LibraryShape shape{};
  LibraryOperation operation = LibraryOperation::kNothing;
  llvm::CmpInst::Predicate predicate = llvm::CmpInst::FCMP_FALSE;
  Comparison result{};
  llvm::Instruction::CastOps cast = llvm::Instruction::BitCast;
  unsigned bits = 0, to = 0;
  unsigned align = 1;
};

constexpr LibraryRow kLibrary[] = {
#define PLCXX_WIDE(SYMBOL, OPERATION) \
  {.symbol = SYMBOL, .shape = LibraryShape::kWide, .operation = LibraryOperation::OPERATION},
#define PLCXX_SHIFT(SYMBOL, OPERATION) \
  {.symbol = SYMBOL, .shape = LibraryShape::kShift, .operation = LibraryOperation::OPERATION},
#define PLCXX_NARROW(SYMBOL, OPERATION) \
  {.symbol = SYMBOL, .shape = LibraryShape::kNarrow, .operation = LibraryOperation::OPERATION},
#define PLCXX_BITS(SYMBOL, OPERATION) \
  {.symbol = SYMBOL, .shape = LibraryShape::kBits, .operation = LibraryOperation::OPERATION},
#define PLCXX_MEMORY(SYMBOL, OPERATION, ALIGN) \
  {.symbol = SYMBOL, .shape = LibraryShape::kMemory, .operation = LibraryOperation::OPERATION, .align = ALIGN},
#define PLCXX_FLOAT(SYMBOL, OPERATION, BITS) \
  {.symbol = SYMBOL, .shape = LibraryShape::kFloat, .operation = LibraryOperation::OPERATION, .bits = BITS},
#define PLCXX_COMPARE(SYMBOL, PREDICATE, RESULT, BITS) \
  {.symbol = SYMBOL,                                   \
   .shape = LibraryShape::kCompare,                    \
   .predicate = llvm::CmpInst::PREDICATE,              \
   .result = Comparison::RESULT,                       \
   .bits = BITS},
#define PLCXX_CONVERT(SYMBOL, CAST, FROM, TO) \
  {.symbol = SYMBOL, .shape = LibraryShape::kConvert, .cast = llvm::Instruction::CAST, .bits = FROM, .to = TO},
#include "transpiler/prove/verify/machine_code/library.def"
};

const LibraryRow* LibraryRowOf(std::string_view symbol) {
  for (const LibraryRow& row : kLibrary) {
    if (row.symbol == symbol) return &row;
  }
  return nullptr;
}

/// One call of such a function, whose arguments and results are numbers in registers.
class LibraryCall {
 public:
  LibraryCall(FunctionLifter& lifter, const LibraryRow& row) : lifter_(lifter), build_(lifter.build()), row_(row) {}

  void Run() {
    const std::vector<unsigned>& arguments = lifter_.program().convention().arguments;
    switch (row_.shape) {
      case LibraryShape::kWide:
        SetResults(Compute(Wide(arguments[0], arguments[1]), Wide(arguments[2], arguments[3])));
        return;
      case LibraryShape::kShift: {
        llvm::Value* wide = Wide(arguments[0], arguments[1]);
        // Only counts below the width are promised.
        llvm::Value* count = build_.CreateZExt(lifter_.Get(arguments[2]), wide->getType());
        const unsigned bits = wide->getType()->getIntegerBitWidth();
        build_.CreateAssumption(build_.CreateICmpULT(count, llvm::ConstantInt::get(wide->getType(), bits)));
        SetResults(Compute(wide, count));
        return;
      }
      case LibraryShape::kNarrow:
        SetResults(Compute(lifter_.Get(arguments[0]), lifter_.Get(arguments[1])));
        return;
      case LibraryShape::kBits:
        SetResults(Compute(lifter_.Get(arguments[0]), nullptr));
        return;
      case LibraryShape::kMemory:
        RunMemory(arguments);
        return;
      case LibraryShape::kFloat:
        SetResults({AsNumber(Compute(Float(0, row_.bits), Float(1, row_.bits)).front())});
        return;
      case LibraryShape::kCompare:
        SetResults({Compare(build_.CreateFCmp(row_.predicate, Float(0, row_.bits), Float(1, row_.bits)))});
        return;
      case LibraryShape::kConvert:
        SetResults({Convert()});
        return;
    }
  }

 private:
  using Results = std::vector<llvm::Value*>;

  llvm::Value* Wide(unsigned low, unsigned high) {
    const std::array words = {lifter_.Get(low), lifter_.Get(high)};
    return lifter_.program().Join(build_, words, 2 * lifter_.program().convention().bits);
  }

  /// A result of two registers is two of one, the low one first; what else such a function writes is not known after
  /// it.
  void SetResults(const Results& results) {
    const Convention& convention = lifter_.program().convention();
    Results words;
    for (llvm::Value* result : results) {
      const Results split = lifter_.program().Split(build_, result);
      words.insert(words.end(), split.begin(), split.end());
    }
    lifter_.ForgetAfterCall();
    // Of ARM both halves of both numbers are in r0 to r3.
    for (size_t i = 0; i < words.size(); ++i) lifter_.Set(convention.arguments[i], words[i]);
  }

  /// The argument of that number, of so many bits; all before it are as wide.
  llvm::Value* Argument(unsigned number, unsigned bits) {
    const std::vector<unsigned>& arguments = lifter_.program().convention().arguments;
    const bool wide = bits > lifter_.program().convention().bits;
    return wide ? Wide(arguments[2 * number], arguments[2 * number + 1]) : lifter_.Get(arguments[number]);
  }
  llvm::Type* FloatOf(unsigned bits) { return bits == 32 ? build_.getFloatTy() : build_.getDoubleTy(); }
  llvm::Value* Float(unsigned number, unsigned bits) {
    return build_.CreateBitCast(Argument(number, bits), FloatOf(bits));
  }
  llvm::Value* AsNumber(llvm::Value* value) {
    return build_.CreateBitCast(
        value, build_.getIntNTy(static_cast<unsigned>(value->getType()->getPrimitiveSizeInBits().getFixedValue())));
  }

  /// Only the sign of such a result is promised, or that it is 0.
  llvm::Value* Compare(llvm::Value* holds) {
    llvm::Value* some = lifter_.Unknown();
    llvm::Value* below = build_.CreateOr(some, lifter_.Number(0x80000000));
    llvm::Value* not_below = build_.CreateAnd(some, lifter_.Number(0x7FFFFFFF));
    llvm::Value* above = build_.CreateOr(build_.CreateLShr(not_below, 1), lifter_.Number(1));
    llvm::Value* not_above = build_.CreateSub(lifter_.Number(0), not_below);
    const auto choose = [&](llvm::Value* then, llvm::Value* otherwise) {
      return build_.CreateSelect(holds, then, otherwise);
    };
    switch (row_.result) {
      case Comparison::kTruth:
        return build_.CreateZExt(holds, lifter_.Word());
      case Comparison::kZero:
        return choose(lifter_.Number(0), build_.CreateOr(some, lifter_.Number(1)));
      case Comparison::kBelow:
        return choose(below, not_below);
      case Comparison::kNotAbove:
        return choose(not_above, above);
      case Comparison::kAbove:
        return choose(above, not_above);
      case Comparison::kNotBelow:
        return choose(not_below, below);
    }
    PLCXX_UNREACHABLE();
  }

  llvm::Value* Convert() {
    const bool from_float = row_.cast != llvm::Instruction::SIToFP && row_.cast != llvm::Instruction::UIToFP;
    const bool to_float = row_.cast != llvm::Instruction::FPToSI && row_.cast != llvm::Instruction::FPToUI;
    llvm::Value* from = from_float ? Float(0, row_.bits) : Argument(0, row_.bits);
    llvm::Value* result = build_.CreateCast(row_.cast, from, to_float ? FloatOf(row_.to) : build_.getIntNTy(row_.to));
    return to_float ? AsNumber(result) : result;
  }

  Results Compute(llvm::Value* a, llvm::Value* b) {
    const auto intrinsic = [&](llvm::Intrinsic::ID id, const std::vector<llvm::Value*>& arguments) -> llvm::Value* {
      llvm::Function* function = llvm::Intrinsic::getDeclaration(&lifter_.program().module(), id, {a->getType()});
      return build_.CreateCall(function, arguments);
    };
    switch (row_.operation) {
      case LibraryOperation::kUnsignedQuotient:
        return {build_.CreateUDiv(a, b)};
      case LibraryOperation::kUnsignedRest:
        return {build_.CreateURem(a, b)};
      case LibraryOperation::kUnsignedBoth:
        return {build_.CreateUDiv(a, b), build_.CreateURem(a, b)};
      case LibraryOperation::kSignedQuotient:
        return {build_.CreateSDiv(a, b)};
      case LibraryOperation::kSignedRest:
        return {build_.CreateSRem(a, b)};
      case LibraryOperation::kSignedBoth:
        return {build_.CreateSDiv(a, b), build_.CreateSRem(a, b)};
      case LibraryOperation::kProduct:
        return {build_.CreateMul(a, b)};
      case LibraryOperation::kShiftLeft:
        return {build_.CreateShl(a, b)};
      case LibraryOperation::kShiftRight:
        return {build_.CreateLShr(a, b)};
      case LibraryOperation::kShiftRightSigned:
        return {build_.CreateAShr(a, b)};
      case LibraryOperation::kLeadingZeros:
        return {intrinsic(llvm::Intrinsic::ctlz, {a, build_.getTrue()})};
      case LibraryOperation::kTrailingZeros:
        return {intrinsic(llvm::Intrinsic::cttz, {a, build_.getTrue()})};
      case LibraryOperation::kOnes:
        return {intrinsic(llvm::Intrinsic::ctpop, {a})};
      case LibraryOperation::kBytesSwapped:
        return {intrinsic(llvm::Intrinsic::bswap, {a})};
      case LibraryOperation::kAdd:
        return {build_.CreateFAdd(a, b)};
      case LibraryOperation::kSub:
        return {build_.CreateFSub(a, b)};
      case LibraryOperation::kMul:
        return {build_.CreateFMul(a, b)};
      case LibraryOperation::kDiv:
        return {build_.CreateFDiv(a, b)};
      case LibraryOperation::kCopy:
      case LibraryOperation::kCopyOnly:
      case LibraryOperation::kFill:
      case LibraryOperation::kFillLengthFirst:
      case LibraryOperation::kClear:
      case LibraryOperation::kNothing:
        break;
    }
    PLCXX_UNREACHABLE();
  }

  void RunMemory(const std::vector<unsigned>& arguments) {
    const auto get = [&](unsigned number) { return lifter_.Get(arguments[number]); };
    const auto pointer = [&](unsigned number) { return build_.CreateIntToPtr(get(number), build_.getPtrTy()); };
    const auto byte = [&](llvm::Value* value) { return build_.CreateTrunc(value, build_.getInt8Ty()); };
    const llvm::Align align(row_.align);
    llvm::Value* to = get(0);
    lifter_.DemandNotBelowStack(to);
    const bool copies = row_.operation == LibraryOperation::kCopy || row_.operation == LibraryOperation::kCopyOnly;
    if (copies) lifter_.DemandNotBelowStack(get(1));
    const bool gives = row_.operation == LibraryOperation::kCopy || row_.operation == LibraryOperation::kFill;
    if (copies) {
      build_.CreateMemMove(pointer(0), align, pointer(1), align, get(2));
    } else if (row_.operation == LibraryOperation::kFill) {
      build_.CreateMemSet(pointer(0), byte(get(1)), get(2), align);
    } else if (row_.operation == LibraryOperation::kFillLengthFirst) {
      build_.CreateMemSet(pointer(0), byte(get(2)), get(1), align);
    } else {
      build_.CreateMemSet(pointer(0), build_.getInt8(0), get(1), align);
    }
    SetResults(gives ? Results{to} : Results{});
  }

  FunctionLifter& lifter_;
  Builder& build_;
  const LibraryRow& row_;
};

}  // namespace

bool FunctionLifter::CallLibrary(const std::string& symbol) {
  const LibraryRow* row = LibraryRowOf(symbol);
  if (row == nullptr) return false;
  DemandStack(Get(program_.convention().stack), program_.convention().stack_align);
  LibraryCall(*this, *row).Run();
  return true;
}

}  // namespace plcxx::prove::verify::machine_code
