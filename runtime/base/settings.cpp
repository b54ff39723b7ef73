#include "runtime/base/settings.hpp"

#include <algorithm>

namespace parlour {

const SeatSettings* find_seat(const std::vector<SeatSettings>& seats,
                              std::string_view name) {
  const auto found = std::ranges::find(seats, name, &SeatSettings::name);
  return found == seats.end() ? nullptr : &*found;
}

} // namespace parlour
