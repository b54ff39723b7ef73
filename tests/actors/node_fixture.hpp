// NodeFixture: a node with a small application that the test writes in XML. The
// test starts it, enters user turns and looks at what is said, logged and
// inspected. For one thread.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/node/node.hpp"
#include "script/compiler/compiler.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::actors {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

inline constexpr Timestamp nine_o_clock = 1795251600000;

// A session that wants words of these is lost.
class ThrowingPhrases : public PhraseEvaluator {
public:
  Rendering render(const Value&) const override {
    throw std::runtime_error("broken");
  }
};
inline constexpr const char* loses_its_session = R"(
  <handler name="Loses"><messages><component>
    <Bell><Breaks><say act="broken"/></Breaks></Bell>
  </component></messages></handler>)";

// A handler that repeats what the user says, for tests about something else.
inline constexpr const char* echo = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <speak param="You said: {_LPARAM1}"/>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

inline std::shared_ptr<const script::Program>
compile(const std::string& elements, const std::string& settings = "",
        const std::string& start = "") {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings name=\"test\" start=\"" + start +
                                   "\">" + settings +
                                   "<Scripts><Script>test.xml</Script>"
                                   "</Scripts></settings>");
  folder.write("test.xml", "<dialogue>" + elements + "</dialogue>");
  auto compiled = script::compile_application(folder.path(), {});
  if (!compiled.program)
    for (const auto& finding : compiled.findings.all())
      ADD_FAILURE() << script::to_string(finding);
  return compiled.program;
}

// A plug-in whose on_message is a function of the test.
class FunctionPlugin : public IPlugin {
public:
  using Function = std::function<void(FunctionPlugin&, const Message&)>;
  explicit FunctionPlugin(Function function) : function_(std::move(function)) {}

  using IPlugin::answer;
  using IPlugin::ask;
  using IPlugin::fire_event;
  using IPlugin::host;
  using IPlugin::send_message;

protected:
  void on_message(const Message& message) override {
    function_(*this, message);
  }

private:
  Function function_;
};

// A component of that plug-in.
inline ComponentOrder component(std::string name, std::string role,
                                FunctionPlugin::Function function,
                                bool blocks = false) {
  ComponentOrder order;
  order.name = name;
  order.factory.description.name = std::move(name);
  order.factory.description.roles = {std::move(role)};
  order.factory.description.blocks = blocks;
  order.factory.create = [function = std::move(function)] {
    return std::make_unique<FunctionPlugin>(function);
  };
  return order;
}

// A component that answers each message with `event` and its parameters.
inline ComponentOrder answering(std::string name, std::string role,
                                std::string event) {
  return component(std::move(name), std::move(role),
                   [event](FunctionPlugin& self, const Message& message) {
                     self.fire_event(event, message.params);
                   });
}

// A plug-in that sessions call in their own turn.
class InlineFunctionPlugin : public InlinePlugin {
public:
  using Function = std::function<std::vector<Answer>(const Message&)>;
  explicit InlineFunctionPlugin(Function function)
      : function_(std::move(function)) {}
  std::vector<Answer> answers(const Message& message) const override {
    return function_(message);
  }

private:
  Function function_;
};

inline ComponentOrder
inline_component(std::string name, std::string role,
                 InlineFunctionPlugin::Function function) {
  auto order = component(std::move(name), std::move(role), {});
  order.factory.description.is_inline = true;
  order.factory.create = [function = std::move(function)] {
    return std::make_unique<InlineFunctionPlugin>(function);
  };
  return order;
}

class NodeFixture : public testing::Test {
protected:
  // Starts the node: in virtual time, unless the test has changed `options`.
  void start(const std::string& elements, const std::string& settings = "",
             const std::string& beginning = "") {
    options.program = compile(elements, settings, beginning);
    ASSERT_TRUE(options.program);
    options.on_inspection = [this](const Inspection& seen) {
      if (seen.kind == InspectionKind::message)
        ways.push_back(to_string(*seen.message) + " | " + seen.way);
      if (seen.kind == InspectionKind::error)
        errors.push_back(seen.detail);
      if (seen.kind == InspectionKind::unhandled)
        unhandled.push_back(seen.detail);
      if (watch)
        watch(seen);
    };
    options.log = [this](const std::string& line) { logs.push_back(line); };
    auto started = Node::start(std::move(options));
    ASSERT_TRUE(started) << to_string(started.error());
    node = std::move(*started);
    open_seat();
  }

  void open_seat() {
    SeatCallbacks calls;
    calls.on_output = [this](const auto&, const dialogue::Output& output) {
      std::lock_guard lock(mutex_);
      said_.push_back(output.text);
    };
    calls.on_session_end = [this](const auto&) { ++over; };
    seat = node->open_seat(std::move(calls));
  }

  // What the robot has said since the last call.
  std::vector<std::string> said() {
    std::lock_guard lock(mutex_);
    return std::exchange(said_, {});
  }

  std::vector<std::string> say(const std::vector<std::string>& lines) {
    node->enter(seat, lines);
    node->run_until_quiet();
    return said();
  }

  // The routes of the messages with this command.
  std::vector<std::string> ways_of(const std::string& command) const {
    std::vector<std::string> found;
    for (const auto& way : ways)
      if (way.find("." + command + "(") != std::string::npos)
        found.push_back(way);
    return found;
  }

  NodeOptions options = [] {
    NodeOptions result;
    result.virtual_start = nine_o_clock;
    result.seed = 1;
    return result;
  }();
  std::function<void(const Inspection&)> watch; // may be empty
  std::vector<std::string> ways;
  std::vector<std::string> logs;
  std::vector<std::string> unhandled; // why nobody took them
  std::vector<std::string> errors;
  std::atomic<int> over = 0;

private:
  std::mutex mutex_;
  std::vector<std::string> said_;

protected:
  SeatId seat;
  std::unique_ptr<Node> node; // last: it is destroyed first
};

} // namespace parlour::actors
