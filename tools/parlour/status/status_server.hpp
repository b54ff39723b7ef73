// StatusServer: tells whoever connects to its socket how the node is, on a
// thread of its own. The socket is there as long as the server.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "runtime/base/error.hpp"

namespace parlour::tools {

class StatusServer {
public:
  // Called on the server's thread, once for each who connects.
  using Tell = std::function<std::string()>;

  // Binds PROCESS.sock in the folder, which is made where it is missing. Errors
  // have the kind File, or Limit where no descriptor is left.
  static Expected<std::unique_ptr<StatusServer>>
  open(const std::filesystem::path& folder, Tell tell);
  StatusServer(const StatusServer&) = delete;
  StatusServer& operator=(const StatusServer&) = delete;
  // Waits for a call of `tell` that is going on.
  ~StatusServer();

private:
  StatusServer(std::filesystem::path path, int listener, int stop, Tell tell);
  void serve();
  void pause() const;
  void answer(int connection) const;

  const std::filesystem::path path_;
  const int listener_;
  const int stop_; // an eventfd
  const Tell tell_;
  std::thread thread_; // last: it uses the others
};

} // namespace parlour::tools
