#include "transpiler/prove/wide/inputs.h"

#include <algorithm>
#include <utility>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::wide {
namespace {

constexpr uint32_t kWords = terms::Plane::kWords;
constexpr size_t kLeastBits = 4, kMostBits = 64;  // of a word that is compared bit by bit

/// All that a relation's cells are computed from; a cell that keeps its value is not.
std::vector<terms::TermId> RootsOf(const machine::Relation& relation) {
  std::vector<terms::TermId> roots;
  for (const std::vector<terms::TermId>* const part : {&relation.fast(), &relation.period()}) {
    for (uint32_t i = 0; i < part->size(); ++i) {
      const terms::TermId root = (*part)[i];
      if (root.valid() && relation.CellOf(root) != execute::CellId(i)) roots.push_back(root);
    }
  }
  return roots;
}

}  // namespace

std::vector<bool> ReadCells(const terms::Terms& terms, const machine::Relation& relation) {
  std::vector<bool> read(relation.version().cells.count);
  for (const terms::TermId id : terms::ConeOf(terms, RootsOf(relation))) {
    if (terms[id].kind != terms::TermKind::kVariable) continue;
    const execute::CellId cell = relation.CellOf(id);
    if (cell.valid()) read[cell.index] = true;
  }
  return read;
}

WideInputs::WideInputs(const terms::Terms& terms, std::vector<Input> inputs, std::span<const Reader> readers)
    : inputs_(std::move(inputs)) {
  for (const Reader& reader : readers) {
    const std::vector<terms::TermId> cone = terms::ConeOf(terms, RootsOf(reader.relation));
    AddWords(terms, reader, cone);
    AddConjunctions(terms, reader, cone);
  }
  Begin();
}

/// What comparisons with constants read.
void WideInputs::AddWords(const terms::Terms& terms, const Reader& reader, std::span<const terms::TermId> cone) {
  const auto& [relation, numbers] = reader;
  // The inputs of which a term is put together; false: it is computed from them.
  const auto add_bits = [&](auto&& self, terms::TermId id, uint32_t low, uint32_t width, Word& word) -> bool {
    const terms::Term& term = terms[id];
    switch (term.kind) {
      case terms::TermKind::kConst:
        word.insert(word.end(), width, kNone);
        return true;
      case terms::TermKind::kVariable: {
        const execute::CellId cell = relation.CellOf(id);
        const auto at = cell.valid() && term.width == 1 ? numbers.find(cell.index) : numbers.end();
        word.insert(word.end(), width, at == numbers.end() ? kNone : at->second);
        return true;
      }
      case terms::TermKind::kExtract:
        return self(self, terms::TermId(term.a), low + term.b, width, word);
      case terms::TermKind::kConcat: {
        const uint32_t split = terms.Width(terms::TermId(term.b));
        const uint32_t below = low < split ? std::min(width, split - low) : 0;
        if (below != 0 && !self(self, terms::TermId(term.b), low, below, word)) return false;
        return below == width || self(self, terms::TermId(term.a), low + below - split, width - below, word);
      }
      case terms::TermKind::kNot:
      case terms::TermKind::kAnd:
      case terms::TermKind::kOr:
      case terms::TermKind::kXor:
      case terms::TermKind::kAdd:
      case terms::TermKind::kSub:
      case terms::TermKind::kMul:
      case terms::TermKind::kUdiv:
      case terms::TermKind::kUrem:
      case terms::TermKind::kSdiv:
      case terms::TermKind::kSrem:
      case terms::TermKind::kShl:
      case terms::TermKind::kLshr:
      case terms::TermKind::kAshr:
      case terms::TermKind::kEq:
      case terms::TermKind::kUlt:
      case terms::TermKind::kSlt:
      case terms::TermKind::kIte:
      case terms::TermKind::kApply:
        return false;
    }
    return false;
  };
  for (const terms::TermId id : cone) {
    const terms::Term& term = terms[id];
    if (term.kind != terms::TermKind::kEq && term.kind != terms::TermKind::kUlt && term.kind != terms::TermKind::kSlt)
      continue;
    terms::TermId one(term.a), constant(term.b);
    if (terms.IsConst(one)) std::swap(one, constant);
    if (!terms.IsConst(constant) || terms.Width(one) < 2) continue;
    Word word;
    if (!add_bits(add_bits, one, 0, terms.Width(one), word)) continue;
    if (std::ranges::count_if(word, [](uint32_t input) { return input != kNone; }) < 2) continue;
    AddConstant(std::move(word), terms.Value(constant));
  }
}

/// That a word of bits is equal to a constant is a conjunction of its bits and their opposites, and of what stands
/// beside it in the program: what of it is of inputs beside each other is a word.
void WideInputs::AddConjunctions(const terms::Terms& terms, const Reader& reader, std::span<const terms::TermId> cone) {
  const auto& [relation, numbers] = reader;
  const auto is_and = [&terms](terms::TermId id) {
    return terms[id].kind == terms::TermKind::kAnd && terms[id].width == 1;
  };
  // Of each conjunction the whole: those that something else reads, or nothing.
  std::vector<bool> is_part(terms.size()), is_whole(terms.size());
  for (const terms::TermId id : cone) {
    terms.ForEachOperand(terms[id],
                         [&](terms::TermId operand) { (is_and(id) ? is_part : is_whole)[operand.index] = true; });
  }
  std::vector<uint32_t> visit_of(terms.size());
  uint32_t visit = 0;
  for (const terms::TermId id : cone) {
    if (!is_and(id) || (is_part[id.index] && !is_whole[id.index])) continue;
    ++visit;
    std::map<uint32_t, bool> values;  // by number of the input
    std::vector<terms::TermId> open{id};
    const auto add = [&](terms::TermId operand) { open.push_back(operand); };
    while (!open.empty()) {
      const terms::TermId at = open.back();
      open.pop_back();
      if (visit_of[at.index] == visit) continue;
      visit_of[at.index] = visit;
      if (is_and(at)) {
        terms.ForEachOperand(terms[at], add);
        continue;
      }
      const bool is_not = terms[at].kind == terms::TermKind::kNot;
      const terms::TermId bit = is_not ? terms::TermId(terms[at].a) : at;
      if (terms[bit].kind != terms::TermKind::kVariable || terms[bit].width != 1) continue;
      const execute::CellId cell = relation.CellOf(bit);
      const auto number = cell.valid() ? numbers.find(cell.index) : numbers.end();
      if (number != numbers.end()) values[number->second] = !is_not;
    }
    Word word;
    uint64_t constant = 0;
    const auto end_word = [&] {
      if (word.size() >= kLeastBits) AddConstant(word, constant);
      word.clear();
      constant = 0;
    };
    for (const auto& [number, value] : values) {
      const bool is_beside = !word.empty() && inputs_[word.back()].cell.index + 1 == inputs_[number].cell.index;
      if (!is_beside || word.size() == kMostBits) end_word();
      constant |= uint64_t{value} << word.size();
      word.push_back(number);
    }
    end_word();
  }
}

void WideInputs::AddConstant(Word word, uint64_t constant) {
  std::vector<uint64_t>& constants = words_[std::move(word)];
  if (std::ranges::find(constants, constant) == constants.end()) constants.push_back(constant);
}

/// One bit in 2^power is 1.
uint64_t WideInputs::Sparse(uint32_t one_in_power) {
  uint64_t bits = ~uint64_t{0};
  for (uint32_t i = 0; i < one_in_power && bits != 0; ++i) bits &= random_.Next();
  return bits;
}

/// So many eighths of the bits are 1.
uint64_t WideInputs::Ones(uint32_t eighths) {
  uint64_t bits = 0;
  for (uint32_t i = 0; i < 3; ++i) bits = (eighths >> i & 1) != 0 ? bits | random_.Next() : bits & random_.Next();
  return bits;
}

void WideInputs::ChangeHabits(uint32_t word) {
  // One run of the numbers' generator has long rows of alike low bits: the high ones are taken.
  const auto any = [this](uint64_t below) { return static_cast<uint32_t>((random_.Next() >> 20) % below); };
  constexpr std::array<uint32_t, 8> kEvery = {1, 1, 1, 2, 3, 6, 16, 64};
  habits_[word] = {.eighths = 1 + any(7), .change = 2 + any(7), .every = kEvery[any(8)], .memory = any(2) == 0};
}

void WideInputs::Begin() {
  period_ = 0;
  for (uint32_t word = 0; word < kWords; ++word) ChangeHabits(word);
}

std::vector<WideSet> WideInputs::Next(bool is_first) {
  std::vector<WideSet> sets;
  ++period_;
  const auto is_due = [&](uint32_t word) { return is_first || period_ % habits_[word].every == 0; };
  for (uint32_t number = 0; number < inputs_.size(); ++number) {
    WideSet set{.input = number, .where = {}, .value = {}};
    uint64_t any = 0;
    for (uint32_t w = 0; w < kWords; ++w) {
      const Habit& habit = habits_[w];
      if (!is_due(w) || (!habit.memory && !inputs_[number].is_machines)) continue;
      set.where.words[w] = is_first ? ~uint64_t{0} : Sparse(habit.change);
      if (set.where.words[w] != 0) set.value.words[w] = Ones(habit.eighths);
      any |= set.where.words[w];
    }
    if (any != 0) sets.push_back(set);
  }
  for (const auto& [word, constants] : words_) {
    constexpr uint32_t kAtOnce = 3;  // values that different lanes get
    for (uint32_t i = 0; i < (is_first ? kAtOnce : 1); ++i) {
      const uint64_t next = random_.Next();
      const uint64_t value = constants[(next >> 20) % constants.size()] + (next >> 50 & 3) % 3 - 1;
      terms::Plane where;
      uint64_t any = 0;
      for (uint32_t w = 0; w < kWords; ++w) {
        if (!is_due(w)) continue;
        where.words[w] = Sparse(is_first ? 1 : habits_[w].change);
        any |= where.words[w];
      }
      if (any == 0) continue;
      for (size_t bit = 0; bit < word.size(); ++bit) {
        if (word[bit] == kNone) continue;
        WideSet set{.input = word[bit], .where = where, .value = {}};
        set.value.Fill((value >> bit & 1) != 0);
        sets.push_back(set);
      }
    }
  }
  return sets;
}

}  // namespace plcxx::prove::wide
