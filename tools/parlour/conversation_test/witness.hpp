// Witness: a child process that reports which conversations were running if the
// program ends before they do: by a crash, a signal or lack of memory. It needs
// no signal handler: it waits for a pipe to be closed, and then reads the names
// from memory that both processes share.
//
//   Witness witness; // before any thread
//   ...
//   const Witness::Held held(witness, conversation.file); // on any thread
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include <sys/types.h>

namespace parlour::tools {

class Witness {
public:
  // Starts the child. Make it before any other thread. If the system cannot
  // start one, there is simply no report.
  Witness();
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  ~Witness(); // ends the child; it has nothing to report

  // Says that a conversation runs, for as long as this object exists. If all
  // places are taken, the conversation is not listed. From any thread.
  class Held {
  public:
    Held(Witness& witness, const std::string& name);
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held();

  private:
    char* place_; // in the shared memory, or null
  };

private:
  // The shared memory: a fixed number of names; "" is a free place.
  static constexpr std::size_t places = 1000;
  static constexpr std::size_t longest = 256;
  using Names = char[places][longest];

  // The child: waits until the parent has ended, reports and exits.
  [[noreturn]] void watch(int end);
  // Prints the names that are left.
  void tell();

  // Guards the search for a free place.
  std::mutex mutex_;
  Names* names_ = nullptr; // null: no child
  int end_ = -1;           // our end of the pipe
  pid_t process_ = -1;     // the child, or -1
};

} // namespace parlour::tools
