// The receptionist with a voice seat, heard by SphinxASR.
#pragma once

#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/parlour/application/opening.hpp"

namespace parlour::test {

inline tools::Application spoken_receptionist() {
  auto places = tools::process_places();
  places.working = source_path("");
  std::ostringstream none;
  tools::VoiceWishes seat{"user.wav", "robot.wav"};
  seat.recogniser = "SphinxASR";
  auto opened =
      tools::open_application(places, "receptionist", {none, none}, seat);
  return std::get<tools::Application>(std::move(opened));
}

} // namespace parlour::test
