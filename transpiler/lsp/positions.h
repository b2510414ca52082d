// Places of a text as the protocol counts them: lines from 0, and characters in units that client and server agree on.
//
// In: a text in UTF-8. Positions that do not exist are moved to the nearest that does: a broken client is not believed.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "transpiler/rpc/json_rpc.h"
#include "transpiler/source/source.h"

namespace plcxx::lsp {

using rpc::Json;

/// What `character` counts.
enum class Units : uint8_t { kUtf8, kUtf16, kUtf32 };
std::string_view Name(Units units);

struct Position {
  int64_t line = 0;
  int64_t character = 0;
};

/// Lines end with LF, CR LF or CR, whatever the language says.
class Lines {
 public:
  Lines(std::string_view text, Units units);

  Position At(size_t offset) const;
  size_t Offset(Position position) const;
  size_t count() const { return starts_.size(); }

 private:
  std::string_view text_;
  Units units_;
  std::vector<uint32_t> starts_;
};

/// Of a request's parameters; throws rpc::Error where it is none.
Position ReadPosition(const Json& position);
Json ToJson(Position position);

/// "file:///tmp/a%20b.plc" to "/tmp/a b.plc"; empty for other schemes.
std::string PathOfUri(std::string_view uri);
std::string UriOfPath(std::string_view path);

}  // namespace plcxx::lsp
