#include "transpiler/plant/plant.h"

#include <utility>

namespace plcxx::plant {

Plant::Plant(std::shared_ptr<const Model> model)
    : model_(std::move(model)), state_(model_->size_), drives_(model_->drives_.size()) {
  for (const Model::Placed& placed : model_->elements_) {
    placed.element->Deliver(std::span(state_).subspan(placed.begin, placed.element->size()));
  }
  Show();
}

void Plant::Show() {
  for (const Model::Placed& placed : model_->elements_) {
    placed.element->Show(std::span(state_).subspan(placed.begin, placed.element->size()), drives_);
  }
}

std::span<const int64_t> Plant::Advance(uint64_t elapsed_ms, std::span<const int64_t> reads) {
  for (const Model::Placed& placed : model_->elements_) {
    placed.element->Advance(elapsed_ms, reads, std::span(state_).subspan(placed.begin, placed.element->size()));
  }
  Show();
  return drives_;
}

}  // namespace plcxx::plant
