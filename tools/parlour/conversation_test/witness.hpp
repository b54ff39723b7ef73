// Witness: a process beside a run of conversations that says which of them were
// held when the program ended before they did, however that came about: by a
// crash, a signal, or for want of memory. It handles no signal: it sees that a
// pipe is closed.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include <sys/types.h>

namespace parlour::tools {

class Witness {
public:
  // Starts the process; make it before any thread. Where the system gives none
  // there is no witness.
  Witness();
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  ~Witness(); // nothing is left to tell

  // A conversation that is being held for as long as this exists. From any
  // thread.
  class Held {
  public:
    Held(Witness& witness, const std::string& name);
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held();

  private:
    char* place_;
  };

private:
  // What both processes see: names, each in a place of its own; "" is free.
  static constexpr std::size_t places = 1000;
  static constexpr std::size_t longest = 256;
  using Names = char[places][longest];

  [[noreturn]] void watch(int end);
  void tell();

  std::mutex mutex_;
  Names* names_ = nullptr; // null: no witness
  int end_ = -1;           // of the pipe, closed when this process ends
  pid_t process_ = -1;
};

} // namespace parlour::tools
