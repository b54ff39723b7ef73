#include "adapters/process/component_server.hpp"

#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <sys/prctl.h>
#include <unistd.h>

#include "adapters/process/frame_values.hpp"
#include "adapters/process/remote_host.hpp"

namespace parlour::adapters {

namespace {

constexpr int well = 0;
constexpr int wrong = 1;

// What the action throws, in words; else unknown.
template <class Action>
Value thrown_by(Action&& action) {
  try {
    action();
    return {};
  } catch (const std::exception& exception) {
    return std::string(exception.what());
  } catch (...) {
    return "an exception of an unknown type";
  }
}

// The plug-in is called on the thread that makes this; another one reads, so
// that answers come, and the end, while the plug-in is at work.
class ComponentServer {
public:
  ComponentServer(int socket, const PluginFactory& factory)
      : socket_(socket), host_(socket_), factory_(factory) {}

  int run() {
    host_.say({FrameKind::hello, {frame_protocol, factory_.description.name}});
    std::thread reader([this] { read_all(); });
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
      auto frames = socket_.receive();
      if (!frames && stopped_)
        return;
      if (!frames) // nobody is there any more
        _exit(frames.error().kind == ErrorKind::offline ? well : wrong);
      for (auto& frame : *frames)
        sort(std::move(frame));
    }
  }

  void sort(Frame frame) {
    if (frame.kind == FrameKind::reply)
      return host_.answered(frame);
    {
      std::lock_guard lock(mutex_);
      call_ = std::move(frame); // there is never more than one
    }
    called_.notify_one();
  }

  // -- the plug-in's thread ---------------------------------------------------

  Frame next_call() {
    std::unique_lock lock(mutex_);
    called_.wait(lock, [this] { return call_.has_value(); });
    return *std::exchange(call_, {});
  }

  void carry_out(const Frame& call) {
    host_.set_time(call.at(0).integer_or(0));
    Value outcome;
    switch (call.kind) {
    case FrameKind::start:
      outcome = start(call);
      break;
    case FrameKind::handle:
      outcome = thrown_by([&] { handle(call); });
      break;
    case FrameKind::run:
      outcome = thrown_by([&] { host_.run(call.at(1).integer_or(0)); });
      break;
    case FrameKind::answer:
      outcome = thrown_by([&] { host_.react(call); });
      break;
    case FrameKind::stop:
      outcome = thrown_by([&] { stop(); });
      stopped_ = true;
      break;
    default:
      _exit(wrong);
    }
    host_.say({FrameKind::done, {std::move(outcome)}});
  }

  Value start(const Frame& call) {
    Expected<void> outcome;
    auto thrown = thrown_by([&] {
      plugin_ = factory_.create();
      const auto options = host_.begin(call);
      outcome = options ? plugin_->start(host_, *options)
                        : tl::make_unexpected(options.error());
    });
    if (!thrown.is_unknown())
      outcome = fail(ErrorKind::settings, thrown.text());
    return outcome ? Value() : to_value(outcome.error());
  }

  void handle(const Frame& call) {
    if (const auto message = message_from(call.at(1)); message && plugin_)
      plugin_->receive(*message);
  }

  void stop() {
    if (plugin_)
      plugin_->stop();
    plugin_.reset();
  }

  FrameSocket socket_;
  RemoteHost host_;
  const PluginFactory& factory_;
  std::unique_ptr<IPlugin> plugin_;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable called_;
  std::optional<Frame> call_;
};

} // namespace

int serve_component(int socket, const PluginFactory& plugin) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return ComponentServer(socket, plugin).run();
}

int refuse_component(int socket, const Error& error) {
  FrameSocket to(socket);
  (void)to.send({FrameKind::refuse, {to_value(error)}});
  return wrong;
}

} // namespace parlour::adapters
