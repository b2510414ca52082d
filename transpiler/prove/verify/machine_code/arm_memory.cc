// What instructions of ARM's Thumb do: loads and stores.
#include <llvm/BinaryFormat/ELF.h>
#include <llvm/MC/MCSubtargetInfo.h>

#include <utility>
#include <vector>

#include "transpiler/prove/verify/machine_code/arm_lifter.h"

namespace plcxx::prove::verify::machine_code {

void ArmLifter::RefuseBelowStack(unsigned base, unsigned offset) {
  const bool below = RegisterAt(base) == kStackPointer && !IsRegister(offset) && NumberAt(offset) < 0;
  if (below) lifter_.Refuse("an access below the stack pointer");
}

unsigned ArmLifter::LeastAlign() {
  return lifter_.program().machine().subtarget().checkFeatures("+strict-align") ? row_.bits / 8 : 1;
}

void ArmLifter::Access() {
  const bool loads = row_.form == ArmForm::kLoad || row_.form == ArmForm::kLoadPre || row_.form == ArmForm::kLoadPost;
  const bool pre = row_.form == ArmForm::kLoadPre || row_.form == ArmForm::kStorePre;
  const bool post = row_.form == ArmForm::kLoadPost || row_.form == ArmForm::kStorePost;
  const unsigned reg = (pre || post) && !loads ? 1 : 0;
  const unsigned base = pre || post ? 2 : 1;
  const unsigned back = loads ? 1 : 0;
  if (!pre && !post) RefuseBelowStack(base, base + 1);
  llvm::Value* before = Get(base);
  llvm::Value* moved = build_.CreateAdd(before, Offset(base + 1, row_.scale));
  llvm::Value* address = post ? before : moved;
  const unsigned align = LeastAlign();
  if (loads) {
    llvm::Value* value = lifter_.Load(address, row_.bits, align);
    if (row_.bits < 32)
      value = row_.has_sign ? build_.CreateSExt(value, lifter_.Word()) : build_.CreateZExt(value, lifter_.Word());
    if (pre || post) lifter_.Set(RegisterAt(back), moved);
    SetRegister(RegisterAt(reg), value);
    return;
  }
  llvm::Value* value = Get(reg);
  if (row_.bits < 32) value = build_.CreateTrunc(value, build_.getIntNTy(row_.bits));
  // What is stored by a stack pointer that goes down is above it at once.
  if (pre) lifter_.Set(RegisterAt(back), moved);
  lifter_.Store(address, value, align);
  if (post) lifter_.Set(RegisterAt(back), moved);
}

void ArmLifter::AccessPair() {
  const bool pre = row_.form == ArmForm::kLoadPairPre || row_.form == ArmForm::kStorePairPre;
  const bool post = row_.form == ArmForm::kLoadPairPost || row_.form == ArmForm::kStorePairPost;
  const bool loads =
      row_.form == ArmForm::kLoadPair || row_.form == ArmForm::kLoadPairPre || row_.form == ArmForm::kLoadPairPost;
  const unsigned first = (pre || post) && !loads ? 1 : 0;
  const unsigned base = pre || post ? 3 : 2;
  const unsigned back = loads ? 2 : 0;
  if (!pre && !post) RefuseBelowStack(base, base + 1);
  llvm::Value* before = Get(base);
  llvm::Value* moved = build_.CreateAdd(before, Offset(base + 1, 1));
  llvm::Value* address = post ? before : moved;
  llvm::Value* next = build_.CreateAdd(address, lifter_.Number(4));
  if (loads) {
    llvm::Value* low = lifter_.Load(address, 32, 4);
    llvm::Value* high = lifter_.Load(next, 32, 4);
    lifter_.Set(RegisterAt(first), low);
    lifter_.Set(RegisterAt(first + 1), high);
  } else {
    llvm::Value* low = Get(first);
    llvm::Value* high = Get(first + 1);
    if (pre) lifter_.Set(RegisterAt(back), moved);
    lifter_.Store(address, low, 4);
    lifter_.Store(next, high, 4);
  }
  if (post || (pre && loads)) lifter_.Set(RegisterAt(back), moved);
}

/// A list of registers, the lowest at the lowest address.
void ArmLifter::AccessMany() {
  const bool stack = row_.form == ArmForm::kPush || row_.form == ArmForm::kPop;
  const bool stores = row_.form == ArmForm::kPush || row_.form == ArmForm::kStoreDown ||
                      row_.form == ArmForm::kStoreUp || row_.form == ArmForm::kStoreFrom;
  const bool moves = row_.form != ArmForm::kStoreFrom && row_.form != ArmForm::kLoadFrom;
  const bool twice =
      row_.form == ArmForm::kStoreDown || row_.form == ArmForm::kLoadUp || row_.form == ArmForm::kStoreUp;
  const unsigned base = stack ? kStackPointer : RegisterAt(0);
  const unsigned first = stack ? 0 : twice ? 2 : 1;
  std::vector<unsigned> list;
  for (unsigned i = first; i < operand_count(); ++i) list.push_back(RegisterAt(i));
  const auto bytes = static_cast<uint64_t>(4 * list.size());
  llvm::Value* before = lifter_.Get(base);
  const bool down = row_.form == ArmForm::kPush || row_.form == ArmForm::kStoreDown;
  llvm::Value* from = down ? build_.CreateSub(before, lifter_.Number(bytes)) : before;
  llvm::Value* after = down ? from : build_.CreateAdd(before, lifter_.Number(bytes));
  bool base_is_loaded = false;
  std::vector<llvm::Value*> stored;
  std::vector<std::pair<unsigned, llvm::Value*>> loaded;
  for (size_t i = 0; stores && i < list.size(); ++i) stored.push_back(lifter_.Get(list[i]));
  if (down) lifter_.Set(base, after);
  for (size_t i = 0; i < list.size(); ++i) {
    llvm::Value* address = build_.CreateAdd(from, lifter_.Number(4 * i));
    if (stores) {
      lifter_.Store(address, stored[i], 4);
    } else {
      loaded.emplace_back(list[i], lifter_.Load(address, 32, 4));
      base_is_loaded = base_is_loaded || list[i] == base;
    }
  }
  if (moves && !down && !(row_.form == ArmForm::kLoadUpNarrow && base_is_loaded)) lifter_.Set(base, after);
  for (const auto& [number, value] : loaded) SetRegister(number, value);
}

void ArmLifter::LoadConstant() {
  const uint64_t at = ((lifter_.current().address + 4) & ~uint64_t{3}) + static_cast<uint64_t>(NumberAt(1));
  const Section& section = lifter_.section();
  uint32_t word = 0;
  // Where the section is the linker says, but for its alignment.
  if (section.align % 4 != 0 || at > section.bytes.size() || section.bytes.size() - at < 4)
    return lifter_.Refuse("a constant that is not in the section");
  for (unsigned i = 0; i < 4; ++i) word |= uint32_t{static_cast<uint8_t>(section.bytes[at + i])} << (8 * i);
  const auto notes = lifter_.program().NotesOn(section, at, 4);
  if (notes.empty()) {
    lifter_.Set(RegisterAt(0), lifter_.Number(word));
    return;
  }
  Link symbol = *notes.front().second;
  symbol.addend = static_cast<int32_t>(word);
  const bool whole = notes.size() == 1 && symbol.type == llvm::ELF::R_ARM_ABS32 && notes.front().first == at;
  llvm::Value* address = whole ? lifter_.AddressOf(symbol) : nullptr;
  if (address == nullptr) lifter_.Refuse("the address of " + symbol.symbol);
  lifter_.Set(RegisterAt(0), address != nullptr ? address : lifter_.Number(0));
}

}  // namespace plcxx::prove::verify::machine_code
