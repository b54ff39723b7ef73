// A server with a robot's component, and agents that connect to it.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <asio.hpp>
#include <gmock/gmock.h>
#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/server/agent_server.hpp"
#include "adapters/agents/wire/multipart.hpp"
#include "adapters/agents/wire/text_line.hpp"
#include "adapters/agents/zeromq/key_pair.hpp"

namespace parlour::adapters::agents {

// What a test was told on other threads; it waits for that.
class Notes {
public:
  void note(std::string text) {
    std::lock_guard lock(mutex_);
    notes_.push_back(std::move(text));
    changed_.notify_all();
  }
  // The next so many.
  std::vector<std::string> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(10),
                      [&] { return notes_.size() >= count; });
    return std::exchange(notes_, {});
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> notes_;
};

// Notes what it is told.
class NotingComponent : public AgentServer::Component, public Notes {
public:
  void online(const Hello& hello) override {
    note(hello.name + " online");
  }
  void offline() override {
    note("offline");
  }
  std::optional<WireError> received(AgentMessage message) override {
    if (message.command == throws_at)
      throw std::runtime_error(message.command + " is too much");
    note(message.command);
    return {};
  }
  void refused(const AgentMessage& message, const Error& error) override {
    note(message.command + " refused: " + std::string(name_of(error.kind)));
  }
  void failed(const std::string& reason) noexcept override {
    note("failed: " + reason);
  }

  // At this command it throws; set it before the component is attached.
  std::string throws_at;
};

// An agent that speaks in lines, as a person would type them.
class LineAgent {
public:
  explicit LineAgent(const std::string& address) : socket_(context_) {
    const auto port = address.substr(address.rfind(':') + 1);
    socket_.connect({asio::ip::make_address("127.0.0.1"),
                     static_cast<asio::ip::port_type>(std::stoi(port))});
  }

  // Where it is connected.
  asio::ip::tcp::endpoint platform() const {
    return socket_.remote_endpoint();
  }
  void say(const std::string& line) {
    asio::write(socket_, asio::buffer(line + '\n'));
  }
  std::string hear() {
    const auto size =
        asio::read_until(socket_, asio::dynamic_buffer(held_), '\n');
    auto line = held_.substr(0, size - 1);
    held_.erase(0, size);
    return line;
  }

private:
  asio::io_context context_;
  asio::ip::tcp::socket socket_;
  std::string held_;
};

// An agent over ZeroMQ.
class FrameAgent {
public:
  FrameAgent(const std::string& address, const KeyPair& own = {},
             const std::string& server_key = {})
      : socket_(context_, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 10'000);
    if (!server_key.empty()) {
      socket_.set(zmq::sockopt::curve_serverkey, server_key);
      socket_.set(zmq::sockopt::curve_publickey, own.public_key);
      socket_.set(zmq::sockopt::curve_secretkey, own.secret_key);
    }
    socket_.connect(address);
  }

  void say(const std::string& line) {
    LineReader reader;
    reader.add(line + '\n');
    say_frames(frames_of(**reader.next()).value());
  }
  // They need not be a message.
  void say_frames(const std::vector<std::string>& frames) {
    std::vector<zmq::const_buffer> parts;
    for (const auto& frame : frames)
      parts.push_back(zmq::buffer(frame));
    zmq::send_multipart(socket_, parts);
  }
  void say_packed(const std::string& lines) {
    socket_.send(zmq::buffer(lines), zmq::send_flags::none);
  }
  // As a line; what is packed as it is.
  std::string hear() {
    std::vector<zmq::message_t> frames;
    if (!zmq::recv_multipart(socket_, std::back_inserter(frames)))
      return "nothing";
    if (frames.size() == 1)
      return frames.front().to_string();
    std::vector<std::string_view> texts;
    for (const auto& frame : frames)
      texts.push_back(frame.to_string_view());
    auto line = line_of(read_frames(texts).value()).value();
    line.pop_back();
    return line;
  }

private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

class AgentServerTest : public testing::Test {
protected:
  void start(ServerOptions options) {
    options.accounts.push_back({"Robot", "", ""});
    if (!options.log)
      options.log = [this](const std::string& line) { log.note(line); };
    auto started = AgentServer::start(std::move(options));
    ASSERT_TRUE(started) << started.error().message;
    server = std::move(*started);
    server->attach("Robot", component);
  }
  static AgentMessage command(std::string what) {
    AgentMessage message;
    message.component = "Robot";
    message.command = std::move(what);
    return message;
  }

  Notes log;
  std::shared_ptr<NotingComponent> component =
      std::make_shared<NotingComponent>();
  std::unique_ptr<AgentServer> server;
};

} // namespace parlour::adapters::agents
