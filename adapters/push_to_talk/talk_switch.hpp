// TalkSwitch decides from the movements of a key whether somebody talks. It
// touches no device.
//
//  hold    talks from the press to the release. A terminal tells of no release,
//          but repeats a key that is held: the key counts as released when no
//          repetition has come for a while.
//  twice   the first press begins, the second one ends; what a terminal repeats
//          while a key is held is no press. It cannot be told from a second
//          press that follows as soon as a repetition would.
//
// For one thread at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace parlour::adapters {

enum class TalkBy : std::uint8_t { hold, twice };

class TalkSwitch {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Terminals begin to repeat after 250 to 660 ms, and go on every 25 to 50 ms.
  static constexpr std::chrono::milliseconds first_repetition{750};
  static constexpr std::chrono::milliseconds repetition{200};

  explicit TalkSwitch(TalkBy by) : by_(by) {}

  // Each returns whether somebody talks now, if that has changed.
  using Change = std::optional<bool>;
  Change pressed();
  Change released();
  // A terminal sent the key.
  Change typed(Moment now);
  // To be called at the moment of due().
  Change passed(Moment now);
  // The key is forgotten: the device is gone, or nobody may talk.
  Change reset();

  // When a key counts as released of which a terminal tells no more.
  std::optional<Moment> due() const {
    return due_;
  }

private:
  Change talk(bool talks);

  const TalkBy by_;
  bool talks_ = false;
  std::optional<Moment> typed_; // when, last
  bool repeats_ = false;        // whether that was a repetition
  std::optional<Moment> due_;
};

} // namespace parlour::adapters
