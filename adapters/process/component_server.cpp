#include "adapters/process/component_server.hpp"

#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <sys/prctl.h>
#include <unistd.h>

#include "adapters/process/ipc_values.hpp"
#include "adapters/process/remote_host.hpp"

namespace parlour::adapters {

namespace {

// Exit statuses.
constexpr int well = 0;
constexpr int wrong = 1;

// Runs the action. Returns the text of what it throws, or unknown if it does
// not.
template <class Action>
Value catch_to_string(Action&& action) {
  try {
    action();
    return {};
  } catch (const std::exception& exception) {
    return std::string(exception.what());
  } catch (...) {
    return "an exception of an unknown type";
  }
}

// Two threads: the plug-in is called on the one that runs run(), and another
// one reads the socket, so that answers to the plug-in's questions arrive, and
// the end of the connection is noticed, while the plug-in is at work.
class ComponentServer {
public:
  ComponentServer(int socket, const PluginFactory& factory)
      : socket_(socket), host_(socket_), factory_(factory) {}

  int run() {
    host_.say({IpcKind::hello, {ipc_protocol, factory_.description.name}});
    std::thread reader([this] { read_all(); });
    // Ends after the call `stop`. The reading thread ends when the other side
    // then closes the socket.
    while (!stopped_)
      carry_out(next_call());
    reader.join();
    return well;
  }

private:
  // -- the thread that reads --------------------------------------------------

  void read_all() {
    for (;;) {
      socket_.wait();
      auto messages = socket_.receive();
      if (!messages && stopped_)
        return;
      if (!messages)
        // The platform is gone, so nobody is left to stop the plug-in in an
        // orderly way.
        _exit(messages.error().kind == ErrorKind::offline ? well : wrong);
      for (auto& message : *messages)
        sort(std::move(message));
    }
  }

  // Answers go to the waiting question; everything else is a call.
  void sort(IpcMessage message) {
    if (message.kind == IpcKind::reply)
      return host_.answered(message);
    {
      std::lock_guard lock(mutex_);
      // The other side waits for `done`, so there is never more than one call.
      call_ = std::move(message);
    }
    called_.notify_one();
  }

  // -- the plug-in's thread ---------------------------------------------------

  IpcMessage next_call() {
    std::unique_lock lock(mutex_);
    called_.wait(lock, [this] { return call_.has_value(); });
    return *std::exchange(call_, {});
  }

  void carry_out(const IpcMessage& call) {
    host_.set_time(call.at(0).integer_or(0));
    Value outcome;
    switch (call.kind) {
    case IpcKind::start:
      outcome = start(call);
      break;
    case IpcKind::handle:
      outcome = catch_to_string([&] { handle(call); });
      break;
    case IpcKind::run:
      outcome = catch_to_string([&] { host_.run(call.at(1).integer_or(0)); });
      break;
    case IpcKind::answer:
      outcome = catch_to_string([&] { host_.react(call); });
      break;
    case IpcKind::stop:
      outcome = catch_to_string([&] { stop(); });
      stopped_ = true;
      break;
    // The other side speaks another protocol.
    default:
      _exit(wrong);
    }
    host_.say({IpcKind::done, {std::move(outcome)}});
  }

  // Returns the error of a failed start, or unknown.
  Value start(const IpcMessage& call) {
    Expected<void> outcome;
    auto thrown = catch_to_string([&] {
      plugin_ = factory_.create();
      const auto options = host_.begin(call);
      outcome = options ? plugin_->start(host_, *options)
                        : tl::make_unexpected(options.error());
    });
    if (!thrown.is_unknown())
      outcome = fail(ErrorKind::settings, thrown.text());
    return outcome ? Value() : to_value(outcome.error());
  }

  void handle(const IpcMessage& call) {
    if (const auto message = message_from(call.at(1)); message && plugin_)
      plugin_->receive(*message);
  }

  void stop() {
    if (plugin_)
      plugin_->stop();
    plugin_.reset();
  }

  IpcSocket socket_;
  RemoteHost host_;
  const PluginFactory& factory_;
  std::unique_ptr<IPlugin> plugin_;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable called_;
  std::optional<IpcMessage> call_;
};

} // namespace

int serve_component(int socket, const PluginFactory& plugin) {
  // A platform that is killed cannot end its components; the kernel does it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return ComponentServer(socket, plugin).run();
}

int refuse_component(int socket, const Error& error) {
  IpcSocket to(socket);
  (void)to.send({IpcKind::refuse, {to_value(error)}});
  return wrong;
}

} // namespace parlour::adapters
