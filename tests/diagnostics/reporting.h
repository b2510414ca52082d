// What the tests of the renderers share: a source, an engine, and messages that stand in no catalogue.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/source/source.h"

namespace plcxx::diag {

inline constexpr Message<Text> kBroken{{"Broken", "test-1", Severity::kError, "'{0}' is broken", "mend it"}};
inline constexpr Message<> kOdd{{"Odd", "test-W7", Severity::kWarning, "this is odd", ""}};

struct Reporting {
  explicit Reporting(std::string text, std::string path = "a.plc") {
    file = sources.AddText(std::move(path), std::move(text));
  }

  /// The first occurrence of `what`.
  source::Range Find(std::string_view what) const {
    const source::File& source = sources.Get(file);
    const auto begin = source.base + static_cast<source::Offset>(source.text.find(what));
    return {begin, begin + static_cast<source::Offset>(what.size())};
  }
  source::Range At(source::Offset begin, source::Offset end) const {
    const source::Offset base = sources.Get(file).base;
    return {base + begin, base + end};
  }

  std::string Text(const TextStyle& style = {}) const { return RenderText(sources, engine.all(), style); }
  std::string Json() const { return RenderJson(sources, engine.all()); }
  std::string Sarif() const { return RenderSarif(sources, engine.all(), "0.1.0"); }

  source::SourceManager sources;
  source::FileId file;
  Engine engine;
};

}  // namespace plcxx::diag
