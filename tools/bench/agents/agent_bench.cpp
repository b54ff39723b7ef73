#include "tools/bench/agents/agent_bench.hpp"

#include <algorithm>
#include <functional>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/agents/agent_workload.hpp"
#include "tools/bench/agents/connected_agents.hpp"
#include "tools/bench/agents/microphones.hpp"
#include "tools/bench/agents/raw_tcp.hpp"
#include "tools/bench/agents/raw_zeromq.hpp"
#include "tools/bench/support/one_core.hpp"

namespace parlour::tools {

namespace {

constexpr ExchangeCount ours_count{500'000, 20'000};
constexpr ExchangeCount raw_tcp_count{4'000'000, 20'000};
constexpr ExchangeCount raw_zeromq_count{1'000'000, 20'000};
// A message of an agent has so many frames: the protocol, kind, time,
// component, command and one parameter.
constexpr int fields_as_frames = 6;

// The least share of the raw peer's messages, and the most of its time.
struct Bars {
  double one_way = 0;
  double round_trip = 0;
};

using Exchange = std::function<Expected<Exchanged>()>;

// One who exchanges messages, and all its runs.
struct Contestant {
  std::string title;
  Exchange run;
  std::vector<Exchanged> runs = {};
};

std::vector<double> figures(const Contestant& one, double Exchanged::*figure) {
  std::vector<double> all;
  for (const auto& run : one.runs)
    all.push_back(run.*figure);
  return all;
}

// Ours to theirs, run by run: both had the same load of the machine.
std::vector<double> ratios(const Contestant& ours, const Contestant& theirs,
                           double Exchanged::*figure) {
  auto all = figures(ours, figure);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] /= theirs.runs[i].*figure;
  return all;
}

// "0.72 (0.70 to 0.75)".
std::string spread(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", median(values), least, most);
}

std::string pace(const Contestant& one) {
  return fmt::format("{:.2f} M/s",
                     median(figures(one, &Exchanged::messages_per_second)) /
                         1e6);
}

std::string time(const Contestant& one) {
  return fmt::format("{:.1f} us (p99 {:.1f})",
                     median(figures(one, &Exchanged::median_microseconds)),
                     median(figures(one, &Exchanged::p99_microseconds)));
}

// The first of the raw peers is the one that the bars are for.
void print(const std::string& row, const std::vector<Contestant>& all,
           const Bars& bars, std::ostream& out) {
  const auto& ours = all[0];
  const auto share = ratios(ours, all[1], &Exchanged::messages_per_second);
  const auto longer = ratios(ours, all[1], &Exchanged::median_microseconds);
  out << fmt::format(
      "{} one way {}, of {} {}, bar {:.2f}: {}; round trip {}, to {} {}, bar "
      "{:.2f}: {}\n",
      row, pace(ours), all[1].title, spread(share), bars.one_way,
      median(share) >= bars.one_way ? "met" : "missed", time(ours),
      all[1].title, spread(longer), bars.round_trip,
      median(longer) <= bars.round_trip ? "met" : "missed");
  for (const auto& one : all)
    out << fmt::format("  {}: {}; {}\n", one.title, pace(one), time(one));
}

bool compete(const std::string& row, std::vector<Contestant> all,
             const Bars& bars, int runs, std::ostream& out) {
  const OneCore core;
  for (int run = 0; run < runs; ++run)
    for (auto& one : all) {
      auto exchanged = one.run();
      if (!exchanged) {
        out << fmt::format("{} {}: {}\n", row, one.title,
                           exchanged.error().message);
        return false;
      }
      one.runs.push_back(*exchanged);
    }
  print(row, all, bars, out);
  return true;
}

Exchange agents(AgentTransport transport) {
  return [=] { return agents_exchange(transport, ours_count); };
}

Exchange raw_zeromq(RawZeroMQ way) {
  return [=] { return raw_zeromq_exchange(way, raw_zeromq_count); };
}

bool lines_row(const BenchRows& wanted, std::ostream& out) {
  return compete("lines",
                 {{"agents", agents(AgentTransport::lines)},
                  {"TCP", [] { return raw_tcp_exchange(raw_tcp_count); }}},
                 {0.20, 1.50}, wanted.runs, out);
}

bool zeromq_row(const BenchRows& wanted, std::ostream& out) {
  return compete("zeromq",
                 {{"agents", agents(AgentTransport::zeromq)},
                  {"ZeroMQ", raw_zeromq({})},
                  {"ZeroMQ, a thread for each side", raw_zeromq({1, false})},
                  {"ZeroMQ, six frames", raw_zeromq({fields_as_frames, true})}},
                 {0.70, 1.40}, wanted.runs, out);
}

} // namespace

std::vector<std::string> agent_bench_rows() {
  return {"lines", "zeromq", "connected", "audio"};
}

bool agent_bench(const BenchRows& wanted, std::ostream& out) {
  out << fmt::format("Messages of {} bytes, all on one core, median of {} runs "
                     "(least to most)\n",
                     exchanged_bytes, wanted.runs);
  bool ok = true;
  // It starts a process of its own: while this one has a single thread.
  if (wanted.wants("connected"))
    ok &= connected_row(wanted, out);
  if (wanted.wants("lines"))
    ok &= lines_row(wanted, out);
  if (wanted.wants("zeromq"))
    ok &= zeromq_row(wanted, out);
  if (wanted.wants("audio"))
    ok &= audio_row(wanted, out);
  return ok;
}

} // namespace parlour::tools
