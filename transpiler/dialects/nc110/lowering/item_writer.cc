#include "transpiler/dialects/nc110/lowering/item_writer.h"

#include "transpiler/dialects/nc110/lowering/blocks.h"
#include "transpiler/dialects/nc110/lowering/routines.h"
#include "transpiler/dialects/nc110/lowering/statement_writer.h"
#include "transpiler/dialects/nc110/lowering/targets.h"

namespace plcxx::nc110 {

void ItemWriter::EnterPart(Part part) {
  blocks_.CloseAll();
  part_ = part;
  builder_.SetRegion(program_.routines[part == Part::kFast ? routines_.fast() : routines_.slow()].body);
}

void ItemWriter::LowerAll() {
  EnterPart(Part::kFast);
  for (uint32_t i = 0; i < tree_.items.size(); ++i) {
    const ItemId id(i);
    const Item& item = tree_.items[id];
    statements_.AddFileComments(id);
    if (item.kind != ItemKind::kBlockHead) blocks_.LeaveChain();
    switch (item.kind) {
      case ItemKind::kCycleMark:
        statements_.AddComments(item);
        if (part_ == Part::kFast) EnterPart(Part::kSlow);
        break;
      case ItemKind::kMessage:
        statements_.AddComments(item);
        break;
      case ItemKind::kAssignment:
        statements_.Begin(id);
        targets_.Assign(item);
        break;
      case ItemKind::kBlockHead:
        blocks_.Head(id);
        break;
      case ItemKind::kBlockEnd:
        blocks_.End(id);
        break;
      case ItemKind::kError:
        break;
    }
  }
  blocks_.CloseAll();
}

}  // namespace plcxx::nc110
