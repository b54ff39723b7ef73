// What a plug-in needs that answers messages later, from a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <limits>
#include <mutex>

#include "runtime/message/message.hpp"

namespace parlour {

// The parts of a message that its answer needs. The rest, such as the sinks,
// has served its purpose and is not copied.
Message without_its_way(const Message& message);

// Counts the messages that are not answered yet. Thread-safe.
class OpenMessages {
public:
  // False: so many are open already, and this one is not counted.
  bool open(std::size_t most = std::numeric_limits<std::size_t>::max());
  // One has been answered.
  void close();
  // For virtual time, where the next message may not be taken, nor the clock
  // advanced, before the last is answered.
  void wait_for_all();

  // Closes one at its end, also where the answer throws.
  class Closing {
  public:
    explicit Closing(OpenMessages& messages) : messages_(messages) {}
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;
    ~Closing() {
      messages_.close();
    }

  private:
    OpenMessages& messages_;
  };

private:
  std::mutex mutex_;
  std::condition_variable closed_;
  std::size_t count_ = 0;
};

} // namespace parlour
