// A plant of a few lines, moved by hand: outputs by name, inputs by name.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/plant/plant.h"

namespace plcxx::plant {

inline std::string ErrorsOf(const std::string& text) {
  const ModelOrErrors read = ParsePlant("plant.yaml", text);
  std::string all;
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    for (const yaml::Error& error : *errors) all += ToText(error) + "\n";
  }
  return all;
}

class Bench {
 public:
  explicit Bench(const std::string& element) {
    const std::string text = "elements:\n- " + element + "\n";
    EXPECT_EQ(ErrorsOf(text), "");
    ModelOrErrors read = ParsePlant("plant.yaml", text);
    if (auto* model = std::get_if<std::shared_ptr<const Model>>(&read)) plant_ = std::make_unique<Plant>(*model);
  }

  void Set(const std::string& name, int64_t value) { outputs_[name] = value; }
  void Run(uint64_t ms) {
    std::vector<int64_t> reads;
    for (const yaml::MarkedText& name : plant_->model().reads()) reads.push_back(outputs_[name.text]);
    plant_->Advance(ms, reads);
  }
  int64_t Get(const std::string& name) const {
    for (size_t i = 0; i < plant_->model().drives().size(); ++i) {
      if (plant_->model().drives()[i].name.text == name) return plant_->drives()[i];
    }
    ADD_FAILURE() << "nothing drives " << name;
    return -1;
  }
  Plant Kept() const { return *plant_; }
  void GoBackTo(const Plant& kept) { *plant_ = kept; }

 private:
  std::unique_ptr<Plant> plant_;
  std::map<std::string, int64_t> outputs_;
};

/// Runs `ms` in steps of 1 ms, and gives when `name` became each of its values: "0:0 300:1".
inline std::string Changes(Bench& bench, const std::string& name, uint64_t ms) {
  std::string text = "0:" + std::to_string(bench.Get(name));
  for (uint64_t at = 1; at <= ms; ++at) {
    const int64_t before = bench.Get(name);
    bench.Run(1);
    if (bench.Get(name) != before) text += " " + std::to_string(at) + ":" + std::to_string(bench.Get(name));
  }
  return text;
}

}  // namespace plcxx::plant
