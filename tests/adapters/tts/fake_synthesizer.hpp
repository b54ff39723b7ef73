// A synthesizer for tests: each word takes 100 ms of the same sample. A gate
// can hold it up.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "adapters/tts/synthesizer.hpp"

namespace parlour::test {

inline constexpr adapters::Sample fake_sample = 1'000;

// "word word word …"
inline std::string words(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "word ";
  return text;
}

// What the test says and sees of it. Thread-safe once it is used.
class FakeSynthesizerState {
public:
  int rate = adapters::speech_rate;
  adapters::tts::PieceLength length{200, 500};
  std::string silent; // a word that takes no time and is not told
  bool is_missing = false;

  // Whoever speaks waits before each word until the gate is open.
  void close();
  void open();
  void wait_for_caller();

  int words_spoken() const;
  int instances() const;
  // Of each piece.
  std::vector<std::string> voices() const;

private:
  friend class FakeSynthesizer;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool closed_ = false;
  bool has_caller_ = false;
  int words_ = 0;
  int instances_ = 0;
  std::vector<std::string> voices_;
};

Expected<std::unique_ptr<adapters::tts::Synthesizer>>
make_fake_synthesizer(FakeSynthesizerState& state);

} // namespace parlour::test
