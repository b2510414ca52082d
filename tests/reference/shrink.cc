// Makes a random program small that shows a disagreement.

#include <algorithm>
#include <utility>

#include "tests/reference/runs.h"

namespace plcxx::reference {
namespace {

enum class Cut : uint8_t {
  kWhole,   // a piece with its body
  kAround,  // what a piece puts around its body
};

/// A copy of `pieces` without those numbered [first, last) in the order of the source; `next` counts them.
std::vector<Piece> Without(const std::vector<Piece>& pieces, size_t first, size_t last, Cut cut, size_t& next) {
  std::vector<Piece> kept;
  for (const Piece& piece : pieces) {
    const size_t number = next++;
    Piece copy{piece.text, Without(piece.body, first, last, cut, next), piece.end};
    if (number < first || number >= last) {
      kept.push_back(std::move(copy));
    } else if (cut == Cut::kAround && !piece.body.empty()) {
      kept.insert(kept.end(), copy.body.begin(), copy.body.end());
    } else if (cut == Cut::kAround) {
      kept.push_back(std::move(copy));
    }
  }
  return kept;
}

size_t Count(const std::vector<Piece>& pieces) {
  size_t count = pieces.size();
  for (const Piece& piece : pieces) count += Count(piece.body);
  return count;
}

size_t Count(const RandomProgram& program) {
  size_t count = 0;
  for (const RandomFile& file : program.files) count += Count(file.pieces);
  return count;
}

RandomProgram Without(const RandomProgram& program, size_t first, size_t last, Cut cut) {
  RandomProgram less = program;
  size_t next = 0;
  for (RandomFile& file : less.files) file.pieces = Without(file.pieces, first, last, cut, next);
  return less;
}

class Shrinking {
 public:
  Shrinking(RandomProgram program, const std::function<bool(const RandomProgram&)>& fails)
      : program_(std::move(program)), fails_(fails) {}

  RandomProgram Run() {
    for (bool smaller = true; smaller;) {
      smaller = Steps();
      smaller |= Pieces(Cut::kWhole);
      smaller |= Pieces(Cut::kAround);
      smaller |= Options();
    }
    return std::move(program_);
  }

 private:
  bool Take(RandomProgram&& less) {
    if (!fails_(less)) return false;
    program_ = std::move(less);
    return true;
  }

  bool Pieces(Cut cut) {
    bool any = false;
    for (size_t size = std::max<size_t>(1, Count(program_) / 2); size > 0; size /= 2) {
      for (size_t first = 0; first < Count(program_);) {
        const size_t before = Count(program_);
        if (Take(Without(program_, first, first + size, cut)) && Count(program_) < before) {
          any = true;
        } else {
          first += size;
        }
      }
    }
    return any;
  }

  bool Steps() {
    bool any = false;
    for (size_t size = std::max<size_t>(1, program_.steps.size() / 2); size > 0; size /= 2) {
      for (size_t first = 0; first < program_.steps.size();) {
        RandomProgram less = program_;
        const auto begin = less.steps.begin() + static_cast<std::ptrdiff_t>(first);
        less.steps.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, less.steps.size() - first)));
        if (Take(std::move(less))) {
          any = true;
        } else {
          first += size;
        }
      }
    }
    return any;
  }

  bool Options() {
    bool any = false;
    for (const auto& [key, value] : std::map<std::string, std::string>(program_.options)) {
      RandomProgram less = program_;
      less.options.erase(key);
      any |= Take(std::move(less));
    }
    if (program_.caprices) {
      RandomProgram obliging = program_;
      obliging.caprices.reset();
      any |= Take(std::move(obliging));
    }
    RandomProgram plain = program_;
    for (RandomFile& file : plain.files) {
      file = {.name = file.name, .pieces = std::move(file.pieces), .is_source = file.is_source};
    }
    const auto is_plain = [](const RandomFile& file) {
      return file.head.empty() && file.line_end == "\n" && file.tail.empty();
    };
    if (!std::ranges::all_of(program_.files, is_plain)) any |= Take(std::move(plain));
    return any;
  }

  RandomProgram program_;
  const std::function<bool(const RandomProgram&)>& fails_;
};

}  // namespace

RandomProgram Shrink(RandomProgram program, const std::function<bool(const RandomProgram& program)>& fails) {
  return Shrinking(std::move(program), fails).Run();
}

}  // namespace plcxx::reference
