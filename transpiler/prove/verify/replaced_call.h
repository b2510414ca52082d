// A call of a function that has been proved, as one unknown function of what it may read: the same on the IR's cells
// and on the code's bytes, so that callers are compared without looking into it again.
//
// Where a call of the code is one of the program's, it gives the same unknown, and it remains to be shown that it is
// called alike; else what a call gives is a function of all its arguments. In: a unit. Out: what
// it changes, on either side. Bits that have a byte of their own must be 0 or 1 in the code's State when it is called,
// for that was assumed when it was proved. Not its job: whether the unit is proved.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/state_image.h"
#include "transpiler/prove/verify/units.h"

namespace plcxx::prove::verify {

/// "m", the locals, "host": the names of a unit's parameters in C++, in this order; the locals alone where State and
/// host are not passed.
std::vector<std::string> ParametersOf(const emit::Emittable& emittable, const Unit& unit, Passes passes);

class ReplacedCall;

/// The replaced calls of one routine, first those of the IR, then those of the code.
///
/// By order, the code's calls of a function are the program's in their order, but for what compilers make of branches:
/// two calls for one where one branch became two, one for two where they end alike, and branches in another order.
/// Whichever is taken, it is shown that the arguments are the same.
class CallLog {
 public:
  enum class Matching : uint8_t { kByOrder, kByArguments };

  /// `never`: whether a condition is soon found to hold never; asked where a function is called more than once.
  CallLog(terms::Terms& terms, Matching matching, std::function<bool(terms::TermId condition)> never)
      : terms_(terms), matching_(matching), never_(std::move(never)) {}

  /// What stands for a call: 64 bits.
  terms::TermId CalledByProgram(const ReplacedCall& call, std::vector<terms::TermId> arguments, terms::TermId when);
  /// None: the program makes no such call.
  terms::TermId CalledByCode(const ReplacedCall& call, std::vector<terms::TermId> arguments, terms::TermId when);

  /// What has to be equal so that calls give the same.
  struct Claim {
    const ReplacedCall* call = nullptr;
    terms::TermId program, code;
  };
  const std::vector<Claim>& claims() const { return claims_; }

 private:
  struct Entry {
    const ReplacedCall* call = nullptr;
    std::vector<terms::TermId> arguments;
    terms::TermId known, when;
    std::vector<terms::TermId> taken;  // when the code makes calls that are this one
  };

  terms::TermId ByArguments(const ReplacedCall& call, std::span<const terms::TermId> arguments);
  /// The program's call that one of the code's is, or several, of which it is the first that the program comes to;
  /// none: there are no more.
  std::vector<Entry*> EntriesOf(const ReplacedCall& call, terms::TermId when);

  terms::Terms& terms_;
  Matching matching_;
  std::function<bool(terms::TermId condition)> never_;
  std::vector<Entry> entries_;
  std::vector<Claim> claims_;
};

class ReplacedCall {
 public:
  /// `parameters`: what the compiled function has left of its parameters; a local that it does not get does not matter.
  /// `result`: what the code takes for granted of its result, which its own proof has shown.
  ReplacedCall(const emit::Emittable& emittable, const execute::Cells& cells, const StateImage& image, const Unit& unit,
               Passes passes, const std::vector<std::string>& parameters, std::optional<NumberRange> result);

  const Unit& unit() const { return unit_; }
  /// Whether there is anything in it that has no place in State: then calls of it have to be followed.
  bool is_opaque() const { return opaque_; }

  std::vector<execute::CellChange> OnCells(execute::Memory& memory, terms::TermId hash, terms::TermId when,
                                           CallLog& log) const;
  /// The result, if it has one. A reason in `refusal` when the call does not fit the function's declaration.
  terms::TermId OnCode(terms::Terms& terms, CodeMemory& memory, const HostRequest& request, CallLog& log,
                       std::string& refusal) const;

 private:
  enum class Kind : uint8_t { kByte, kField, kCalls, kLayout, kValue, kReference };
  /// One of the things that it may read, and perhaps write.
  struct Item {
    Kind kind{};
    uint32_t offset = 0;   // kByte, kField: in State; kLayout: of the retentive block
    execute::CellId cell;  // kByte: the first of eight; kField, kCalls
    ir::PlaceId place;     // kValue, kReference
    uint8_t width = 8;
    bool written = false;
    bool read = true;  // what it does depends on what it finds there
    std::string name;  // for the function that gives what is written
  };
  /// Where the arguments of one call are.
  struct Bound {
    std::vector<terms::TermId> values;  // by item, of kValue and of references whose value was passed
    std::vector<uint32_t> slots;        // by item, of kReference
  };

  void AddItems(Passes passes);
  /// None: it is called otherwise than it was proved, with State and host, and references to whole objects apart.
  std::optional<Bound> Bind(const HostRequest& request) const;
  bool AreApart(const Bound& bound) const;
  terms::TermId ReadCode(terms::Terms& terms, CodeMemory& memory, const Item& item, uint32_t slot) const;
  terms::TermId CheckedBit(terms::Terms& terms, CodeMemory& memory, terms::TermId byte) const;
  /// What a call leaves: where `found` is valid, that may be what stood there.
  terms::TermId After(terms::Terms& terms, terms::TermId known, terms::TermId found, const std::string& name,
                      uint8_t width) const;
  terms::TermId AfterIn(const Item& item, terms::Terms& terms, terms::TermId known, terms::TermId found) const {
    return After(terms, known, item.read ? terms::TermId() : found, item.name, item.width);
  }
  /// Of what is there before a call, by item: what it depends on.
  std::vector<terms::TermId> ArgumentsAmong(std::span<const terms::TermId> found) const;
  terms::TermId ResultAfter(terms::Terms& terms, terms::TermId known) const;

  const ir::Program& program_;
  const execute::Cells& cells_;
  const StateImage& image_;
  const Unit& unit_;
  std::vector<std::string> parameters_;  // as the source declares them
  Passes passes_;
  std::optional<NumberRange> result_;
  std::vector<Item> items_;
  bool opaque_ = false;
};

}  // namespace plcxx::prove::verify
