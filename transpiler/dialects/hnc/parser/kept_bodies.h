// What of one run of the parser the next one may take over: bodies of functions whose text has not changed, and whose
// words mean what they meant. An editor asks for a whole program after each key, and nearly all of it is as it was.
//
// A body is taken over only where the parser, reading it again, could not come to anything else: nothing was found in
// it, it declares nothing that is seen elsewhere, and nothing in it is a directive. All else is read again.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// A part of a store of a Unit.
struct Segment {
  uint32_t first = 0, count = 0;
};

enum class NeedKind : uint8_t {
  kType,           // `text`: as this body writes it; of two equal types the first one names both
  kTaggedRecord,   // the type of a record by its tag
  kTypedefRecord,  // by the name of its typedef
  kFunction,
  kFileVariable,
  kLocal  // a variable of the body's own
};

/// Something beside expressions and statements that a body refers to. Conversion adds it to the tree where the first
/// body needs it, so that taking a body over adds the same in the same order.
struct Need {
  NeedKind kind = NeedKind::kType;
  uint32_t id = 0;  // in the unit that the body is in
  std::string text{};
};

struct FunctionBody {
  source::Range inside;  // from behind the '{' to the '}'
  FunctionId function;
  bool is_reusable = false;
  bool was_taken_over = false;
  Segment expressions, statements, labels, strings, macro_uses;
  StatementId root;
  uint32_t statement_count = 0;
  std::vector<Need> needs;
  std::shared_ptr<const std::vector<std::string>> words;  // all names in its text, each once; null: they are not known
  uint64_t environment = 0;  // a digest of what the words mean there (environment.h); 0: equal to none
};

/// A body that the texts of this run do not have: between its braces is nothing but the ends of its lines.
struct ElidedBody {
  source::Range inside;  // in the files as they are now
  uint32_t body = 0;     // index into KeptBodies::bodies
};

struct KeptBodies {
  Unit* unit = nullptr;                               // of the run before; what is taken over is moved out of it
  const std::vector<FunctionBody>* bodies = nullptr;  // likewise
  std::vector<ElidedBody> elided;                     // by place
  bool is_changed_outside = false;                    // the environments of bodies may be other ones
};

}  // namespace plcxx::hnc
