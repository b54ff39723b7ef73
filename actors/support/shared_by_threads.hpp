// SharedByThreads: what is replaced now and then, and read on every thread with
// each message.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <thread>
#include <utility>

namespace parlour::actors {

// Threads are counted as they come here.
std::size_t number_of_thread();

// Safe to use from any thread. Each of some threads has a pointer with a count
// of its own: were there one, every message would wait for a cache line that
// another thread has just written.
template <class What>
class SharedByThreads {
public:
  using Pointer = std::shared_ptr<const What>;

  // For who stores one after the other. A thread sees each in its turn; while
  // one is stored, some see it earlier than others.
  //
  // Each copy is a pointer with a holder of its own, so that threads count in
  // different places, but all of them point to the same object.
  void store(const Pointer& what) {
    for (auto& copy : copies_) {
      const auto holder = std::make_shared<const Holder>(Holder{what});
      copy.exchange(Pointer(holder, holder->what.get()));
    }
  }
  // Null before the first one.
  Pointer load() const {
    return copies_[number_of_thread() % copies_.size()].load();
  }

private:
  static constexpr std::size_t cache_line = 64;
  struct alignas(cache_line) Holder {
    Pointer what;
  };
  // In place of std::atomic<Pointer>: when that of g++ 12 has been read, its
  // lock is released with memory_order_relaxed, so that a processor may finish
  // reading after somebody has stored the next one.
  class alignas(cache_line) Copy {
  public:
    Pointer load() const {
      const Locked locked(is_locked_);
      return what_;
    }
    // The one before, which is given up when nobody waits for it any more.
    Pointer exchange(Pointer what) {
      const Locked locked(is_locked_);
      return std::exchange(what_, std::move(what));
    }

  private:
    // Others wait for one copied pointer: shorter than a mutex takes.
    class Locked {
    public:
      explicit Locked(std::atomic_flag& flag) : flag_(flag) {
        while (flag_.test_and_set(std::memory_order_acquire))
          std::this_thread::yield();
      }
      Locked(const Locked&) = delete;
      Locked& operator=(const Locked&) = delete;
      ~Locked() {
        flag_.clear(std::memory_order_release);
      }

    private:
      std::atomic_flag& flag_;
    };

    mutable std::atomic_flag is_locked_;
    Pointer what_;
  };
  // More threads than that share copies, which is slower and nothing else.
  std::array<Copy, 16> copies_;
};

} // namespace parlour::actors
