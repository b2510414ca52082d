// The machine around a program, as plant.yaml declares it: what its inputs do after its outputs.
//
// In: the file's text. Out: a model that never changes, the names of the locations that it reads and drives, and a
// plant at a moment: after each stretch of time, with the outputs as they were in it, the inputs that follow. The same
// outputs at the same times give the same inputs. Not its job: what a name is in a program, and when a period runs
// (scenarios/control.h).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/plant/element.h"
#include "transpiler/yaml/place.h"

namespace plcxx::plant {

/// A location that the plant writes.
struct Driven {
  yaml::MarkedText name;
  std::string element;  // "turret 'tools'", or "turret" without a name
};

class Model {
 public:
  const std::string& path() const { return path_; }
  /// Locations by their numbers; each once.
  const std::vector<yaml::MarkedText>& reads() const { return reads_; }
  const std::vector<Driven>& drives() const { return drives_; }

 private:
  friend class Plant;
  friend class PlantReader;
  struct Placed {
    std::unique_ptr<const Element> element;
    uint32_t begin = 0;  // of its numbers in the state
  };
  std::string path_;
  std::vector<yaml::MarkedText> reads_;
  std::vector<Driven> drives_;
  std::vector<Placed> elements_;
  uint32_t size_ = 0;
};

using ModelOrErrors = std::variant<std::shared_ptr<const Model>, std::vector<yaml::Error>>;
ModelOrErrors ReadPlant(const std::string& path);
/// As ReadPlant, from a text in memory.
ModelOrErrors ParsePlant(const std::string& path, const std::string& text);

/// A plant at a moment; a copy of it is the moment kept.
class Plant {
 public:
  /// At delivery.
  explicit Plant(std::shared_ptr<const Model> model);

  const Model& model() const { return *model_; }
  /// So much time passes; `reads` are the values of Model::reads() in it. Gives those of Model::drives() after it.
  std::span<const int64_t> Advance(uint64_t elapsed_ms, std::span<const int64_t> reads);
  std::span<const int64_t> drives() const { return drives_; }
  /// Of the same model: both go on alike.
  bool IsAtMomentOf(const Plant& other) const { return state_ == other.state_ && drives_ == other.drives_; }

 private:
  void Show();

  std::shared_ptr<const Model> model_;
  std::vector<int64_t> state_, drives_;
};

}  // namespace plcxx::plant
