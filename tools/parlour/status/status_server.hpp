// StatusServer: answers whoever connects to its socket and asks, in one line,
// how the node is. On a thread of its own. The socket is there as long as the
// server.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "runtime/base/error.hpp"
#include "runtime/base/outside/descriptor.hpp"

namespace parlour::tools {

class StatusServer {
public:
  // Both are called on the server's thread, once for each who connects. Who
  // asks nothing is told, too.
  using Tell = std::function<std::string(const std::string& question)>;
  // Takes the connection of who asks to follow, with what follows that word.
  using Follow =
      std::function<void(Descriptor connection, const std::string& filter)>;

  // Binds PROCESS.sock in the folder, which is made where it is missing. Errors
  // have the kind File, or Limit where no descriptor is left.
  static Expected<std::unique_ptr<StatusServer>>
  open(const std::filesystem::path& folder, Tell tell, Follow follow = {});
  StatusServer(const StatusServer&) = delete;
  StatusServer& operator=(const StatusServer&) = delete;
  // Waits for a call of `tell` that is going on.
  ~StatusServer();

private:
  StatusServer(std::filesystem::path path, int listener, int stop, Tell tell,
               Follow follow);
  void serve();
  void pause() const;
  void answer(Descriptor connection) const;

  const std::filesystem::path path_;
  const int listener_;
  const int stop_; // an eventfd
  const Tell tell_;
  const Follow follow_; // may be empty
  std::thread thread_;  // last: it uses the others
};

} // namespace parlour::tools
