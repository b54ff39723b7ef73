#include "tools/bench/platform/platform_bench.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/platform/visitors.hpp"
#include "tools/bench/support/measure.hpp"
#include "tools/parlour/application/opening.hpp"

namespace parlour::tools {

namespace {

using namespace std::chrono_literals;

// Microseconds for each of `count`.
double each(double nanoseconds, std::size_t count) {
  return nanoseconds / 1'000 / static_cast<double>(count);
}

std::string verdict(bool is_met, const std::string& bar) {
  return fmt::format("bar {}: {}", bar, is_met ? "met" : "missed");
}

// The first tenth opens beside few others, the last beside many: where opening
// one takes the longer the more there are, the two differ.
void measure_opening(Visitors& visitors, std::size_t sessions,
                     std::ostream& out) {
  const auto tenth = std::max<std::size_t>(sessions / 10, 1);
  const auto memory = bytes_in_use();
  const auto begin = cpu_nanoseconds();
  visitors.open(tenth);
  const auto first = each(cpu_nanoseconds() - begin, tenth);
  visitors.open(sessions - 2 * tenth);
  const auto middle = cpu_nanoseconds();
  visitors.open(tenth);
  const auto last = each(cpu_nanoseconds() - middle, tenth);
  const auto kibibytes = static_cast<double>(bytes_in_use() - memory) / 1'024 /
                         static_cast<double>(visitors.count());
  out << fmt::format(
      "open      {:.1f} µs for each of the first {}, {:.1f} µs for each of the "
      "last ({:.2f} times as long, {}); {:.0f} a second, {}\n",
      first, tenth, last, last / first, verdict(last / first <= 1.3, "1.30"),
      1e6 / last, verdict(1e6 / last >= 50'000, "50,000"));
  out << fmt::format("memory    {:.1f} KiB for each of {} that wait, {}\n",
                     kibibytes, visitors.count(), verdict(kibibytes <= 8, "8"));
}

// The receptionist with more patience, as a server of texts has: who says
// nothing for a minute rests, and nobody is said goodbye to.
Application patient(Application application) {
  auto program = std::make_shared<script::Program>(*application.program);
  program->settings.sessions.rest_after = 1min;
  program->settings.sessions.closes_after = 24h;
  application.program = std::move(program);
  return application;
}

// False if who came back was answered otherwise than the first.
bool measure_rest(const Application& application, std::size_t sessions,
                  const Console& console) {
  auto visitors = Visitors::arrive(patient(application));
  if (!visitors) {
    say_error(console, visitors.error().message);
    return false;
  }
  const auto memory = bytes_in_use();
  visitors->open(sessions);
  // Virtual time jumps: each step lets some of them rest.
  for (std::size_t waited = 0; waited < 100 + sessions / 100; ++waited)
    visitors->wait(1min);
  const auto kibibytes = static_cast<double>(bytes_in_use() - memory) / 1'024 /
                         static_cast<double>(sessions);
  const auto begin = cpu_nanoseconds();
  visitors->say({"Thank you."});
  const auto first = each(cpu_nanoseconds() - begin, sessions);
  const auto middle = cpu_nanoseconds();
  visitors->say({"Thank you."});
  const auto second = each(cpu_nanoseconds() - middle, sessions);
  console.out << fmt::format(
      "rest      {:.1f} KiB for each of {} at rest, {}; the turn that brings "
      "one back takes {:.1f} µs, the next {:.1f}\n",
      kibibytes, sessions, verdict(kibibytes <= 2, "2"), first, second);
  return visitors->misled() == 0;
}

// Peers, measured on such a machine: RiveScript 27,000 a second, the Bot
// Framework's state 4,600.
void measure_turns(Visitors& visitors, const std::string& row,
                   const std::vector<std::vector<std::string>>& script,
                   double bar, std::ostream& out) {
  std::size_t turns = 0;
  const auto begin = cpu_nanoseconds();
  for (const auto& said : script) {
    visitors.say(said);
    turns += said.size() * visitors.count();
  }
  const auto rate = 1e6 / each(cpu_nanoseconds() - begin, turns);
  out << fmt::format("{:<9} {} turns a second with {} open, {}; {} were told "
                     "something else than the first\n",
                     row, static_cast<long>(rate), visitors.count(),
                     verdict(rate >= bar, fmt::format("{:.0f}", bar)),
                     visitors.misled());
}

} // namespace

std::vector<std::string> platform_bench_rows() {
  return {"open", "turns", "table", "rest"};
}

bool platform_bench(const Places& places, const PlatformBenchOptions& options,
                    const Console& console) {
  auto opened = open_application(places, "receptionist", console);
  if (std::holds_alternative<int>(opened))
    return false;
  const auto& application = std::get<Application>(opened);
  const auto wants = [&](const char* row) {
    return options.only.empty() || options.only == row;
  };
  if (wants("rest") && !measure_rest(application, options.sessions, console))
    return false;
  if (options.only == "rest")
    return true;
  auto visitors = Visitors::arrive(application);
  if (!visitors) {
    say_error(console, visitors.error().message);
    return false;
  }
  if (wants("open"))
    measure_opening(*visitors, options.sessions, console.out);
  else
    visitors->open(options.sessions);
  // Understood by grammar, answered without a database.
  if (wants("turns"))
    measure_turns(*visitors, "turns", {{"What can you do?"}, {"Thank you."}},
                  50'000, console.out);
  // The conversation of the paper's Table I, with its database.
  if (wants("table"))
    measure_turns(*visitors, "table",
                  {{"I am David from Comptec to meet Dr. Jeffery Ho.",
                    "By the way, is there any coffee shop on this second "
                    "floor?"},
                   {"How about food court?"},
                   {"10:30am."}},
                  20'000, console.out);
  return visitors->misled() == 0;
}

} // namespace parlour::tools
