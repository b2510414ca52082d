#include "transpiler/prove/compiled/loop_relation.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/terms/gather.h"
#include "transpiler/prove/terms/samples.h"

namespace plcxx::prove {
namespace {

constexpr uint32_t kSamples = 48;
constexpr size_t kMostGuessedWords = 64;  // of one loop; tables are any values

/// The samples of several heads as rows: those in which execution comes there.
class HeadSamples {
 public:
  /// By head: when it is reached, then its values; of all heads as many. The first one is the entry.
  HeadSamples(const Terms& terms, std::span<const std::vector<TermId>> heads) {
    std::vector<TermId> roots;
    for (const std::vector<TermId>& head : heads) roots.insert(roots.end(), head.begin(), head.end());
    const size_t row = heads.front().size();
    for (size_t i = 1; i < row; ++i) columns_.push_back({.width = terms.Width(heads.front()[i]), .values = {}});
    for (const std::vector<uint64_t>& values : SampleValues(terms, roots, kSamples)) {
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

LoopRelation::LoopRelation(Terms& terms, const emit::Emittable& emittable, const Cells& cells, const StateImage& image,
                           std::function<TermId(CellId)> initial, const DroppedGuesses& dropped)
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

void LoopRelation::Claim(std::string what, std::string guess, TermId given, TermId a, TermId b) {
  if (a != b) claims_.push_back({.what = std::move(what), .guess = std::move(guess), .given = given, .pair = {a, b}});
}

void LoopRelation::AddWord(OfProgram& loop, std::string name, std::vector<size_t> cells) {
  Word word{.name = std::move(name), .width = 0, .cells = std::move(cells)};
  for (const size_t cell : word.cells) {
    loop.places[cell] = {static_cast<uint32_t>(loop.words.size()), word.width};
    const uint8_t width = CellWidth(program_, CellAt(program_, cells_, loop.known.cells[cell]));
    word.width = static_cast<uint8_t>(word.width + width);
  }
  loop.words.push_back(std::move(word));
}

/// As the program names them, the widest first; then bytes, bits and fields.
void LoopRelation::MakeWords(OfProgram& loop) {
  constexpr uint32_t kNoWord = 0xFFFFFFFF;
  loop.places.assign(loop.known.cells.size(), {kNoWord, 0});
  const auto indices = [&](const std::vector<CellId>& cells) {
    std::vector<size_t> found;
    for (const CellId cell : cells) {
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
          !IsInside(program_, place)) {
        continue;
      }
      std::vector<size_t> cells = indices(CellsOf(program_, cells_, place));
      if (!cells.empty()) AddWord(loop, emittable_.place_names[i], std::move(cells));
    }
  }
  for (size_t i = 0; i < loop.known.cells.size(); ++i) {
    if (loop.places[i].first != kNoWord) continue;
    const CellId first = loop.known.cells[i];
    const Cell cell = CellAt(program_, cells_, first);
    std::vector<size_t> whole;
    if (cell.kind == CellKind::kBit && cell.bit == 0) {
      std::vector<CellId> byte;
      for (uint32_t bit = 0; bit < 8; ++bit) byte.emplace_back(first.index + bit);
      whole = indices(byte);
    }
    if (whole.empty()) whole = {i};
    AddWord(loop, CellName(program_, cell), std::move(whole));
  }
}

std::vector<TermId> LoopRelation::WordsAt(const OfProgram& loop, const ProgramLoop::Head& head) {
  std::vector<TermId> words;
  for (const Word& word : loop.words) {
    std::vector<TermId> bits;
    for (const size_t cell : word.cells) bits.push_back(head.values[cell]);
    words.push_back(Gather(terms_, bits));
  }
  if (loop.known.bound != 0) words.push_back(head.round);
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
  fixed = sampled.values.empty() ? 0 : Masked(fixed, width);
  if (fixed == 0) return {};
  return [fixed, width, value = sampled.values.front() & fixed](Terms& terms, std::span<const TermId> itself) {
    return terms.Or(terms.And(itself.front(), terms.Const(~fixed, width)), terms.Const(value, width));
  };
}

TermId LoopRelation::Apply(const WordGuess& guess, TermId word, TermId round) {
  switch (guess.of) {
    case WordGuess::Of::kNothing:
      return word;
    case WordGuess::Of::kRounds:
      return guess.guess(terms_, {&round, 1});
    case WordGuess::Of::kItself:
      return guess.guess(terms_, {&word, 1});
  }
  PLCXX_UNREACHABLE();
}

void LoopRelation::GuessWords(OfProgram& loop, const std::string& prefix) {
  loop.guesses.resize(loop.words.size());
  if (loop.words.size() > kMostGuessedWords) return;
  std::vector<std::vector<TermId>> heads;
  const auto add = [&](const ProgramLoop::Head& head) {
    std::vector<TermId>& row = heads.emplace_back();
    row.push_back(terms_.And(head.when, loop.given_before));
    for (const TermId word : WordsAt(loop, head)) row.push_back(word);
  };
  add(loop.known.entry);
  for (const ProgramLoop::Head& sample : loop.known.samples) add(sample);
  const HeadSamples samples(terms_, heads);
  SampledLoop rounds{.words = {}, .words_at_entry = {}, .entries = samples.entries()};
  if (loop.known.bound != 0) {
    rounds.words.push_back(samples[loop.words.size()]);
    rounds.words_at_entry = std::make_shared<const std::vector<TermId>>(1, loop.known.entry.round);
  }
  for (size_t i = 0; i < loop.words.size(); ++i) {
    WordGuess& chosen = loop.guesses[i];
    chosen.key = prefix + loop.words[i].name;
    std::vector<Guess> guesses = GuessesFor(samples[i], heads.front()[i + 1], rounds);
    const uint32_t dropped = Dropped(chosen.key);
    if (dropped < guesses.size()) {
      chosen.of = WordGuess::Of::kRounds;
      chosen.guess = std::move(guesses[dropped]);
    } else if (dropped == guesses.size()) {
      chosen.guess = FixedBits(samples[i]);
      chosen.of = chosen.guess ? WordGuess::Of::kItself : WordGuess::Of::kNothing;
    }
  }
}

void LoopRelation::ClaimWords(const OfProgram& loop, const std::string& where, TermId given,
                              const ProgramLoop::Head& head) {
  const std::vector<TermId> words = WordsAt(loop, head);
  for (size_t i = 0; i < loop.words.size(); ++i) {
    const WordGuess& guess = loop.guesses[i];
    if (guess.of != WordGuess::Of::kNothing)
      Claim(where + loop.words[i].name, guess.key, given, words[i], Apply(guess, words[i], head.round));
  }
}

void LoopRelation::Open() {
  open_.push_back(loops_.size());
  loops_.push_back(std::make_unique<OfProgram>());
  loops_.back()->given_before = given_;
  loops_.back()->claims = claims_.size();
}

ProgramLoop::Head LoopRelation::AtHead(const ProgramLoop& known) {
  const size_t number = open_.back();
  loops_.resize(number + 1);
  OfProgram& loop = *loops_.back();
  loop = {.known = known, .given_before = loop.given_before, .holds = terms_.Bit(true), .claims = loop.claims};
  claims_.resize(loop.claims);
  given_ = loop.given_before;
  const std::string name = LoopName(number);
  MakeWords(loop);
  GuessWords(loop, name + " ");
  ClaimWords(loop, name + ", at its entry: ", terms_.And(given_, known.entry.when), known.entry);
  const std::string where = " in any round of " + name;
  ProgramLoop::Head& head = loop.head;
  head.when = known.entry.when;
  head.round = known.bound != 0 ? terms_.Variable("rounds" + where, 32) : terms_.Const(0, 32);
  head.values.resize(known.cells.size());
  for (size_t i = 0; i < loop.words.size(); ++i) {
    const Word& word = loop.words[i];
    const bool free = loop.guesses[i].of != WordGuess::Of::kRounds;
    const TermId any = free ? terms_.Variable(word.name + where, word.width) : TermId();
    const TermId value = Apply(loop.guesses[i], any, head.round);
    for (size_t k = 0; k < word.cells.size(); ++k)
      head.values[word.cells[k]] = word.cells.size() == 1 ? value : terms_.Extract(value, static_cast<uint8_t>(k), 1);
  }
  return head;
}

void LoopRelation::Holds(TermId condition) {
  OfProgram& loop = *loops_[open_.back()];
  const TermId holds = Implies(loop.head.when, condition);
  loop.holds = terms_.And(loop.holds, holds);
  given_ = terms_.And(given_, holds);
}

void LoopRelation::Close(TermId again, std::span<const TermId> values) {
  const size_t number = open_.back();
  OfProgram& loop = *loops_[number];
  open_.pop_back();
  loop.again = again;
  loop.given_inside = given_;
  loop.next = {.when = loop.head.when,
               .values = std::vector<TermId>(values.begin(), values.end()),
               .round = terms_.Add(loop.head.round, terms_.Const(1, 32))};
  ClaimWords(loop, LoopName(number) + ": ", terms_.And(given_, terms_.And(loop.head.when, again)), loop.next);
  given_ = terms_.And(given_, Implies(loop.head.when, terms_.Not(again)));
}

std::string LoopRelation::NameOf(const CodeLoop::Item& item) const {
  if (!item.name.empty()) return std::string(item.name);
  if (item.slot < image_.size()) return image_.NameOf(item.slot);
  const uint32_t further = item.slot - image_.size();
  if (further < program_.host_functions.size())
    return CellName(program_, CellAt(program_, cells_, cells_.OfCalls(ir::HostFunctionId(further))));
  return "local " + std::to_string(item.slot);
}

Guess LoopRelation::OwnCells(const OfProgram& loop, uint32_t slot) {
  const auto place_of = [&loop](CellId cell) -> const std::pair<uint32_t, uint8_t>* {
    const auto at = std::ranges::lower_bound(loop.known.cells, cell);
    if (at == loop.known.cells.end() || *at != cell) return nullptr;
    return &loop.places[static_cast<size_t>(at - loop.known.cells.begin())];
  };
  const auto value_of = [this, &loop, place_of](CellId cell, std::span<const TermId> words) {
    const auto* place = place_of(cell);
    if (place == nullptr) {
      const TermId outside = loop.known.memory[cell.index];
      return outside.valid() ? outside : initial_(cell);
    }
    const TermId word = words[place->first];
    return loop.words[place->first].cells.size() == 1 ? word : terms_.Extract(word, place->second, 1);
  };
  if (slot >= image_.size()) {
    const uint32_t further = slot - image_.size();
    if (further >= program_.host_functions.size()) return {};
    const CellId calls = cells_.OfCalls(ir::HostFunctionId(further));
    if (place_of(calls) == nullptr) return {};
    return [value_of, calls](Terms&, std::span<const TermId> words) { return value_of(calls, words); };
  }
  const StateByte& byte = image_[slot];
  if (byte.kind != ByteKind::kBits && byte.kind != ByteKind::kCell) return {};
  bool any = false;
  for (uint32_t i = 0; i < (byte.kind == ByteKind::kBits ? 8U : 1U); ++i)
    any = any || place_of(CellId(byte.cell.index + i)) != nullptr;
  if (!any) return {};
  return [this, value_of, slot](Terms& terms, std::span<const TermId> words) {
    return image_.ByteFor(terms, slot, [&](CellId cell) { return value_of(cell, words); }, terms.Const(0, 32));
  };
}

std::vector<Guess> LoopRelation::Choose(const OfProgram& loop, const CodeLoop& code, std::vector<std::string>& keys) {
  std::vector<std::vector<TermId>> heads;
  const auto add = [&](const ProgramLoop::Head& program, const CodeLoop::Head& compiled) {
    std::vector<TermId>& row = heads.emplace_back();
    row.push_back(terms_.And(terms_.And(program.when, compiled.when), terms_.And(loop.given_before, given_in_code_)));
    for (const TermId word : WordsAt(loop, program)) row.push_back(word);
    row.insert(row.end(), compiled.values.begin(), compiled.values.end());
  };
  add(loop.known.entry, code.entry);
  for (size_t i = 0; i < std::min(loop.known.samples.size(), code.samples.size()); ++i)
    add(loop.known.samples[i], code.samples[i]);
  const HeadSamples samples(terms_, heads);
  const std::vector<TermId> words = WordsAt(loop, loop.known.entry);
  SampledLoop sampled{
      .words = {}, .words_at_entry = std::make_shared<const std::vector<TermId>>(words), .entries = samples.entries()};
  for (size_t i = 0; i < words.size(); ++i) sampled.words.push_back(samples[i]);
  std::vector<Guess> chosen;
  for (size_t i = 0; i < code.items.size(); ++i) {
    uint32_t dropped = Dropped(keys[i]);
    if (code.items[i].name.empty()) {
      Guess own = OwnCells(loop, code.items[i].slot);
      if (own && dropped == 0) {
        chosen.push_back(std::move(own));
        continue;
      }
      dropped -= own ? 1 : 0;
    }
    std::vector<Guess> guesses = GuessesFor(samples[words.size() + i], code.entry.values[i], sampled);
    chosen.push_back(dropped < guesses.size() ? std::move(guesses[dropped]) : Guess());
  }
  return chosen;
}

void LoopRelation::OpenInCode() {
  open_in_code_.push_back({.number = next_in_code_++, .given_before = given_in_code_, .claims = claims_.size()});
}

std::vector<TermId> LoopRelation::AtHeadInCode(const CodeLoop& code) {
  OfCode& open = open_in_code_.back();
  if (open.number >= loops_.size()) return {};
  const OfProgram& loop = *loops_[open.number];
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
        item.name.empty() ? "slot " + std::to_string(item.slot) : "value " + std::to_string(open.keys.size());
    open.keys.push_back("code of " + LoopName(open.number) + " " + place);
  }
  open.guesses = Choose(loop, code, open.keys);
  const TermId given = terms_.And(terms_.And(open.given_before, loop.given_before), open.when);
  Claim(open.name + ": is reached", "", given, loop.head.when, terms_.Bit(true));
  const std::vector<TermId> before = WordsAt(loop, loop.known.entry), inside = WordsAt(loop, loop.head);
  std::vector<TermId> values;
  for (size_t i = 0; i < code.items.size(); ++i) {
    const TermId entry = code.entry.values[i];
    if (!open.guesses[i]) {
      values.push_back(terms_.Variable(open.items[i] + " in any round of the code of " + LoopName(open.number),
                                       terms_.Width(entry)));
      continue;
    }
    Claim(open.name + ", at its entry: " + open.items[i], open.keys[i], given, open.guesses[i](terms_, before), entry);
    values.push_back(open.guesses[i](terms_, inside));
  }
  given_in_code_ = terms_.And(given_in_code_, loop.holds);
  return values;
}

void LoopRelation::CloseInCode(TermId again, std::span<const TermId> values) {
  const OfCode open = std::move(open_in_code_.back());
  open_in_code_.pop_back();
  const OfProgram& loop = *loops_[open.number];
  const TermId reached = terms_.And(open.when, loop.head.when);
  const TermId given = terms_.And(terms_.And(given_in_code_, loop.given_inside), reached);
  Claim(open.name + ": whether it goes round again", "", given, loop.again, again);
  const TermId goes_on = terms_.And(given, loop.again);
  const std::vector<TermId> next = WordsAt(loop, loop.next);
  for (size_t i = 0; i < values.size(); ++i) {
    if (open.guesses[i])
      Claim(open.name + ": " + open.items[i], open.keys[i], goes_on, open.guesses[i](terms_, next), values[i]);
  }
  const TermId ended =
      terms_.And(Implies(open.when, terms_.Not(again)), Implies(loop.head.when, terms_.Not(loop.again)));
  given_in_code_ = terms_.And(given_in_code_, ended);
}

}  // namespace plcxx::prove
