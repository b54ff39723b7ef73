#include "adapters/audio/pace.hpp"

#include <algorithm>
#include <cmath>

namespace parlour::adapters {

namespace {

// 800 frames a second: a component may fire 1,000 events without being asked.
constexpr double fastest = 16;
constexpr double slowest = 0.1;

} // namespace

OptionDescription pace_option(const std::string& what) {
  return {"pace", "1",
          "how much faster than the clock " + what +
              ": 10 is ten times, 16 the most; 0 is as fast as can be",
          false, OptionType::number};
}

Expected<Pace> Pace::read(const std::string& text) {
  const auto factor = parse_number(text).number_or(-1);
  if (factor == 0)
    return Pace(fastest);
  if (!(factor >= slowest && factor <= fastest))
    return fail(ErrorKind::settings,
                "the option 'pace' is a number from 0.1 to 16, or 0 for as "
                "fast as can be, not '" +
                    text + "'");
  return Pace(factor);
}

void Pace::begin(Timestamp now) {
  begin_ = now;
  done_ = 0;
}

void Pace::next() {
  ++done_;
}

Timestamp Pace::due() const {
  return begin_ + static_cast<Timestamp>(static_cast<double>(done_ + 1) *
                                         frame_time / factor_);
}

Milliseconds Pace::until_next(Timestamp now) {
  const auto late = now - due();
  const auto most = static_cast<Timestamp>(
      static_cast<double>(most_late * frame_time) / factor_);
  if (late > most)
    begin_ += late;
  return Milliseconds(std::max<Timestamp>(0, due() - now));
}

Milliseconds Pace::sound_in(Milliseconds time) const {
  return Milliseconds(
      static_cast<std::int64_t>(static_cast<double>(time.count()) * factor_));
}

} // namespace parlour::adapters
