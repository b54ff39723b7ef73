#include "tools/bench/components/component_workload.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "actors/node/node.hpp"

namespace parlour::tools {

namespace {

// How many throws are left; both players count it down.
using Left = std::shared_ptr<std::atomic<int>>;

// Throws each ball back until no throws are left.
class Player : public IPlugin {
public:
  Player(std::string other, Left left)
      : other_(std::move(other)), left_(std::move(left)) {}

protected:
  void on_message(const Message& message) override {
    if (left_->fetch_sub(1) <= 1)
      return;
    Message ball;
    ball.session = message.session;
    ball.command = message.command;
    ball.params = message.params;
    ball.sinks = {other_};
    send_message(std::move(ball));
  }

private:
  const std::string other_;
  const Left left_;
};

actors::ComponentOrder player(std::string name, std::string other, Left left) {
  PluginFactory factory;
  factory.description.name = "Player";
  factory.create = [other = std::move(other), left = std::move(left)] {
    return std::make_unique<Player>(other, left);
  };
  return {std::move(name), std::move(factory), {}};
}

} // namespace

Expected<Measured> components_play(const BallGame& game) {
  auto left = std::make_shared<std::atomic<int>>(game.throws);
  actors::NodeOptions options;
  options.program = std::make_shared<const script::Program>();
  options.components = {player("Ann", "Bob", left), player("Bob", "Ann", left)};
  options.threads = 1;
  auto node = actors::Node::start(std::move(options));
  if (!node)
    return tl::make_unexpected(node.error());
  const auto before = cpu_nanoseconds();
  for (int ball = 0; ball < game.balls; ++ball) {
    Message message;
    // Each ball is injected into a session of its own.
    message.source = "Script";
    message.command = "Ball";
    message.params = {"a ball"};
    message.sinks = {"Ann"};
    (*node)->inject(fmt::format("ball {}", ball + 1), std::move(message));
  }
  (*node)->run_until_quiet();
  const auto time = cpu_nanoseconds() - before;
  // A lost message would make the figure look better than it is.
  if (*left > 0)
    return fail(ErrorKind::thrown, "a ball was lost");
  return Measured{time / game.throws, "all thrown"};
}

} // namespace parlour::tools
