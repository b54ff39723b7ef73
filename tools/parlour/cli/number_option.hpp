// An option of a command that takes a whole number.
#pragma once

#include <charconv>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace parlour::tools {

// A whole number in its range, by digits alone.
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
