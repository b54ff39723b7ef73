// A loop for tests of what runs on one: an exception there fails the test.
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "adapters/loop/loop.hpp"

namespace parlour::test {

inline std::unique_ptr<adapters::Loop> start_loop() {
  return adapters::Loop::start([](const std::string& what) {
           ADD_FAILURE() << "thrown on the loop: " << what;
         })
      .value();
}

} // namespace parlour::test
