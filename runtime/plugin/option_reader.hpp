// OptionReader reads the options of a plug-in, one after the other, with the
// defaults of their descriptions. The first mistake counts: an error of kind
// Settings that names the option and says what it takes.
//
//  OptionReader read(options, descriptions);
//  made.connections = read.count("connections", 1, 100);
//  made.timeout = read.duration("timeout", Milliseconds(1));
//  if (const auto outcome = read.outcome(); !outcome)
//    return tl::make_unexpected(outcome.error());
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour {

class OptionReader {
public:
  // A value that is not of the type of its description is a mistake. Both
  // arguments must outlive the reader.
  OptionReader(const Options& given,
               const std::vector<OptionDescription>& descriptions);

  // Whether there is a value or a default: neither is empty.
  bool has(const std::string& name) const;
  std::string text(const std::string& name) const;
  bool truth(const std::string& name) const;

  // What is outside of the bounds is a mistake; then the value is `least`.
  std::int64_t
  integer(const std::string& name, std::int64_t least,
          std::int64_t most = std::numeric_limits<std::int64_t>::max());
  std::size_t
  count(const std::string& name, std::int64_t least,
        std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
    return static_cast<std::size_t>(integer(name, least, most));
  }
  double number(const std::string& name, double least, double most);
  Milliseconds duration(const std::string& name,
                        Milliseconds least = Milliseconds::zero(),
                        Milliseconds most = Milliseconds::max());
  // A file of `folder`, which no path may leave; empty if the option is.
  std::filesystem::path file(const std::string& name,
                             const std::filesystem::path& folder);

  // Notes a mistake: "the option 'name' " and what it takes, or what is wrong.
  void wrong(const std::string& name, const std::string& what);
  // Notes what another function has found.
  void wrong(const Error& error);

  // The first mistake.
  Expected<void> outcome() const;

private:
  void beyond(const std::string& name, const std::string& kind,
              const std::string& least, const std::string& most);

  const Options& given_;
  const std::vector<OptionDescription>& descriptions_;
  std::optional<Error> error_;
};

} // namespace parlour
