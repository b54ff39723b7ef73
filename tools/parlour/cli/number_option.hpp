// add_number: a command-line option whose value is a whole number in a range.
//
// CLI11 would also accept "0x10", "1e3" or a negative number for an unsigned
// type; this option accepts decimal digits only (and "-" for signed types).
#pragma once

#include <charconv>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace parlour::tools {

// Adds the option `name` to `command`, with `sentence` as its help text.
// `take(number)` is called for a valid value; any other text is a usage error
// that names the range, both ends of which are allowed.
//
//   add_number<int>(command, "--runs", {1, 1000}, "Runs of each row",
//                   [&](int runs) { options.runs = runs; });
template <class Number, class Take>
void add_number(CLI::App* command, const std::string& name,
                std::pair<Number, Number> range, const char* sentence,
                Take take) {
  command
      ->add_option_function<std::string>(
          name,
          [=](const std::string& text) {
            Number number{};
            const auto* end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, number);
            if (read.ec != std::errc() || read.ptr != end ||
                number < range.first || number > range.second)
              throw CLI::ValidationError(
                  name, "'" + text + "' is no whole number from " +
                            std::to_string(range.first) + " to " +
                            std::to_string(range.second));
            take(number);
          },
          sentence)
      ->type_name("NUMBER");
}

} // namespace parlour::tools
