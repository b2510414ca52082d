#include "transpiler/scenarios/bound_plant.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::scenarios {
namespace {

/// The bits that a place has of the byte at `offset` of its space.
uint8_t BitsOfByte(const ir::Place& place, uint32_t offset) {
  if (place.type == ir::Type::kBit) return place.offset == offset ? static_cast<uint8_t>(1u << place.bit) : uint8_t{0};
  return offset >= place.offset && offset < place.offset + ir::Bytes(place.type) ? uint8_t{0xFF} : uint8_t{0};
}

bool PlacesOverlap(const ir::Place& one, const ir::Place& other) {
  if (one.is_field() || other.is_field()) return one.is_field() && other.is_field() && one.name == other.name;
  if (!one.space.valid() || !other.space.valid() || one.space != other.space) return false;
  const uint32_t bytes = one.type == ir::Type::kBit ? 1 : ir::Bytes(one.type);
  for (uint32_t i = 0; i < bytes; ++i) {
    if ((BitsOfByte(one, one.offset + i) & BitsOfByte(other, one.offset + i)) != 0) return true;
  }
  return false;
}

std::vector<ir::Place> PlacesOf(const dialects::Location& location) {
  return location.bits.empty() ? std::vector{location.place} : location.bits;
}

uint32_t WidthOf(const dialects::Location& location) {
  if (!location.bits.empty()) return static_cast<uint32_t>(location.bits.size());
  return location.place.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(location.place.type);
}

class Binder {
 public:
  Binder(const plant::Model& model, const dialects::Dialect& dialect, const ir::Program& program)
      : model_(model), dialect_(dialect), names_(program) {}

  void Bind() {
    for (const yaml::MarkedText& name : model_.reads()) reads_.push_back(Find(name));
    for (const plant::Driven& driven : model_.drives()) {
      dialects::Location location = Find(driven.name);
      if (location.cell) {
        Fail(driven.name, "'" + driven.name.text + "' is no memory of the program: the plant cannot drive it",
             "drive an input");
      }
      CheckAlone(driven, location);
      drives_.push_back(std::move(location));
    }
  }

  std::vector<yaml::Error>& errors() { return errors_; }
  std::vector<dialects::Location>& reads() { return reads_; }
  std::vector<dialects::Location>& drives() { return drives_; }

 private:
  void Fail(const yaml::MarkedText& name, std::string message, std::string remedy) {
    errors_.push_back({model_.path(), name.mark, std::move(message), std::move(remedy)});
  }

  dialects::Location Find(const yaml::MarkedText& name) {
    const std::optional<dialects::Location> location = dialect_.locate(names_, name.text);
    if (!location) {
      Fail(name, NoSuchLocation(dialect_, names_.program(), name.text),
           "write it as in a scenario; plcxx report --print-symbols lists the names");
      return {};
    }
    if (location->text_input)
      Fail(name, "'" + name.text + "' is the operator's keyboard", "name an input or an output");
    if (location->absent) {
      Fail(name, "the program does not use '" + name.text + "'", "name a location that it uses");
      return {};
    }
    return *location;
  }

  void CheckAlone(const plant::Driven& driven, const dialects::Location& location) {
    for (size_t i = 0; i < drives_.size(); ++i) {
      if (!Overlap(drives_[i], location)) continue;
      Fail(driven.name,
           "'" + driven.name.text + "' and '" + model_.drives()[i].name.text + "' of line " +
               std::to_string(model_.drives()[i].name.mark.line) + " are the same memory",
           "drive it once");
      return;
    }
  }

  const plant::Model& model_;
  const dialects::Dialect& dialect_;
  const ir::NameIndex names_;
  std::vector<dialects::Location> reads_, drives_;
  std::vector<yaml::Error> errors_;
};

}  // namespace

bool Overlap(const dialects::Location& one, const dialects::Location& other) {
  if (one.cell || other.cell) return one.cell && other.cell && *one.cell == *other.cell;
  for (const ir::Place& first : PlacesOf(one)) {
    for (const ir::Place& second : PlacesOf(other)) {
      if (PlacesOverlap(first, second)) return true;
    }
  }
  return false;
}

const plant::Driven* BoundPlant::DriverOf(const dialects::Location& location) const {
  for (size_t i = 0; i < drives_.size(); ++i) {
    if (Overlap(drives_[i], location)) return &model_->drives()[i];
  }
  return nullptr;
}

BoundOrErrors BindPlant(std::shared_ptr<const plant::Model> model, const dialects::Dialect& dialect,
                        const ir::Program& program) {
  Binder binder(*model, dialect, program);
  binder.Bind();
  if (!binder.errors().empty()) return std::move(binder.errors());
  return std::make_shared<const BoundPlant>(std::move(model), std::move(binder.reads()), std::move(binder.drives()));
}

std::string DriverText(const plant::Driven& driver, const std::string& path) {
  return driver.element + " (" + std::filesystem::path(path).filename().string() + ":" +
         std::to_string(driver.name.mark.line) + ")";
}

int64_t PlantNumber(const dialects::Location& location, uint64_t bits) {
  const ir::Type type = location.place.type;
  if (type == ir::Type::kF32 || type == ir::Type::kF64) {
    constexpr double kMax = 1e15;
    const double real =
        type == ir::Type::kF32 ? std::bit_cast<float>(static_cast<uint32_t>(bits)) : std::bit_cast<double>(bits);
    return std::isnan(real) ? 0 : std::llround(std::clamp(real, -kMax, kMax));
  }
  const uint32_t width = WidthOf(location);
  if (!location.has_sign || width >= 64 || (bits >> (width - 1) & 1) == 0) return static_cast<int64_t>(bits);
  return static_cast<int64_t>(bits | ~uint64_t{0} << width);
}

uint64_t PlantBits(const dialects::Location& location, int64_t number) {
  const ir::Type type = location.place.type;
  if (type == ir::Type::kF32) return std::bit_cast<uint32_t>(static_cast<float>(number));
  if (type == ir::Type::kF64) return std::bit_cast<uint64_t>(static_cast<double>(number));
  const uint32_t width = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  return FittingField(location, static_cast<uint64_t>(number) & support::LowBits(width));
}

}  // namespace plcxx::scenarios
