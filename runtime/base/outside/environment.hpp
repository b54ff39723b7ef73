// The environment of the process, and the folders of its user.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace parlour {

// Looks up an environment variable; nothing if it is unset or empty.
using EnvironmentLookup =
    std::function<std::optional<std::string>(const char* name)>;

// That of this process.
std::optional<std::string> environment_variable(const char* name);

// A folder of the user by the XDG base directory specification: that of the
// variable, such as XDG_CACHE_HOME, else `usual` below HOME. Empty if neither
// is an absolute path.
std::filesystem::path user_folder(const EnvironmentLookup& environment,
                                  const char* variable, const char* usual);

} // namespace parlour
