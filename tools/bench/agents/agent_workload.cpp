#include "tools/bench/agents/agent_workload.hpp"

#include <chrono>
#include <future>
#include <string>
#include <utility>

namespace parlour::tools {

namespace {

using namespace adapters::agents;
using Clock = std::chrono::steady_clock;

// Longer than any run may take.
constexpr std::chrono::seconds patience{60};

AgentMessage full_message() {
  AgentMessage message;
  message.command = "Seen";
  message.parameters.emplace_back(exchanged_bytes, 'x');
  return message;
}

// As the raw peers do, one message becomes the next.
AgentMessage with_text_of(AgentMessage&& message) {
  AgentMessage next;
  next.command = "Seen";
  next.parameters = std::move(message.parameters);
  return next;
}

// What the platform does with the agent's messages, on the server's thread.
class Counter {
public:
  Counter(AgentServer& server, const ExchangeCount& count)
      : server_(server), count_(count) {}

  void take(AgentMessage&& message) {
    if (message.parameters.size() != 1 ||
        message.parameters.front().size() != exchanged_bytes)
      return; // what has changed on its way counts as lost
    if (++received_ > count_.messages)
      note_answer(std::move(message));
    else if (received_ == count_.messages)
      all_came_.set_value();
  }

  bool wait_for_messages() {
    return all_came_.get_future().wait_for(patience) ==
           std::future_status::ready;
  }
  // Each answer makes it ask again.
  Expected<std::vector<double>> ask_and_wait() {
    ask(full_message());
    if (all_answered_.get_future().wait_for(patience) !=
        std::future_status::ready)
      return fail(ErrorKind::timeout, "an answer was lost");
    return std::move(times_);
  }

private:
  void ask(AgentMessage&& message) {
    asked_ = Clock::now();
    server_.send(bench_agent_name(0), std::move(message));
  }
  void note_answer(AgentMessage&& answer) {
    times_.push_back(
        std::chrono::duration<double, std::micro>(Clock::now() - asked_)
            .count());
    if (times_.size() == count_.round_trips)
      all_answered_.set_value();
    else
      ask(with_text_of(std::move(answer)));
  }

  AgentServer& server_;
  const ExchangeCount count_;
  std::size_t received_ = 0;
  std::promise<void> all_came_;
  std::promise<void> all_answered_;
  Clock::time_point asked_;
  std::vector<double> times_;
};

Expected<void> one_way(Exchanged& exchanged, AgentConnection& agent,
                       Counter& counter, std::size_t count) {
  const StopWatch watch(0);
  for (std::size_t sent = 0; sent < count;)
    if (agent.send(full_message()))
      ++sent;
    else if (!agent.wait_for_room(patience))
      return fail(ErrorKind::timeout, "nothing is acknowledged");
  if (!counter.wait_for_messages())
    return fail(ErrorKind::timeout, "a message was lost");
  set_one_way(exchanged, watch, count);
  return {};
}

} // namespace

Expected<Exchanged> agents_exchange(AgentTransport transport,
                                    const ExchangeCount& count) {
  auto server = start_bench_server(transport, 1);
  if (!server)
    return tl::make_unexpected(server.error());
  Counter counter(**server, count);
  AgentConnection* connection = nullptr;
  auto agent = BenchAgent::connect(
      **server, transport, bench_agent_name(0),
      [&](AgentMessage&& message) { counter.take(std::move(message)); },
      [&](AgentMessage&& message) {
        connection->send(with_text_of(std::move(message)));
      });
  if (!agent)
    return tl::make_unexpected(agent.error());
  connection = &agent->connection();
  Exchanged exchanged;
  if (auto measured = one_way(exchanged, *connection, counter, count.messages);
      !measured)
    return tl::make_unexpected(measured.error());
  auto times = counter.ask_and_wait();
  if (!times)
    return tl::make_unexpected(times.error());
  set_round_trips(exchanged, std::move(*times));
  return exchanged;
}

} // namespace parlour::tools
