// The peer of component_workload.cpp: the same game, played by typed actors of
// CAF without components, message centre or supervision.
#include <atomic>
#include <future>
#include <map>
#include <string>
#include <utility>

#include <caf/all.hpp>

#include "runtime/message/message.hpp"
#include "tools/bench/components/component_workload.hpp"

namespace parlour::tools {

// A message as CAF sends it. It never leaves the process, so it needs no
// serialization.
struct ball {
  Message message;
};

} // namespace parlour::tools

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(parlour::tools::ball)

namespace parlour::tools {

namespace {

using catcher_actor = caf::typed_actor<caf::reacts_to<ball>>;

// What all players share.
struct Field {
  Way way = Way::hub;
  // Throws that are still to come; `over` is fulfilled when there are none.
  std::atomic<int> left = 0;
  std::promise<void> over;
  // Complete before the first throw, then only read.
  std::map<std::string, catcher_actor> players;
  catcher_actor hub;
};

// Catches a ball and throws it on. The message is built anew, as a plug-in
// would do.
void catch_ball(catcher_actor::pointer self, Field* field,
                const std::string& other, const Message& caught) {
  const auto left = field->left.fetch_sub(1);
  if (left == 1)
    field->over.set_value();
  if (left <= 1)
    return;
  Message message;
  message.command = caught.command;
  message.params = caught.params;
  message.sinks = {other};
  self->send(field->way == Way::hub ? field->hub : field->players.at(other),
             ball{std::move(message)});
}

catcher_actor::behavior_type player(catcher_actor::pointer self, Field* field,
                                    const std::string& other) {
  return {
      [=](const ball& what) { catch_ball(self, field, other, what.message); }};
}

// Finds the receiver by name, which is what the message centre does.
catcher_actor::behavior_type hub(catcher_actor::pointer self, Field* field) {
  return {[=](const ball& what) {
    for (const auto& sink : what.message.sinks)
      self->send(field->players.at(sink), what);
  }};
}

void throw_balls(const Field& field, int balls) {
  for (int i = 0; i < balls; ++i) {
    Message message;
    message.command = "Ball";
    message.params = {"a ball"};
    message.sinks = {"Ann"};
    caf::anon_send(field.players.at("Ann"), ball{std::move(message)});
  }
}

} // namespace

Measured bare_actors_play(const BallGame& game, Way way) {
  caf::actor_system_config config;
  // One thread, so that CPU time is not spent on handing work between threads.
  config.set("scheduler.max-threads", std::size_t{1});
  config.set("scheduler.max-throughput", std::size_t{300});
  Field field;
  field.way = way;
  field.left = game.throws;
  caf::actor_system system(config);
  field.players["Ann"] = system.spawn(player, &field, "Bob");
  field.players["Bob"] = system.spawn(player, &field, "Ann");
  field.hub = system.spawn(hub, &field);
  const auto before = cpu_nanoseconds();
  throw_balls(field, game.balls);
  field.over.get_future().wait();
  const auto time = cpu_nanoseconds() - before;
  for (const auto& [name, actor] : field.players)
    caf::anon_send_exit(actor, caf::exit_reason::user_shutdown);
  caf::anon_send_exit(field.hub, caf::exit_reason::user_shutdown);
  system.await_all_actors_done();
  return {time / game.throws, "all thrown"};
}

} // namespace parlour::tools
