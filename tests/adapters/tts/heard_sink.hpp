// A sink for tests of synthesizers: counts what it hears.
#pragma once

#include <set>

#include "adapters/tts/synthesizer.hpp"

namespace parlour::test {

struct HeardSink : adapters::tts::SpeechSink {
  void word(std::size_t index, std::int64_t) override {
    words.insert(index);
  }
  bool sound(std::span<const adapters::Sample> heard, int its_rate) override {
    samples += heard.size();
    rate = its_rate;
    return true;
  }
  bool is_wanted() const override {
    return true;
  }

  std::set<std::size_t> words;
  std::size_t samples = 0;
  int rate = 0;
};

} // namespace parlour::test
