// Values of a plug-in's options, read with what its description says holds
// otherwise. Every error, of kind Settings, names the option.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class OptionValues {
public:
  // An error where a value is not of its option's type. Both outlive it.
  static Expected<OptionValues>
  of(const Options& options,
     const std::vector<OptionDescription>& descriptions);

  std::string text(const std::string& name) const;
  Milliseconds duration(const std::string& name) const;
  bool truth(const std::string& name) const;

  // Leaves `path` alone where the option says nothing; else it lies in
  // `folder`.
  Expected<void> read(const char* name, const std::string& folder,
                      std::filesystem::path& path) const;
  // A whole number from 1.
  Expected<void> read(const char* name, std::size_t& count) const;

private:
  OptionValues(const Options& options,
               const std::vector<OptionDescription>& descriptions)
      : options_(options), descriptions_(descriptions) {}

  const Options& options_;
  const std::vector<OptionDescription>& descriptions_;
};

} // namespace parlour::adapters
