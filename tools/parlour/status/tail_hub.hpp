// TailHub: sends what happens in a node to whoever follows it (`parlour tail`),
// each with a filter. Nobody waits for who reads slowly: beyond a bound lines
// are lost, and the reader is told how many.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "runtime/base/outside/descriptor.hpp"
#include "tools/parlour/status/tail_filter.hpp"

namespace parlour::tools {

class TailHub {
public:
  static constexpr std::size_t max_readers = 8;
  static constexpr std::size_t max_lines = 2'000; // that wait for one of them

  // Called with true when somebody follows, with false when nobody does any
  // more.
  using Watch = std::function<void(bool)>;

  explicit TailHub(RolesByComponent roles = {});
  TailHub(const TailHub&) = delete;
  TailHub& operator=(const TailHub&) = delete;
  ~TailHub(); // as close()

  // From any thread; never blocks. Nothing happens where nobody follows.
  void see(const Inspection& seen, Timestamp now);

  // Before anybody follows.
  void connect(Watch watch);
  // A socket that is read line by line. From any thread.
  void add(Descriptor reader, TailFilter filter);
  // Nobody is served any more.
  void close();

private:
  struct Reader {
    Descriptor socket;
    TailFilter filter;
    std::deque<std::string> lines = {};
    std::uint64_t lost = 0;  // since the last line that was kept
    std::string unsent = {}; // the thread's own
    bool is_gone = false;
  };

  // The turn of a message's session, as far as it was seen.
  Inspection with_turn(const Inspection& seen);
  void serve();
  // With the lock; false where the hub is to end.
  bool drop_those_gone();
  static bool has_something(const Reader& reader);
  static void send_some(Reader& reader);
  static void take_lines(Reader& reader);

  const RolesByComponent roles_;
  std::atomic<bool> is_followed_ = false;
  std::mutex mutex_; // of what follows
  Watch watch_;
  std::list<Reader> readers_;
  // Those of the sessions in which something was seen.
  std::map<SessionId, std::uint64_t> turns_;
  Descriptor wake_; // an eventfd
  bool ends_ = false;
  std::thread thread_; // from the first reader on
};

} // namespace parlour::tools
