// A plant joined to one program: each of its names is a location.
//
// In: a model and a program. Out: what it reads and drives as locations, or all names that are none. Not its job: when
// the plant moves (control.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"
#include "transpiler/plant/plant.h"
#include "transpiler/yaml/place.h"

namespace plcxx::scenarios {

class BoundPlant {
 public:
  BoundPlant(std::shared_ptr<const plant::Model> model, std::vector<dialects::Location> reads,
             std::vector<dialects::Location> drives)
      : model_(std::move(model)), reads_(std::move(reads)), drives_(std::move(drives)) {}

  const plant::Model& model() const { return *model_; }
  const std::shared_ptr<const plant::Model>& shared_model() const { return model_; }
  const std::vector<dialects::Location>& reads() const { return reads_; }
  const std::vector<dialects::Location>& drives() const { return drives_; }

  /// Which element drives the location, or some of it; nullptr: none does.
  const plant::Driven* DriverOf(const dialects::Location& location) const;

 private:
  std::shared_ptr<const plant::Model> model_;
  std::vector<dialects::Location> reads_, drives_;
};

using BoundOrErrors = std::variant<std::shared_ptr<const BoundPlant>, std::vector<yaml::Error>>;
BoundOrErrors BindPlant(std::shared_ptr<const plant::Model> model, const dialects::Dialect& dialect,
                        const ir::Program& program);

/// "turret 'tools' (plant.yaml:7)"
std::string DriverText(const plant::Driven& driver, const std::string& path);

/// Whether two locations have a bit in common.
bool Overlap(const dialects::Location& one, const dialects::Location& other);

/// What the bits of a location are as a number for a plant; a real number is rounded.
int64_t PlantNumber(const dialects::Location& location, uint64_t bits);
/// The other way; what does not fit loses its high bits.
uint64_t PlantBits(const dialects::Location& location, int64_t number);

}  // namespace plcxx::scenarios
