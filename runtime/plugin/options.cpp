// The table of option types is in the header; here are its checks.

#include "runtime/plugin/options.hpp"

#include <algorithm>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

namespace {

std::string_view sentence_of(OptionType type) {
  constexpr std::string_view sentences[] = {
#define X(name, text, sentence) sentence,
      PARLOUR_OPTION_TYPES(X)
#undef X
  };
  return sentences[static_cast<std::size_t>(type)];
}

// Each type has one way of being written.
bool fits(const OptionDescription& option, const std::string& value) {
  switch (option.type) {
  case OptionType::text:
    return true;
  case OptionType::boolean:
    return value == "true" || value == "false";
  case OptionType::integer:
    return parse_number(value).if_integer() != nullptr;
  case OptionType::number:
    return !parse_number(value).is_unknown();
  case OptionType::duration:
    return parse_duration(value).has_value();
  case OptionType::choice:
    return std::ranges::count(option.choices, value) > 0;
  }
  return false;
}

// What the option takes, for messages: the sentence of its type, or its words.
std::string what_fits(const OptionDescription& option) {
  if (option.type != OptionType::choice)
    return std::string(sentence_of(option.type));
  std::string all;
  for (const auto& choice : option.choices)
    all += (all.empty() ? "'" : ", '") + choice + "'";
  return "one of " + all;
}

} // namespace

std::string_view name_of(OptionType type) {
  constexpr std::string_view names[] = {
#define X(name, text, sentence) text,
      PARLOUR_OPTION_TYPES(X)
#undef X
  };
  return names[static_cast<std::size_t>(type)];
}

Expected<void> check_option(const OptionDescription& option,
                            const std::string& value) {
  if (value.empty() || fits(option, value))
    return {};
  return fail(ErrorKind::settings, "the option '" + option.name + "' takes " +
                                       what_fits(option) + ", not '" + value +
                                       "': " + option.sentence);
}

// An empty value counts as not given.
std::string option_value(const Options& options,
                         const std::vector<OptionDescription>& descriptions,
                         const std::string& name) {
  const auto given = options.find(name);
  if (given != options.end() && !given->second.empty())
    return given->second;
  const auto described =
      std::ranges::find(descriptions, name, &OptionDescription::name);
  return described == descriptions.end() ? "" : described->fallback;
}

} // namespace parlour
