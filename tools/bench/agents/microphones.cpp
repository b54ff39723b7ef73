#include "tools/bench/agents/microphones.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <future>
#include <ostream>
#include <thread>

#include <fmt/format.h>

#include "tools/bench/agents/agent_workload.hpp"
#include "tools/bench/agents/bench_agent.hpp"
#include "tools/bench/support/one_core.hpp"

namespace parlour::tools {

namespace {

using namespace adapters::agents;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t microphones = 50;
// 16,000 samples a second of two bytes.
constexpr auto frame_lasts = 20ms;
constexpr std::size_t frame_bytes = 640;
constexpr auto format = "pcm_s16le;rate=16000;channels=1";
// At the end the audio may take that much longer than at the beginning: less
// than a frame, so that nothing collects.
constexpr double growth = 20.0; // milliseconds

// What stands at the beginning of a frame's bytes.
struct Stamp {
  std::uint64_t number = 0;
  Clock::time_point sent;
};

// The platform's side of all microphones.
class Recorder {
public:
  // Called on the server's thread.
  void take(std::size_t microphone, const AgentMessage& message) {
    Stamp stamp;
    if (!message.payload || message.payload->bytes.size() != frame_bytes)
      return;
    std::memcpy(&stamp, message.payload->bytes.data(), sizeof stamp);
    if (stamp.number != next_[microphone]++)
      ++out_of_order_;
    delays_.push_back(
        std::chrono::duration<double, std::milli>(Clock::now() - stamp.sent)
            .count());
    ++count_;
  }
  std::size_t count() const {
    return count_;
  }
  // The following once nothing arrives any more.
  std::size_t out_of_order() const {
    return out_of_order_;
  }
  const std::vector<double>& delays() const {
    return delays_;
  }

private:
  std::vector<std::uint64_t> next_ = std::vector<std::uint64_t>(microphones);
  // In the order of arrival, in milliseconds.
  std::vector<double> delays_;
  std::size_t out_of_order_ = 0;
  std::atomic<std::size_t> count_ = 0;
};

AgentMessage audio_frame(std::uint64_t number) {
  AgentMessage message;
  message.kind = MessageKind::binary;
  message.command = "Audio";
  message.payload = Payload{format, std::string(frame_bytes, '\x55'), {}};
  const Stamp stamp{number, Clock::now()};
  std::memcpy(message.payload->bytes.data(), &stamp, sizeof stamp);
  return message;
}

// Sends one frame of each microphone in turn, so that they are spread over the
// time that a frame lasts. Returns how many were not taken.
std::size_t speak(std::vector<BenchAgent>& agents, std::size_t rounds) {
  std::size_t refused = 0;
  auto due = Clock::now();
  for (std::size_t round = 0; round < rounds; ++round)
    for (auto& agent : agents) {
      std::this_thread::sleep_until(due);
      if (!agent.connection().send(audio_frame(round)))
        ++refused;
      due += frame_lasts / microphones;
    }
  return refused;
}

struct Delay {
  double middle = 0;
  double p99 = 0;
  double most = 0;
};

Delay delay_of(std::vector<double> delays) {
  if (delays.empty())
    return {};
  std::ranges::sort(delays);
  return {delays[delays.size() / 2], delays[delays.size() * 99 / 100],
          delays.back()};
}

std::string text_of(const Delay& delay) {
  return fmt::format("{:.2f} ms (p99 {:.2f}, most {:.2f})", delay.middle,
                     delay.p99, delay.most);
}

void print(AgentTransport transport, const Recorder& recorder, std::size_t sent,
           int seconds, std::ostream& out) {
  const auto& all = recorder.delays();
  const auto tenth = static_cast<std::ptrdiff_t>(all.size() / 10);
  const auto first = delay_of({all.begin(), all.begin() + tenth});
  const auto last = delay_of({all.end() - tenth, all.end()});
  const auto lost = sent - recorder.count() + recorder.out_of_order();
  const bool grows = last.middle > first.middle + growth;
  out << fmt::format("audio by {}: {} microphones, {} s, {} frames of {} "
                     "bytes; lost {}; delay in the first tenth {}, in the last "
                     "{}; bar: nothing lost, no longer delay: {}\n",
                     name_of(transport), microphones, seconds, sent,
                     frame_bytes, lost, text_of(first), text_of(last),
                     lost == 0 && !grows ? "met" : "missed");
}

Expected<void> measure(AgentTransport transport, int seconds,
                       std::ostream& out) {
  const OneCore core;
  Recorder recorder;
  auto server = start_bench_server(transport, microphones);
  if (!server)
    return tl::make_unexpected(server.error());
  std::vector<BenchAgent> agents;
  for (std::size_t i = 0; i < microphones; ++i) {
    auto agent =
        BenchAgent::connect(**server, transport, bench_agent_name(i),
                            [&recorder, i](const AgentMessage& message) {
                              recorder.take(i, message);
                            });
    if (!agent)
      return tl::make_unexpected(agent.error());
    agents.push_back(std::move(*agent));
  }
  const auto rounds = static_cast<std::size_t>(seconds * (1s / frame_lasts));
  const auto refused = speak(agents, rounds);
  const auto sent = rounds * microphones;
  const auto patience = Clock::now() + 10s;
  while (recorder.count() + refused < sent && Clock::now() < patience)
    std::this_thread::sleep_for(10ms);
  agents.clear();
  server->reset(); // nothing arrives any more
  print(transport, recorder, sent, seconds, out);
  return {};
}

} // namespace

bool audio_row(const BenchRows& wanted, std::ostream& out) {
  for (const auto transport : {AgentTransport::lines, AgentTransport::zeromq})
    if (auto measured = measure(transport, wanted.seconds, out); !measured) {
      out << "audio " << measured.error().message << '\n';
      return false;
    }
  return true;
}

} // namespace parlour::tools
