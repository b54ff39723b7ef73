#include "adapters/database/option_values.hpp"

#include <utility>

#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

Expected<OptionValues>
OptionValues::of(const Options& options,
                 const std::vector<OptionDescription>& descriptions) {
  const OptionValues values(options, descriptions);
  for (const auto& option : descriptions)
    if (auto fits = check_option(option, values.text(option.name)); !fits)
      return tl::make_unexpected(fits.error());
  return values;
}

std::string OptionValues::text(const std::string& name) const {
  return option_value(options_, descriptions_, name);
}

Milliseconds OptionValues::duration(const std::string& name) const {
  return parse_duration(text(name)).value_or(Milliseconds(0));
}

bool OptionValues::truth(const std::string& name) const {
  return text(name) == "true";
}

Expected<void> OptionValues::read(const char* name, const std::string& folder,
                                  std::filesystem::path& path) const {
  const auto said = text(name);
  if (said.empty())
    return {};
  auto found = inside(folder, said, name);
  if (!found)
    return tl::make_unexpected(found.error());
  path = std::move(*found);
  return {};
}

Expected<void> OptionValues::read(const char* name, std::size_t& count) const {
  const auto number = parse_number(text(name)).integer_or(0);
  if (number < 1)
    return fail(ErrorKind::settings, "option '" + std::string(name) +
                                         "' is a whole number from 1, not '" +
                                         text(name) + "'");
  count = static_cast<std::size_t>(number);
  return {};
}

} // namespace parlour::adapters
