// Masking: what is private="true" as observers are shown it (engine rule 7.6):
// in its place stands ***.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/message.hpp"

namespace parlour {

inline constexpr std::string_view mask = "***";

// Texts that are not to be shown.
class Secrets {
public:
  // False where it is blank or here already.
  bool add(std::string text);
  void add(const Secrets& others);
  bool empty() const {
    return texts_.empty();
  }

  // Capital or small, digits also in groups ("9123 4567"); short ones only
  // where they stand alone.
  std::string masked(std::string_view text) const;
  // The same of all texts and numbers inside.
  Value masked_value(const Value& value) const;
  Message masked_message(Message message) const;

private:
  std::size_t found_at(std::string_view text, std::size_t at) const;

  std::vector<std::string> texts_; // longer ones first
};

// All texts and numbers inside.
Value all_masked(const Value& value);

} // namespace parlour
