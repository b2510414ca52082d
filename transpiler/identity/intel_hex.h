// Firmware images as Intel HEX: lines of text with the bytes of an address.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::identity {

/// The bytes of all data records in their order; a gap between addresses is one zero, so that nothing reaches over it.
/// Records that are cut off or have a wrong sum are left out. Empty: `text` is no Intel HEX.
std::string DecodeIntelHex(std::string_view text);

}  // namespace plcxx::identity
