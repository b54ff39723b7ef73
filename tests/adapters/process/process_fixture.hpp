// ProcessTest: plug-ins that run in a child process, and a host that any thread
// may use.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/process/process_plugin.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A time limit for busy machines; a test that passes never waits so long.
inline constexpr Milliseconds patience{60'000};

class PatientHost : public test::FakePluginHost {
public:
  void fire_event(Message event) override {
    add([&] { events.push_back(std::move(event)); });
  }
  void failed(const std::string& reason) override {
    add([&] { failures.push_back(reason); });
  }

  void log(const std::string& text) override {
    add([&] { logs.push_back(text); }); // what a process prints, by its thread
  }

  // Counted, as whoever has asked is started anew when the scripts change.
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    ++readings;
    return test::FakePluginHost::understanding();
  }

  mutable std::atomic<int> readings = 0;

  // Blocks until there are so many events and failures together.
  bool wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] {
      return events.size() + failures.size() >= count;
    });
  }

private:
  template <class Action>
  void add(Action action) {
    {
      std::lock_guard lock(mutex_);
      action();
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
};

// The program trial_component (tests/support/component).
inline ProcessOrder trial() {
  ProcessOrder order;
  order.program = std::filesystem::path(test::program_path()).parent_path() /
                  "trial_component";
  order.start_within = order.answer_within = order.stop_within = patience;
  return order;
}

// A shell script as the child process; descriptor 3 is the socket.
inline ProcessOrder shell(const std::string& script) {
  auto order = trial();
  order.program = "/bin/sh";
  order.arguments = {"-c", script};
  return order;
}

inline std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator("/proc/self/fd"))
    ++count;
  return count;
}

class ProcessTest : public testing::Test {
protected:
  std::unique_ptr<IPlugin> make(ProcessOrder order) {
    PluginDescription description;
    description.name = "Trial";
    return out_of_process(description, std::move(order)).create();
  }
  void start(ProcessOrder order = trial(), const Options& options = {}) {
    plugin = make(std::move(order));
    const auto started = plugin->start(host, options);
    ASSERT_TRUE(started) << started.error().message;
  }
  // Why it does not start; empty if it does.
  std::string trouble(ProcessOrder order, const Options& options = {}) {
    const auto made = make(std::move(order));
    const auto started = made->start(host, options);
    return started ? "" : to_string(started.error());
  }
  void send(std::string command, std::vector<Value> params = {}) {
    plugin->receive(test::message(std::move(command), std::move(params)));
  }
  // The text of the exception that sending the command throws.
  std::string thrown(const std::string& command) {
    try {
      send(command);
      return "";
    } catch (const std::exception& exception) {
      return exception.what();
    }
  }

  PatientHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::adapters
