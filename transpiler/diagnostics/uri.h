// A path as the URI of SARIF: RFC 3986, relative where the path is.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::diag {

std::string UriOf(std::string_view path);

}  // namespace plcxx::diag
