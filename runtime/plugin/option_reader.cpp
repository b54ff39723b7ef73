#include "runtime/plugin/option_reader.hpp"

#include <utility>

#include "runtime/base/value.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour {

namespace {

// As settings write it: "200ms", "2s", "1h".
std::string written(Milliseconds time) {
  constexpr std::pair<std::int64_t, const char*> units[] = {
      {3'600'000, "h"}, {60'000, "m"}, {1'000, "s"}};
  for (const auto& [size, unit] : units)
    if (time.count() > 0 && time.count() % size == 0)
      return std::to_string(time.count() / size) + unit;
  return std::to_string(time.count()) + "ms";
}

} // namespace

OptionReader::OptionReader(const Options& given,
                           const std::vector<OptionDescription>& descriptions)
    : given_(given), descriptions_(descriptions) {
  for (const auto& option : descriptions)
    if (auto fits = check_option(option, text(option.name)); !fits)
      wrong(fits.error());
}

bool OptionReader::has(const std::string& name) const {
  return !text(name).empty();
}

std::string OptionReader::text(const std::string& name) const {
  return option_value(given_, descriptions_, name);
}

bool OptionReader::truth(const std::string& name) const {
  return text(name) == "true";
}

std::int64_t OptionReader::integer(const std::string& name, std::int64_t least,
                                   std::int64_t most) {
  const auto value = parse_number(text(name));
  const auto* const whole = value.if_integer();
  if (whole && *whole >= least && *whole <= most)
    return *whole;
  const bool is_bounded = most < std::numeric_limits<std::int64_t>::max();
  beyond(name, "a whole number", std::to_string(least),
         is_bounded ? std::to_string(most) : "");
  return least;
}

double OptionReader::number(const std::string& name, double least,
                            double most) {
  const auto value = parse_number(text(name));
  const auto read = value.number_or(0);
  if (!value.is_unknown() && read >= least && read <= most)
    return read;
  beyond(name, "a number", to_string(Value(least)), to_string(Value(most)));
  return least;
}

Milliseconds OptionReader::duration(const std::string& name, Milliseconds least,
                                    Milliseconds most) {
  const auto value = parse_duration(text(name));
  if (value && *value >= least && *value <= most)
    return *value;
  beyond(name, "a time", written(least),
         most < Milliseconds::max() ? written(most) : "");
  return least;
}

std::filesystem::path OptionReader::file(const std::string& name,
                                         const std::filesystem::path& folder) {
  const auto said = text(name);
  if (said.empty())
    return {};
  auto found = inside(folder, said, name);
  if (found)
    return std::move(*found);
  wrong(found.error());
  return {};
}

void OptionReader::wrong(const std::string& name, const std::string& what) {
  wrong({ErrorKind::settings, "the option '" + name + "' " + what, {}});
}

void OptionReader::wrong(const Error& error) {
  if (!error_)
    error_ = error;
}

Expected<void> OptionReader::outcome() const {
  if (error_)
    return tl::make_unexpected(*error_);
  return {};
}

void OptionReader::beyond(const std::string& name, const std::string& kind,
                          const std::string& least, const std::string& most) {
  wrong(name, "is " + kind + " from " + least +
                  (most.empty() ? "" : " to " + most) + ", not '" + text(name) +
                  "'");
}

} // namespace parlour
