// plcxx explain: the long text of a message.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/explain.h"
#include "transpiler/diagnostics/places.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr const char* kExplainFooter = R"(Examples:
  plcxx explain nc110-41
  plcxx explain W356          without the dialect where it is clear
  plcxx explain               all codes with their headings; --list as well
  plcxx explain double coil   the codes whose pages speak of these words

Exit codes: 0 shown, 2 no such code.)";

constexpr size_t kMostNearNames = 5;
constexpr size_t kNear = 2;  // edits

struct ExplainSettings {
  std::vector<std::string> words;
  bool list = false;
};

char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) { return LowerCase(c); });
  return lower;
}

std::string_view WithoutDialect(std::string_view code) { return code.substr(code.find('-') + 1); }

/// The codes that `asked` may mean: those that it names without their dialect.
std::vector<std::string_view> CodesNamed(std::string_view asked) {
  std::vector<std::string_view> found;
  for (const std::string_view code : diag::ExplainedCodes()) {
    if (LowerCase(WithoutDialect(code)) == LowerCase(asked)) found.push_back(code);
  }
  return found;
}

/// The nearest codes, nearest first.
std::vector<std::string_view> NearCodes(std::string_view asked) {
  std::vector<std::pair<size_t, std::string_view>> ranked;
  const std::string lower = LowerCase(asked);
  for (const std::string_view code : diag::ExplainedCodes()) {
    const size_t distance = std::min(support::EditDistance(lower, LowerCase(code)),
                                     support::EditDistance(lower, LowerCase(WithoutDialect(code))) + 1);
    if (distance <= kNear) ranked.emplace_back(distance, code);
  }
  std::ranges::stable_sort(ranked, {}, &std::pair<size_t, std::string_view>::first);
  std::vector<std::string_view> codes;
  for (size_t i = 0; i < std::min(ranked.size(), kMostNearNames); ++i) codes.push_back(ranked[i].second);
  return codes;
}

/// The heading of a code's page, without the code.
std::string_view HeadingOf(const diag::Row& row) {
  const std::optional<std::string_view> page = diag::Explain(row.code);
  std::string_view heading = page ? page->substr(0, page->find('\n')) : row.text;
  if (const size_t colon = heading.find(": "); page && colon != std::string_view::npos)
    heading.remove_prefix(colon + 2);
  return heading;
}

/// Do the page and the message speak of all the words?
bool SpeaksOf(const diag::Row& row, const std::vector<std::string>& words) {
  const std::string text = LowerCase(std::string(row.code) + " " + std::string(diag::Explain(row.code).value_or("")) +
                                     " " + std::string(row.text) + " " + std::string(row.remedy));
  return std::ranges::all_of(words,
                             [&](const std::string& word) { return text.find(LowerCase(word)) != std::string::npos; });
}

/// "nc110-41   error    wrong block name ...": the heading of each page, in the catalogue's order. Gives their number.
size_t PrintList(const std::vector<std::string>& words) {
  std::string_view last;
  size_t count = 0;
  for (const diag::Row& row : diag::Catalogue()) {
    if (row.code == last || !SpeaksOf(row, words)) continue;
    last = row.code;
    ++count;
    std::cout << row.code << std::string(row.code.size() < 14 ? 14 - row.code.size() : 1, ' ') << std::left
              << std::setw(9) << diag::SeverityName(row.severity) << HeadingOf(row) << '\n';
  }
  return count;
}

int RunExplain(const ExplainSettings& settings) {
  if (settings.list || settings.words.empty()) {
    PrintList(settings.words);
    return kDone;
  }
  const std::string& code = settings.words.front();
  std::optional<std::string_view> page;
  std::vector<std::string_view> near;
  if (settings.words.size() == 1) {
    page = diag::Explain(code);
    const std::vector<std::string_view> named = CodesNamed(code);
    if (!page && named.size() > 1) {
      return UsageError("'" + code + "' is a code of several dialects: " + support::CommaSeparated(named));
    }
    if (!page && named.size() == 1) page = diag::Explain(named.front());
    near = NearCodes(code);
  }
  if (page) {
    std::cout << *page;
    if (!page->ends_with('\n')) std::cout << '\n';
    return kDone;
  }
  if (near.empty() && PrintList(settings.words) > 0) return kDone;
  if (settings.words.size() > 1) {
    return UsageError("no page speaks of all these words; plcxx explain shows all");
  }
  return UsageError("unknown code '" + code + "'" +
                    (near.empty() ? ", and no page speaks of it; plcxx explain --list shows all"
                                  : ", did you mean " + support::CommaSeparated(near)));
}

}  // namespace

void AddExplain(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("explain", "What a message means and what to do");
  const auto settings = std::make_shared<ExplainSettings>();
  command->add_option("CODE", settings->words, "A code such as nc110-41, or words to look for in the pages")
      ->type_name("");
  command->add_flag("--list", settings->list, "All codes");
  command->footer(kExplainFooter);
  command->callback([settings, &run] { run = [settings] { return RunExplain(*settings); }; });
}

}  // namespace plcxx::driver
