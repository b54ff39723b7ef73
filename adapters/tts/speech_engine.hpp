// SpeechEngine is the thread on which a synthesizer works. Libraries for speech
// have global state, so all instances of a plug-in share one engine
// (SharedEngine), and their texts take turns: a piece of each.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "adapters/tts/speech_job.hpp"
#include "adapters/tts/synthesizer.hpp"

namespace parlour::adapters::tts {

// Thread-safe.
class SpeechEngine {
public:
  using Job = std::shared_ptr<SpeechJob>;
  using Task = std::function<void(Synthesizer&)>;

  explicit SpeechEngine(std::unique_ptr<Synthesizer> synthesizer);
  SpeechEngine(const SpeechEngine&) = delete;
  SpeechEngine& operator=(const SpeechEngine&) = delete;
  // Forgets what is left. The jobs must have been cancelled.
  ~SpeechEngine();

  PieceLength piece_length() const {
    return length_;
  }
  // Synthesizes until enough is ready. To be called again when some of it has
  // been taken.
  void go_on(const Job& job);
  // Runs the task on the engine's thread, before the next piece, and waits for
  // its end.
  void run(const Task& task);

private:
  void work();
  // They let go of the lock meanwhile.
  void do_task(std::unique_lock<std::mutex>& lock);
  void take_turn(std::unique_lock<std::mutex>& lock);

  const std::unique_ptr<Synthesizer> synthesizer_;
  const PieceLength length_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::deque<Job> turns_;
  // The jobs that have a turn, and the one whose turn it is.
  std::set<Job> queued_;
  bool is_ending_ = false;
  std::thread thread_; // the last member: it uses the others
};

// The one engine of a library, as long as anybody uses it. Thread-safe; lives
// as long as the program.
class SharedEngine {
public:
  using Make = std::function<Expected<std::unique_ptr<Synthesizer>>()>;

  explicit SharedEngine(Make make) : make_(std::move(make)) {}

  // Starts the engine if nobody uses it yet. The last who lets go ends it.
  Expected<std::shared_ptr<SpeechEngine>> use();

private:
  void let_go();

  const Make make_;
  std::mutex mutex_;
  std::size_t users_ = 0;
  std::unique_ptr<SpeechEngine> engine_;
};

} // namespace parlour::adapters::tts
