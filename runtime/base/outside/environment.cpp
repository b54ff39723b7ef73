#include "runtime/base/outside/environment.hpp"

#include <cstdlib>

namespace parlour {

std::optional<std::string> environment_variable(const char* name) {
  const auto* value = std::getenv(name);
  return value && *value ? std::optional<std::string>(value) : std::nullopt;
}

std::filesystem::path user_folder(const EnvironmentLookup& environment,
                                  const char* variable, const char* usual) {
  const auto folder = [&](const char* name) {
    return std::filesystem::path(environment(name).value_or(""));
  };
  auto found = folder(variable);
  // The specification: relative paths are ignored.
  if (!found.is_absolute())
    found = folder("HOME") / usual;
  return found.is_absolute() ? found : std::filesystem::path();
}

} // namespace parlour
