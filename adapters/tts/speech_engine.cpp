#include "adapters/tts/speech_engine.hpp"

#include <future>
#include <utility>

namespace parlour::adapters::tts {

SpeechEngine::SpeechEngine(std::unique_ptr<Synthesizer> synthesizer)
    : synthesizer_(std::move(synthesizer)),
      length_(synthesizer_->piece_length()), thread_([this] { work(); }) {}

SpeechEngine::~SpeechEngine() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    turns_.clear();
  }
  changed_.notify_all();
  thread_.join();
}

// The lock is held while the job is asked, so that it is not put aside while
// somebody takes from it.
void SpeechEngine::go_on(const Job& job) {
  const std::lock_guard lock(mutex_);
  if (!job->wants_more() || !queued_.insert(job).second)
    return;
  turns_.push_back(job);
  changed_.notify_all();
}

void SpeechEngine::run(const Task& task) {
  const auto done = std::make_shared<std::promise<void>>();
  {
    const std::lock_guard lock(mutex_);
    tasks_.emplace_back([this, &task, done] {
      task(*synthesizer_);
      done->set_value();
    });
  }
  changed_.notify_all();
  done->get_future().wait();
}

void SpeechEngine::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] {
      return is_ending_ || !tasks_.empty() || !turns_.empty();
    });
    if (!tasks_.empty())
      do_task(lock);
    else if (!turns_.empty())
      take_turn(lock);
    else
      return;
  }
}

void SpeechEngine::do_task(std::unique_lock<std::mutex>& lock) {
  const auto task = std::move(tasks_.front());
  tasks_.pop_front();
  lock.unlock();
  task();
  lock.lock();
}

void SpeechEngine::take_turn(std::unique_lock<std::mutex>& lock) {
  const auto job = std::move(turns_.front());
  turns_.pop_front();
  lock.unlock();
  job->speak_next(*synthesizer_);
  lock.lock();
  if (job->wants_more() && !is_ending_)
    turns_.push_back(job);
  else
    queued_.erase(job);
}

// -- one for all --------------------------------------------------------------

Expected<std::shared_ptr<SpeechEngine>> SharedEngine::use() {
  const std::lock_guard lock(mutex_);
  if (users_ == 0) {
    auto made = make_();
    if (!made)
      return tl::make_unexpected(made.error());
    engine_ = std::make_unique<SpeechEngine>(std::move(*made));
  }
  ++users_;
  return std::shared_ptr<SpeechEngine>(engine_.get(),
                                       [this](SpeechEngine*) { let_go(); });
}

// Under the lock: the next engine does not start before this one has ended.
void SharedEngine::let_go() {
  const std::lock_guard lock(mutex_);
  if (--users_ == 0)
    engine_.reset();
}

} // namespace parlour::adapters::tts
