// Each row builds an engine for its own data and prints one line. The bars are
// those of docs/benchmarks.md.
#include "tools/bench/nlu/nlu_bench.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "runtime/base/clock.hpp"
#include "tools/bench/nlu/data_rows.hpp"
#include "tools/bench/nlu/data_trial.hpp"
#include "tools/bench/nlu/figures.hpp"
#include "tools/bench/nlu/frame_trial.hpp"
#include "tools/bench/nlu/name_trial.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

namespace {

using adapters::nlu::NluEngine;
using adapters::nlu::Understanding;

// Names are said within a sentence.
const char* const before_names = "I am here to meet ";

struct Heard {
  bool accepted = false;
  // Empty if several names fit.
  std::string value;
};

// Says a name to the engine.
Heard hear(const NluEngine& engine, const std::string& said) {
  const auto made = engine.understand(before_names + said);
  const auto host = made.acts.empty() ? Value() : made.acts[0]["slots"]["Host"];
  if (!host.if_map() || host["unmatched"])
    return {};
  return {true, host["value"].text()};
}

// Uses an application of one slot, so that only the names matter.
bool names_row(const NluApplication& application, std::ostream& out) {
  UnderstandingModel model;
  model.topics = {{"Visit",
                   false,
                   {{"Host", "query", {}, "db:people.name", true, false}},
                   {}}};
  model.grammars = {
      {"visit", "public <meet> = to meet @Visit.Host;", {"bench", 1, 1}}};
  const auto trained = train(
      model,
      [&](const std::string&) {
        return Expected<std::vector<std::string>>(application.names);
      },
      application.platform);
  if (!trained) {
    out << "names        " << to_string(trained.error()) << '\n';
    return false;
  }
  // A name is accepted if any value was found for it, and right if only the
  // value that was meant was found.
  std::size_t right = 0, accepted = 0, strangers = 0;
  const auto trials = name_trials(application.names);
  for (const auto& trial : trials) {
    const auto heard = hear(trained->engine, trial.said);
    accepted += heard.accepted ? 1U : 0U;
    right += heard.value == trial.meant ? 1U : 0U;
  }
  const auto others = stranger_trials(application.names);
  for (const auto& trial : others)
    strangers += hear(trained->engine, trial.said).accepted ? 1U : 0U;
  out << fmt::format("names        of {} said in another order, in part or "
                     "misspelt, right {}, "
                     "accepted {}; strangers accepted {}\n",
                     trials.size(),
                     at_least(percent(right, trials.size()), 97.5),
                     at_least(percent(accepted, trials.size()), 90),
                     at_most(percent(strangers, others.size()), 2, " %"));
  return true;
}

// Whether exactly one act was found, with the right topic and exactly the right
// slots.
bool is_right(const FrameTrial& trial, const Understanding& made) {
  if (made.acts.size() != 1 || made.acts[0]["topic"].text() != trial.topic)
    return false;
  const auto* slots = made.acts[0]["slots"].if_map();
  return (slots ? slots->size() : 0) == trial.slots.size() &&
         std::ranges::all_of(trial.slots, [&](const auto& slot) {
           return made.acts[0]["slots"][slot.first]["value"].text() ==
                  slot.second;
         });
}

// The share of sentences that were understood completely.
double frames_right(const NluEngine& engine,
                    const std::vector<FrameTrial>& trials) {
  const Map context{{"now", *parse_timestamp(frame_trial_time)}};
  const auto right = std::ranges::count_if(trials, [&](const auto& trial) {
    return is_right(trial, engine.understand(trial.said, context));
  });
  return percent(static_cast<std::size_t>(right), trials.size());
}

constexpr std::size_t frames_tried = 2000;

// The same sentences are measured as they are and misheard.
bool frames_row(const NluApplication& application, std::ostream& out) {
  const auto trained =
      train(application.model, application.columns, application.platform);
  const auto trials =
      frame_trials(application.model, application.columns, frames_tried);
  if (!trained || trials.empty()) {
    out << "frames       "
        << (trained ? "no grammar has a sentence" : to_string(trained.error()))
        << '\n';
    return false;
  }
  out << fmt::format(
      "frames       of {} sentences of its grammars, topic and "
      "all slots right {}, misheard {}\n",
      trials.size(), at_least(frames_right(trained->engine, trials), 90),
      at_least(frames_right(trained->engine, misheard(trials)), 80));
  return true;
}

// How often all texts are understood, so that the time is long enough to be
// measured.
constexpr std::size_t speed_rounds = 5;

// Measures the speed with what visitors have said.
bool application_row(const NluApplication& application, std::ostream& out) {
  // The first build reads the columns, the second one is measured.
  if (const auto first =
          train(application.model, application.columns, application.platform);
      !first) {
    out << "application  " << to_string(first.error()) << '\n';
    return false;
  }
  const auto trained =
      train(application.model, application.columns, application.platform);
  if (!trained || application.said.empty()) {
    out << "application  nothing was said to it\n";
    return false;
  }
  std::size_t understood = 0;
  const auto start = cpu_nanoseconds();
  for (std::size_t round = 0; round < speed_rounds; ++round)
    for (const auto& text : application.said)
      understood += trained->engine.understand(text).acts.empty() ? 0U : 1U;
  const auto seconds = (cpu_nanoseconds() - start) / 1e9;
  const auto count = application.said.size() * speed_rounds;
  out << fmt::format(
      "application  {} texts, {:.0f} % understood, {:.0f}/s (bar 20000: {}); "
      "loaded in {}, {}\n",
      application.said.size(), percent(understood, count),
      double(count) / seconds, met(double(count) / seconds >= 20'000),
      at_most(trained->milliseconds, 200, " ms"),
      at_most(trained->mebibytes, 64, " MiB"));
  return true;
}

} // namespace

std::vector<std::string> nlu_bench_rows() {
  auto rows = data_row_names();
  rows.insert(rows.end(), {"names", "frames", "application"});
  return rows;
}

bool nlu_bench(const NluBenchOptions& options,
               const NluApplication& application, std::ostream& out) {
  const auto wanted = [&](const std::string& row) {
    return options.only.empty() || options.only == row;
  };
  const DataRowOptions data{
      options.data, options.validation ? DataPart::validation : DataPart::test,
      application.platform};
  bool ok = true;
  for (const auto& row : data_row_names())
    if (wanted(row))
      ok &= data_row(row, data, out);
  if (wanted("names"))
    ok &= names_row(application, out);
  if (wanted("frames"))
    ok &= frames_row(application, out);
  if (wanted("application"))
    ok &= application_row(application, out);
  return ok;
}

} // namespace parlour::tools
