#include "transpiler/compile/program_code.h"

#include <unordered_map>

namespace plcxx::compile {

ProgramCode::ProgramCode(std::vector<ObjectFacts> objects) : objects_(std::move(objects)) {
  std::unordered_map<std::string, uint32_t> global;
  for (uint32_t o = 0; o < objects_.size(); ++o) {
    const auto base = static_cast<uint32_t>(places_.size());
    for (uint32_t i = 0; i < objects_[o].functions.size(); ++i) places_.push_back({o, i});
    targets_.emplace_back();
    for (const CodeSymbol& symbol : objects_[o].symbols) {
      const uint32_t target = symbol.function == kNoFunction ? kNoFunction : base + symbol.function;
      targets_.back().push_back(target);
      if (symbol.defined && !symbol.local) defined_.insert(symbol.name);
      if (target != kNoFunction && !symbol.local) global.emplace(symbol.name, target);
    }
  }
  for (uint32_t o = 0; o < objects_.size(); ++o) {
    for (size_t s = 0; s < targets_[o].size(); ++s) {
      const auto found = global.find(objects_[o].symbols[s].name);
      const bool open = targets_[o][s] == kNoFunction && !objects_[o].symbols[s].defined;
      if (open && found != global.end()) targets_[o][s] = found->second;
    }
  }
}

std::string ProgramCode::Name(uint32_t id) const { return NameOf(Text(id)); }

uint32_t ProgramCode::Callee(uint32_t caller, const CodeCall& call) const {
  return targets_[places_[caller].object][call.symbol];
}

uint32_t ProgramCode::Find(std::string_view name) const {
  for (uint32_t o = 0; o < objects_.size(); ++o) {
    for (size_t s = 0; s < objects_[o].symbols.size(); ++s) {
      const CodeSymbol& symbol = objects_[o].symbols[s];
      // A dot is in the names of pieces that the compiler made of a function.
      const bool whole = !symbol.local && symbol.name.find('.') == std::string::npos;
      if (whole && symbol.function != kNoFunction && NameOf(symbol.text) == name) return targets_[o][s];
    }
  }
  return kNoFunction;
}

std::string NameOf(std::string_view text) {
  // An anonymous namespace has parentheses of its own.
  constexpr std::string_view kAnonymous = "(anonymous namespace)";
  size_t end = 0;
  for (;;) {
    end = text.find('(', end);
    if (end == std::string_view::npos || text.substr(end, kAnonymous.size()) != kAnonymous) break;
    end += kAnonymous.size();
  }
  return std::string(text.substr(0, end));
}

}  // namespace plcxx::compile
