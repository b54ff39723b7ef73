#include "adapters/database/option_values.hpp"

#include <utility>

#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

std::string OptionValues::text(const std::string& name) const {
  if (auto found = options_.find(name); found != options_.end())
    return found->second;
  for (const auto& option : descriptions_)
    if (option.name == name)
      return option.fallback;
  return {};
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

Expected<void> OptionValues::read(const char* name,
                                  Milliseconds& duration) const {
  auto read = parse_duration(text(name));
  if (!read)
    return fail(ErrorKind::settings,
                "option '" + std::string(name) + "': " + read.error().message);
  duration = *read;
  return {};
}

Expected<void> OptionValues::read(const char* name, std::size_t& count) const {
  const auto number = parse_number(text(name));
  if (!number.if_integer() || *number.if_integer() < 1)
    return fail(ErrorKind::settings, "option '" + std::string(name) +
                                         "' is a whole number from 1, not '" +
                                         text(name) + "'");
  count = static_cast<std::size_t>(*number.if_integer());
  return {};
}

Expected<void> OptionValues::read(const char* name, bool& truth) const {
  const auto said = text(name);
  if (said != "true" && said != "false")
    return fail(ErrorKind::settings, "option '" + std::string(name) +
                                         "' is true or false, not '" + said +
                                         "'");
  truth = said == "true";
  return {};
}

} // namespace parlour::adapters
