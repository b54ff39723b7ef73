// OptionValues reads the options of a plug-in, with the defaults of their
// descriptions where a setting is absent. Every error has the kind Settings and
// names the option.
//
//  const auto values = OptionValues::of(options, descriptions);
//  if (!values)
//    return tl::make_unexpected(values.error());
//  const auto timeout = values->duration("busy-timeout");
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class OptionValues {
public:
  // Checks each option against the type in its description. The object refers
  // to both arguments, which must outlive it.
  static Expected<OptionValues>
  of(const Options& options,
     const std::vector<OptionDescription>& descriptions);

  // The value of an option, or its default. `of` has checked the types, so that
  // `duration` and `truth` cannot fail.
  std::string text(const std::string& name) const;
  Milliseconds duration(const std::string& name) const;
  bool truth(const std::string& name) const;

  // Sets `path` to the named file inside of `folder`. Leaves `path` unchanged
  // if the option is empty, and fails for a path that leads out of `folder`.
  Expected<void> read(const char* name, const std::string& folder,
                      std::filesystem::path& path) const;
  // Sets `count` to the option's value, a whole number of at least 1.
  Expected<void> read(const char* name, std::size_t& count) const;

private:
  OptionValues(const Options& options,
               const std::vector<OptionDescription>& descriptions)
      : options_(options), descriptions_(descriptions) {}

  const Options& options_;
  const std::vector<OptionDescription>& descriptions_;
};

} // namespace parlour::adapters
