// What a misspelt word may have been meant to be.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace plcxx::support {

/// How many letters are put in, left out or replaced by another.
size_t EditDistance(std::string_view a, std::string_view b);

/// The one word that is nearer to `word` than all others, and near enough; empty when there is none.
std::string_view NearestWord(std::string_view word, std::span<const std::string_view> words);
/// The same where capitals count: a name that differs from `name` in capitals alone is the nearest.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> names);
/// ", did you mean 'check'": what a message ends with; empty when there is no nearest word.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> words);
/// The same of texts.
std::string DidYouMean(std::string_view word, std::span<const std::string> words);
/// The same with the words themselves: ", did you mean 'check'; there are: check, test".
std::string ThereAre(std::string_view word, std::span<const std::string_view> words);
std::string ThereAre(std::string_view word, std::span<const std::string> words);

}  // namespace plcxx::support
