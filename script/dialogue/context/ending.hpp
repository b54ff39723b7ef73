// Ending: how a conversation comes to its end (engine rule 4.6). It goes from
// one stage to the next and never back:
//
//   open --wish--> wished --begin--> leaving --tell--> told --finish--> over
//
// It may begin without a wish, and finish before all has been told: the user is
// gone, or what runs at the end takes too long.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace parlour::dialogue {

class Ending {
public:
  // The conversation is to end as soon as all is said: nothing more is asked,
  // and the user is not heard any more.
  void wish() {
    go_on_to(Stage::wished);
  }
  // Exit runs: nobody is there any more who could answer. False where that has
  // begun before.
  bool begin() {
    return go_on_to(Stage::leaving);
  }
  // Session.Ended is raised. False where it was before.
  bool tell() {
    return go_on_to(Stage::told);
  }
  // Nothing else happens.
  void finish() {
    go_on_to(Stage::over);
  }

  bool is_wished() const { // or has come further
    return stage_ >= Stage::wished;
  }
  bool has_begun() const {
    return stage_ >= Stage::leaving;
  }
  bool is_over() const {
    return stage_ == Stage::over;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(stage_, Stage::over);
  }

private:
  enum class Stage : std::uint8_t { open, wished, leaving, told, over };

  bool go_on_to(Stage stage) { // false: it is there, or further
    return std::exchange(stage_, std::max(stage_, stage)) < stage;
  }

  Stage stage_ = Stage::open;
};

} // namespace parlour::dialogue
