// One element of a plant: what it does in time.
//
// An element does not change; where it is at a moment are a few numbers outside of it, so that a moment can be kept and
// gone back to. All of them are whole numbers: the same time in other pieces leads to the same place, as long as the
// outputs do not change meanwhile (but for the angle of a spindle that changes its speed).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/plant/condition.h"
#include "transpiler/plant/elements.h"

namespace plcxx::plant {

class Element {
 public:
  virtual ~Element() = default;
  /// How many numbers say where it is.
  virtual uint32_t size() const { return 0; }
  /// The machine is delivered.
  virtual void Deliver(std::span<int64_t> /*state*/) const {}
  /// So much time passes while the locations that are read have these values.
  virtual void Advance(uint64_t /*elapsed_ms*/, std::span<const int64_t> /*reads*/,
                       std::span<int64_t> /*state*/) const {}
  /// What its inputs are now.
  virtual void Show(std::span<const int64_t> state, std::span<int64_t> drives) const = 0;
};

/// A number that is written in the file, or that a location has.
struct Amount {
  int64_t thousandths = 0;
  std::optional<uint32_t> read;

  int64_t Value(std::span<const int64_t> reads, int64_t step_thousandths) const;
};

/// What the file says of an element, by key; numbers are whole or thousandths, as the shape of the key says.
struct Field {
  yaml::Place mark;
  Condition condition = Condition::Never();
  std::vector<uint32_t> drives;
  std::vector<std::pair<uint32_t, int64_t>> values;
  int64_t number = 0;
  Amount amount;
  std::string word;
};

class Fields {
 public:
  std::map<std::string, Field, std::less<>> all;
  yaml::Place mark;

  const Field* Find(std::string_view key) const {
    const auto found = all.find(key);
    return found == all.end() ? nullptr : &found->second;
  }
  Condition TakeCondition(std::string_view key, const Condition& otherwise) const {
    const Field* const field = Find(key);
    return field == nullptr ? otherwise : field->condition;
  }
  int64_t Number(std::string_view key, int64_t otherwise) const {
    const Field* const field = Find(key);
    return field == nullptr ? otherwise : field->number;
  }
  std::string_view Word(std::string_view key, std::string_view otherwise) const {
    const Field* const field = Find(key);
    return field == nullptr ? otherwise : std::string_view(field->word);
  }
  std::optional<uint32_t> Drive(std::string_view key) const {
    const Field* const field = Find(key);
    return field == nullptr ? std::nullopt : std::optional(field->drives.front());
  }
  std::vector<uint32_t> Drives(std::string_view key) const {
    const Field* const field = Find(key);
    return field == nullptr ? std::vector<uint32_t>() : field->drives;
  }
  std::vector<std::pair<uint32_t, int64_t>> Values(std::string_view key) const {
    const Field* const field = Find(key);
    return field == nullptr ? std::vector<std::pair<uint32_t, int64_t>>() : field->values;
  }
};

/// What is wrong with values that are right one by one.
struct FieldFault {
  std::string key, message, remedy;
};
struct MadeElement {
  std::unique_ptr<const Element> element;
  std::optional<FieldFault> fault;
};

/// All needed keys are there.
MadeElement MakeElement(ElementKind kind, const Fields& fields);

// One for each kind; MakeElement chooses.
MadeElement MakeSwitch(const Fields& fields);
MadeElement MakeFixed(const Fields& fields);
MadeElement MakeCylinder(const Fields& fields);
MadeElement MakeTurret(const Fields& fields);
MadeElement MakeMagazine(const Fields& fields);
MadeElement MakeAxis(const Fields& fields);
MadeElement MakeTank(const Fields& fields);
MadeElement MakeSpindle(const Fields& fields);

}  // namespace plcxx::plant
