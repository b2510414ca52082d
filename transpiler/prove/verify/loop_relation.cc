#include "transpiler/prove/verify/loop_relation.h"

#include <algorithm>
#include <utility>

#include "transpiler/symbolic/terms/gather.h"
#include "transpiler/symbolic/terms/samples.h"

namespace plcxx::prove::verify {
namespace {

constexpr uint32_t kSamples = 48;
constexpr size_t kMostGuessedWords = 64;  // of one loop; tables are any values
constexpr size_t kMostOthers = 12;        // words of a loop that later ones are guessed by

/// The samples of several heads as rows: those in which execution comes there.
class HeadSamples {
 public:
  /// By head: when it is reached, then its values; of all heads as many. The first one is the entry.
  HeadSamples(const terms::Terms& terms, std::span<const std::vector<terms::TermId>> heads) {
    std::vector<terms::TermId> roots;
    for (const std::vector<terms::TermId>& head : heads) roots.insert(roots.end(), head.begin(), head.end());
    const size_t row = heads.front().size();
    for (size_t i = 1; i < row; ++i) columns_.push_back({.width = terms.Width(heads.front()[i]), .values = {}});
    for (const std::vector<uint64_t>& values : terms::SampleValues(terms, roots, kSamples)) {
      const auto entry = static_cast<uint32_t>(entries_.size());
      for (size_t head = 0; head < heads.size() && values[head * row] != 0; ++head) {
        entries_.push_back(entry);
        for (size_t i = 1; i < row; ++i) columns_[i - 1].values.push_back(values[head * row + i]);
      }
    }
  }

  const SampledValue& operator[](size_t column) const { return columns_[column]; }
  const std::vector<uint32_t>& entries() const { return entries_; }

 private:
  std::vector<SampledValue> columns_;
  std::vector<uint32_t> entries_;
};

std::string LoopName(size_t number) { return "loop " + std::to_string(number + 1); }

}  // namespace

LoopRelation::LoopRelation(terms::Terms& terms, const emit::Emittable& emittable, const execute::Cells& cells,
                           const StateImage& image, std::function<terms::TermId(execute::CellId)> initial,
                           const DroppedGuesses& dropped)
    : terms_(terms),
      emittable_(emittable),
      program_(*emittable.program),
      cells_(cells),
      image_(image),
      initial_(std::move(initial)),
      dropped_(dropped),
      given_(terms.Bit(true)),
      given_in_code_(terms.Bit(true)) {}

uint32_t LoopRelation::Dropped(const std::string& key) const {
  const auto at = dropped_.find(key);
  return at == dropped_.end() ? 0 : at->second;
}

void LoopRelation::Claim(const OfProgram& loop, std::string what, std::string guess, Blame blame, terms::TermId given,
                         terms::TermId a, terms::TermId b) {
  if (a == b) return;
  claims_.push_back({.loop = loop.known.loop,
                     .what = std::move(what),
                     .guess = std::move(guess),
                     .blame = blame,
                     .given = given,
                     .pair = {a, b}});
}

void LoopRelation::AddWord(OfProgram& loop, std::string name, std::vector<size_t> cells) {
  Word word{.name = std::move(name), .width = 0, .cells = std::move(cells)};
  for (const size_t cell : word.cells) {
    loop.places[cell] = {static_cast<uint32_t>(loop.words.size()), word.width};
    const uint8_t width = execute::CellWidth(program_, execute::CellAt(program_, cells_, loop.known.cells[cell]));
    word.width = static_cast<uint8_t>(word.width + width);
  }
  loop.words.push_back(std::move(word));
}

/// As the program names them, the widest first; then bytes, bits and fields.
void LoopRelation::MakeWords(OfProgram& loop) {
  constexpr uint32_t kNoWord = 0xFFFFFFFF;
  loop.places.assign(loop.known.cells.size(), {kNoWord, 0});
  const auto indices = [&](const std::vector<execute::CellId>& cells) {
    std::vector<size_t> found;
    for (const execute::CellId cell : cells) {
      const auto at = std::ranges::lower_bound(loop.known.cells, cell);
      if (at == loop.known.cells.end() || *at != cell) return std::vector<size_t>();
      found.push_back(static_cast<size_t>(at - loop.known.cells.begin()));
      if (loop.places[found.back()].first != kNoWord) return std::vector<size_t>();
    }
    return found;
  };
  for (const uint32_t bytes : {8U, 4U, 2U, 1U}) {
    for (uint32_t i = 0; i < program_.places.size(); ++i) {
      const ir::Place& place = program_.places[ir::PlaceId(i)];
      if (place.is_field() || place.indexed || place.type == ir::Type::kBit || ir::Bytes(place.type) != bytes ||
          !execute::IsInside(program_, place)) {
        continue;
      }
      std::vector<size_t> cells = indices(execute::CellsOf(program_, cells_, place));
      if (!cells.empty()) AddWord(loop, emittable_.place_names[i], std::move(cells));
    }
  }
  for (size_t i = 0; i < loop.known.cells.size(); ++i) {
    if (loop.places[i].first != kNoWord) continue;
    const execute::CellId first = loop.known.cells[i];
    const execute::Cell cell = execute::CellAt(program_, cells_, first);
    std::vector<size_t> whole;
    if (cell.kind == execute::CellKind::kBit && cell.bit == 0) {
      std::vector<execute::CellId> byte;
      for (uint32_t bit = 0; bit < 8; ++bit) byte.emplace_back(first.index + bit);
      whole = indices(byte);
    }
    if (whole.empty()) whole = {i};
    AddWord(loop, execute::CellName(program_, cell), std::move(whole));
  }
}

terms::TermId LoopRelation::LaterAt(const OfProgram& loop, const execute::ProgramLoop::Head& head) {
  if (terms_.IsConst(head.round)) return terms_.Bit(!terms_.IsZero(head.round));
  return head.round == loop.head.round ? loop.later : terms_.Bit(true);
}

std::vector<terms::TermId> LoopRelation::WordsAt(const OfProgram& loop, const execute::ProgramLoop::Head& head) {
  std::vector<terms::TermId> words;
  for (const Word& word : loop.words) {
    std::vector<terms::TermId> bits;
    for (const size_t cell : word.cells) bits.push_back(head.values[cell]);
    words.push_back(terms::Gather(terms_, bits));
  }
  words.push_back(head.round);
  words.push_back(LaterAt(loop, head));
  return words;
}

Guess LoopRelation::FixedBits(const SampledValue& sampled) {
  uint64_t varies = 0;
  for (const uint64_t value : sampled.values) varies |= value ^ sampled.values.front();
  const uint8_t width = sampled.width;
  // Whole bytes: the upper bits of a number that counts up are no evidence of anything.
  uint64_t fixed = 0;
  for (uint8_t low = 0; width > 8 && low < width; low = static_cast<uint8_t>(low + 8)) {
    if ((varies >> low & 0xFF) == 0) fixed |= uint64_t{0xFF} << low;
  }
  fixed = sampled.values.empty() ? 0 : terms::Masked(fixed, width);
  if (fixed == 0) return {};
  return [fixed, width, value = sampled.values.front() & fixed](terms::Terms& terms,
                                                                std::span<const terms::TermId> itself) {
    return terms.Or(terms.And(itself.front(), terms.Const(~fixed, width)), terms.Const(value, width));
  };
}

terms::TermId LoopRelation::Apply(const WordGuess& guess, terms::TermId word, std::span<const terms::TermId> others) {
  switch (guess.of) {
    case WordGuess::Of::kNothing:
      return word;
    case WordGuess::Of::kOthers:
      return guess.guess(terms_, others);
    case WordGuess::Of::kItself:
      return guess.guess(terms_, {&word, 1});
  }
  PLCXX_UNREACHABLE();
}

std::vector<terms::TermId> LoopRelation::OthersOf(const OfProgram& loop, std::span<const terms::TermId> words) {
  std::vector<terms::TermId> others(words.begin() + static_cast<std::ptrdiff_t>(loop.words.size()), words.end());
  for (const size_t word : loop.others) others.push_back(words[word]);
  return others;
}

void LoopRelation::GuessWords(OfProgram& loop, const std::string& prefix) {
  loop.guesses.resize(loop.words.size());
  if (loop.words.size() > kMostGuessedWords) return;
  std::vector<std::vector<terms::TermId>> heads;
  const auto add = [&](const execute::ProgramLoop::Head& head) {
    std::vector<terms::TermId>& row = heads.emplace_back();
    row.push_back(terms_.And(head.when, loop.given_before));
    for (const terms::TermId word : WordsAt(loop, head)) row.push_back(word);
  };
  add(loop.known.entry);
  for (const execute::ProgramLoop::Head& sample : loop.known.samples) add(sample);
  const HeadSamples samples(terms_, heads);
  const auto at_entry = std::make_shared<std::vector<terms::TermId>>();
  SampledLoop sampled{.words = {}, .words_at_entry = at_entry, .entries = samples.entries(), .later = 1};
  for (size_t i = loop.words.size(); i < loop.words.size() + 2; ++i) {
    sampled.words.push_back(samples[i]);
    at_entry->push_back(heads.front()[i + 1]);
  }
  for (size_t i = 0; i < loop.words.size(); ++i) {
    WordGuess& chosen = loop.guesses[i];
    chosen.key = prefix + loop.words[i].name;
    std::vector<RatedGuess> guesses = GuessesFor(samples[i], heads.front()[i + 1], sampled);
    const uint32_t dropped = Dropped(chosen.key);
    if (dropped < guesses.size()) {
      chosen.of = WordGuess::Of::kOthers;
      chosen.guess = std::move(guesses[dropped].guess);
      continue;
    }
    if (dropped == guesses.size()) {
      chosen.guess = FixedBits(samples[i]);
      chosen.of = chosen.guess ? WordGuess::Of::kItself : WordGuess::Of::kNothing;
    }
    if (loop.words[i].width == 1 || loop.others.size() == kMostOthers) continue;
    loop.others.push_back(i);
    sampled.words.push_back(samples[i]);
    at_entry->push_back(heads.front()[i + 1]);
  }
}

void LoopRelation::ClaimWords(const OfProgram& loop, const std::string& where, Blame blame, terms::TermId given,
                              const execute::ProgramLoop::Head& head) {
  const std::vector<terms::TermId> words = WordsAt(loop, head);
  const std::vector<terms::TermId> others = OthersOf(loop, words);
  for (size_t i = 0; i < loop.words.size(); ++i) {
    const WordGuess& guess = loop.guesses[i];
    if (guess.of != WordGuess::Of::kNothing)
      Claim(loop, where + loop.words[i].name, guess.key, blame, given, words[i], Apply(guess, words[i], others));
  }
}

Replacements LoopRelation::HeadAt(const OfProgram& loop, const execute::ProgramLoop::Head& head) {
  Replacements replacements = {{loop.head.round, head.round}, {loop.later, LaterAt(loop, head)}};
  const std::vector<terms::TermId> words = WordsAt(loop, head);
  for (size_t i = 0; i < loop.words.size(); ++i) {
    if (loop.any[i].valid()) replacements.emplace(loop.any[i], words[i]);
  }
  return replacements;
}

std::vector<FactCandidate> LoopRelation::FactsOf(const OfProgram& loop) {
  const Replacements entry = HeadAt(loop, loop.known.entry);
  const auto is_known = [&loop](terms::TermId variable) { return variable.index < loop.first_term; };
  const auto at_entry = [&](terms::TermId term) { return Substitute(terms_, term, entry); };
  const std::vector<terms::TermId> words = WordsAt(loop, loop.head), next = WordsAt(loop, loop.next);
  Replacements back;
  for (size_t i = 0; i < loop.words.size(); ++i) {
    if (next[i] != words[i] && terms_.Width(next[i]) > 1 && !terms_.IsConst(next[i])) back.emplace(next[i], words[i]);
  }
  std::vector<FactCandidate> facts;
  for (const terms::TermId again : {Substitute(terms_, loop.again, back), loop.again}) {
    for (FactCandidate& fact : FactsFrom(terms_, again, loop.head.round, loop.later, is_known, at_entry)) {
      if (std::ranges::find(facts, fact.always, &FactCandidate::always) == facts.end())
        facts.push_back(std::move(fact));
    }
  }
  return facts;
}

std::vector<terms::TermId> LoopRelation::FactsOnSamples(const OfProgram& loop, const std::string& prefix,
                                                        std::vector<std::string>& keys) {
  const std::vector<FactCandidate> candidates = FactsOf(loop);
  std::vector<std::vector<terms::TermId>> heads;
  const auto add = [&](const execute::ProgramLoop::Head& head) {
    const Replacements at = HeadAt(loop, head);
    std::vector<terms::TermId>& row = heads.emplace_back();
    row.push_back(terms_.And(head.when, loop.given_before));
    for (const FactCandidate& fact : candidates) row.push_back(Substitute(terms_, fact.always, at));
    for (const FactCandidate& fact : candidates) row.push_back(Substitute(terms_, fact.later, at));
  };
  add(loop.known.entry);
  for (const execute::ProgramLoop::Head& sample : loop.known.samples) add(sample);
  const HeadSamples samples(terms_, heads);
  std::vector<terms::TermId> facts;
  const auto use = [&](size_t column, terms::TermId fact, std::string key) {
    const std::vector<uint64_t>& values = samples[column].values;
    if (Dropped(key) != 0 || terms_.IsTrue(fact)) return false;
    if (std::ranges::any_of(values, [](uint64_t value) { return value == 0; })) return false;
    facts.push_back(fact);
    keys.push_back(std::move(key));
    return true;
  };
  for (size_t i = 0; i < candidates.size(); ++i) {
    const FactCandidate& fact = candidates[i];
    if (!use(i, fact.always, prefix + fact.key)) use(candidates.size() + i, fact.later, prefix + "later " + fact.key);
  }
  return facts;
}

terms::TermId LoopRelation::ClaimFacts(const OfProgram& loop, size_t number) {
  std::vector<std::string> keys;
  const std::vector<terms::TermId> facts = FactsOnSamples(loop, LoopName(number) + " fact ", keys);
  const Replacements entry = HeadAt(loop, loop.known.entry), next = HeadAt(loop, loop.next);
  const terms::TermId enters = terms_.And(loop.given_before, loop.known.entry.when);
  const terms::TermId goes_on = terms_.And(loop.given_inside, terms_.And(loop.head.when, loop.again));
  terms::TermId all = terms_.Bit(true);
  for (size_t i = 0; i < facts.size(); ++i) {
    // The key says nothing to a reader: it is a hash of the fact.
    const std::string what = LoopName(number) + ": what holds at the beginning of each round (" +
                             std::to_string(i + 1) + " of " + std::to_string(facts.size()) + ")";
    Claim(loop, what + ", at its entry", keys[i], Blame::kAtEntry, enters, Substitute(terms_, facts[i], entry),
          terms_.Bit(true));
    Claim(loop, what, keys[i], Blame::kFactOrFixed, goes_on, Substitute(terms_, facts[i], next), terms_.Bit(true));
    all = terms_.And(all, facts[i]);
  }
  return all;
}

void LoopRelation::Open() {
  const std::optional<size_t> outer = open_.empty() ? std::nullopt : std::optional(open_.back());
  open_.push_back(loops_.size());
  loops_.push_back(std::make_unique<OfProgram>());
  loops_.back()->outer = outer;
  loops_.back()->given_before = given_;
  loops_.back()->claims = claims_.size();
}

execute::ProgramLoop::Head LoopRelation::AtHead(const execute::ProgramLoop& known) {
  const size_t number = open_.back();
  loops_.resize(number + 1);
  OfProgram& loop = *loops_.back();
  loop = {.known = known,
          .outer = loop.outer,
          .given_before = loop.given_before,
          .holds = terms_.Bit(true),
          .claims = loop.claims};
  claims_.resize(loop.claims);
  given_ = loop.given_before;
  const std::string name = LoopName(number);
  MakeWords(loop);
  GuessWords(loop, name + " ");
  ClaimWords(loop, name + ", at its entry: ", Blame::kAtEntry, terms_.And(given_, known.entry.when), known.entry);
  const std::string where = " in any round of " + name;
  execute::ProgramLoop::Head& head = loop.head;
  head.when = known.entry.when;
  // Of a loop that counts none it is a number that nothing but guesses depends on.
  head.round = terms_.Variable("rounds" + where, 32);
  head.values.resize(known.cells.size());
  loop.any.resize(loop.words.size());
  loop.later = terms_.Variable("a later round" + where, 1);
  std::vector<terms::TermId> others = {head.round, loop.later};
  for (size_t i = 0; i < loop.words.size(); ++i) {
    const Word& word = loop.words[i];
    if (loop.guesses[i].of != WordGuess::Of::kOthers) loop.any[i] = terms_.Variable(word.name + where, word.width);
    const terms::TermId value = Apply(loop.guesses[i], loop.any[i], others);
    if (std::ranges::find(loop.others, i) != loop.others.end()) others.push_back(value);
    for (size_t k = 0; k < word.cells.size(); ++k)
      head.values[word.cells[k]] = word.cells.size() == 1 ? value : terms_.Extract(value, static_cast<uint8_t>(k), 1);
  }
  loop.facts = terms_.Variable("facts" + where, 1);
  loop.first_term = terms_.size();
  Holds(loop.facts);
  return head;
}

void LoopRelation::Holds(terms::TermId condition) {
  OfProgram& loop = *loops_[open_.back()];
  const terms::TermId holds = Implies(loop.head.when, condition);
  loop.holds = terms_.And(loop.holds, holds);
  given_ = terms_.And(given_, holds);
}

void LoopRelation::Assume(terms::TermId condition) {
  if (open_.empty()) {
    given_ = terms_.And(given_, condition);
  } else if (open_.back() < loops_.size() && loops_[open_.back()]->holds.valid()) {
    Holds(condition);
  }
}

void LoopRelation::Close(terms::TermId again, std::span<const terms::TermId> values) {
  const size_t number = open_.back();
  OfProgram& loop = *loops_[number];
  open_.pop_back();
  loop.again = again;
  loop.given_inside = given_;
  loop.next = {.when = loop.head.when,
               .values = std::vector<terms::TermId>(values.begin(), values.end()),
               .round = terms_.Add(loop.head.round, terms_.Const(1, 32))};
  ClaimWords(loop, LoopName(number) + ": ", Blame::kWord, terms_.And(given_, terms_.And(loop.head.when, again)),
             loop.next);
  const Replacements facts = {{loop.facts, ClaimFacts(loop, number)}};
  const auto say = [&](terms::TermId& given) { given = Substitute(terms_, given, facts); };
  say(given_);
  for (size_t i = number; i < loops_.size(); ++i) {
    say(loops_[i]->holds);
    say(loops_[i]->given_inside);
    if (i != number) say(loops_[i]->given_before);
  }
  for (size_t i = loop.claims; i < claims_.size(); ++i) say(claims_[i].given);
  for (terms::TermId& noted : noted_) say(noted);
  given_ = terms_.And(given_, Implies(loop.head.when, terms_.Not(again)));
}

std::string LoopRelation::NameOf(const CodeLoop::Item& item) const {
  if (!item.name.empty()) return std::string(item.name);
  if (item.slot < image_.size()) return image_.NameOf(item.slot);
  const uint32_t further = item.slot - image_.size();
  if (further < cells_.CallCells())
    return execute::CellName(program_, execute::CellAt(program_, cells_, execute::CellId(cells_.calls + further)));
  return "local " + std::to_string(item.slot);
}

Guess LoopRelation::OwnCells(const OfProgram& loop, uint32_t slot) {
  const auto place_of = [&loop](execute::CellId cell) -> const std::pair<uint32_t, uint8_t>* {
    const auto at = std::ranges::lower_bound(loop.known.cells, cell);
    if (at == loop.known.cells.end() || *at != cell) return nullptr;
    return &loop.places[static_cast<size_t>(at - loop.known.cells.begin())];
  };
  const auto value_of = [this, &loop, place_of](execute::CellId cell, std::span<const terms::TermId> words) {
    const auto* place = place_of(cell);
    if (place == nullptr) {
      const terms::TermId outside = loop.known.memory[cell.index];
      return outside.valid() ? outside : initial_(cell);
    }
    const terms::TermId word = words[place->first];
    return loop.words[place->first].cells.size() == 1 ? word : terms_.Extract(word, place->second, 1);
  };
  if (slot >= image_.size()) {
    const uint32_t further = slot - image_.size();
    if (further >= cells_.CallCells()) return {};
    const execute::CellId calls(cells_.calls + further);
    if (place_of(calls) == nullptr) return {};
    return [value_of, calls](terms::Terms&, std::span<const terms::TermId> words) { return value_of(calls, words); };
  }
  const StateByte& byte = image_[slot];
  if (byte.kind != ByteKind::kBits && byte.kind != ByteKind::kCell) return {};
  bool any = false;
  for (uint32_t i = 0; i < (byte.kind == ByteKind::kBits ? 8U : 1U); ++i)
    any = any || place_of(execute::CellId(byte.cell.index + i)) != nullptr;
  if (!any) return {};
  return [this, value_of, slot](terms::Terms& terms, std::span<const terms::TermId> words) {
    return image_.ByteFor(terms, slot, [&](execute::CellId cell) { return value_of(cell, words); }, terms.Const(0, 32));
  };
}

void LoopRelation::Choose(const OfProgram& loop, const CodeLoop& code, OfCode& open) {
  std::vector<std::vector<terms::TermId>> heads;
  const auto add = [&](const execute::ProgramLoop::Head& program, const CodeLoop::Head& compiled) {
    std::vector<terms::TermId>& row = heads.emplace_back();
    row.push_back(terms_.And(terms_.And(program.when, compiled.when), terms_.And(loop.given_before, given_in_code_)));
    for (const terms::TermId word : WordsAt(loop, program)) row.push_back(word);
    row.insert(row.end(), compiled.values.begin(), compiled.values.end());
  };
  add(loop.known.entry, code.entry);
  for (size_t i = 0; i < std::min(loop.known.samples.size(), code.samples.size()); ++i)
    add(loop.known.samples[i], code.samples[i]);
  const HeadSamples samples(terms_, heads);
  const std::vector<terms::TermId> words = WordsAt(loop, loop.known.entry);
  SampledLoop sampled{.words = {},
                      .words_at_entry = std::make_shared<const std::vector<terms::TermId>>(words),
                      .entries = samples.entries()};
  for (size_t i = 0; i < words.size(); ++i) sampled.words.push_back(samples[i]);
  sampled.later = words.size() - 1;
  open.guesses.assign(code.items.size(), Guess());
  open.blames.assign(code.items.size(), Blame::kMemory);
  for (size_t i = 0; i < code.items.size(); ++i) {
    uint32_t dropped = Dropped(open.keys[i]);
    if (code.items[i].name.empty()) {
      Guess own = OwnCells(loop, code.items[i].slot);
      if (own && dropped == 0) {
        open.guesses[i] = std::move(own);
        continue;
      }
      dropped -= own ? 1 : 0;
    }
    std::vector<RatedGuess> guesses = GuessesFor(samples[words.size() + i], code.entry.values[i], sampled);
    if (dropped >= guesses.size()) continue;
    open.guesses[i] = std::move(guesses[dropped].guess);
    open.blames[i] = guesses[dropped].is_fixed ? Blame::kFactOrFixed : Blame::kValue;
  }
}

void LoopRelation::OpenInCode() {
  open_in_code_.push_back({.number = next_in_code_++, .given_before = given_in_code_, .claims = claims_.size()});
}

std::vector<terms::TermId> LoopRelation::AtHeadInCode(const CodeLoop& code) {
  OfCode& open = open_in_code_.back();
  if (open.number >= loops_.size()) return {};
  const OfProgram& loop = *loops_[open.number];
  const size_t depth = open_in_code_.size();
  if (loop.outer != (depth < 2 ? std::nullopt : std::optional(open_in_code_[depth - 2].number))) return {};
  claims_.resize(open.claims);
  given_in_code_ = open.given_before;
  next_in_code_ = open.number + 1;
  open.name = LoopName(open.number) + " (" + std::string(code.name) + ")";
  open.when = code.entry.when;
  open.items.clear();
  open.keys.clear();
  for (const CodeLoop::Item& item : code.items) {
    open.items.push_back(NameOf(item));
    const std::string place =
        item.name.empty() ? " slot " + std::to_string(item.slot) : " value " + std::to_string(open.keys.size());
    open.keys.push_back(std::string(kGuessOfCode) + LoopName(open.number) + place);
  }
  Choose(loop, code, open);
  const terms::TermId given = terms_.And(terms_.And(open.given_before, loop.given_before), open.when);
  Claim(loop, open.name + ": is reached", "", {}, given, loop.head.when, terms_.Bit(true));
  const std::vector<terms::TermId> before = WordsAt(loop, loop.known.entry), inside = WordsAt(loop, loop.head);
  std::vector<terms::TermId> values;
  for (size_t i = 0; i < code.items.size(); ++i) {
    const terms::TermId entry = code.entry.values[i];
    if (!open.guesses[i]) {
      values.push_back(terms_.Variable(open.items[i] + " in any round of the code of " + LoopName(open.number),
                                       terms_.Width(entry)));
      continue;
    }
    Claim(loop, open.name + ", at its entry: " + open.items[i], open.keys[i], Blame::kAtEntry, given,
          open.guesses[i](terms_, before), entry);
    values.push_back(open.guesses[i](terms_, inside));
  }
  given_in_code_ = terms_.And(given_in_code_, loop.holds);
  return values;
}

void LoopRelation::CloseInCode(terms::TermId again, std::span<const terms::TermId> values) {
  const OfCode open = std::move(open_in_code_.back());
  open_in_code_.pop_back();
  const OfProgram& loop = *loops_[open.number];
  const terms::TermId reached = terms_.And(open.when, loop.head.when);
  const terms::TermId given = terms_.And(terms_.And(given_in_code_, loop.given_inside), reached);
  Claim(loop, open.name + ": whether it goes round again", "", {}, given, loop.again, again);
  const terms::TermId goes_on = terms_.And(given, loop.again);
  const std::vector<terms::TermId> next = WordsAt(loop, loop.next);
  for (size_t i = 0; i < values.size(); ++i) {
    if (open.guesses[i])
      Claim(loop, open.name + ": " + open.items[i], open.keys[i], open.blames[i], goes_on,
            open.guesses[i](terms_, next), values[i]);
  }
  const terms::TermId ended =
      terms_.And(Implies(open.when, terms_.Not(again)), Implies(loop.head.when, terms_.Not(loop.again)));
  given_in_code_ = terms_.And(given_in_code_, ended);
}

}  // namespace plcxx::prove::verify
