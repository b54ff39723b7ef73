// StatusServer: answers whoever connects to its socket and asks, in one line,
// how the node is. On a thread of its own. The socket is there as long as the
// server.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "runtime/base/error.hpp"
#include "runtime/base/outside/descriptor.hpp"

namespace parlour::tools {

class StatusServer {
public:
  // Both are called on the server's thread, once for each who connects. Who
  // asks nothing is told, too.
  using Tell = std::function<std::string(const std::string& question)>;
  // Takes the connection of who asks by a word that needs time, with what
  // follows that word.
  using Take =
      std::function<void(Descriptor connection, const std::string& rest)>;
  using TakenWords = std::map<std::string, Take>;

  // Binds PROCESS.sock in the folder, which is made where it is missing. Errors
  // have the kind File, or Limit where no descriptor is left.
  static Expected<std::unique_ptr<StatusServer>>
  open(const std::filesystem::path& folder, Tell tell, TakenWords taken = {});
  StatusServer(const StatusServer&) = delete;
  StatusServer& operator=(const StatusServer&) = delete;
  // Waits for a call of `tell` that is going on.
  ~StatusServer();

private:
  StatusServer(std::filesystem::path path, int listener, int stop, Tell tell,
               TakenWords taken);
  void serve();
  void pause() const;
  void answer(Descriptor connection) const;

  const std::filesystem::path path_;
  const int listener_;
  const int stop_; // an eventfd
  const Tell tell_;
  const TakenWords taken_;
  std::thread thread_; // last: it uses the others
};

// Who does not read for a second gets no more.
void send_all(const Descriptor& connection, std::string_view text);

} // namespace parlour::tools
