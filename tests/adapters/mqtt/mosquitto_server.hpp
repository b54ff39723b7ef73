// MosquittoServer is a private MQTT server for tests: mosquitto on a free port
// of this machine, without memory of its own. It is killed when the thread that
// started it ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <sys/types.h>

#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

// Not thread-safe.
class MosquittoServer {
public:
  // The path of the server's program; empty if it is not installed.
  static std::filesystem::path program();

  // `settings` are lines of mosquitto.conf in addition to those that every such
  // server gets; "FOLDER" in them is the server's own folder.
  explicit MosquittoServer(std::string settings = "allow_anonymous true\n");
  MosquittoServer(const MosquittoServer&) = delete;
  MosquittoServer& operator=(const MosquittoServer&) = delete;
  ~MosquittoServer();

  // Starts it, on the same port each time, and waits until it accepts
  // connections. Throws if that fails.
  void start();
  // Ends it at once.
  void kill();

  // Lets `user` in with a password. Call it before start().
  void add_user(const std::string& user, const std::string& password) const;

  std::uint16_t port() const {
    return port_;
  }
  const std::filesystem::path& folder() const {
    return folder_.path();
  }

private:
  void launch(int output);
  bool is_ready(int log);
  void write_settings() const;

  const TemporaryFolder folder_;
  std::string settings_;
  std::string said_;
  std::uint16_t port_ = 0;
  pid_t process_ = -1;
};

} // namespace parlour::test
