#include "tools/bench/nlu_bench.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "adapters/nlu/understander.hpp"
#include "tools/bench/measure.hpp"
#include "tools/bench/name_trial.hpp"
#include "tools/bench/nlu_data.hpp"

namespace parlour::tools {

namespace {

using adapters::nlu::Understander;
using adapters::nlu::Understanding;

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

const char* met(bool well) {
  return well ? "met" : "missed";
}

std::string at_least(double figure, double bar, const char* unit = " %") {
  return fmt::format("{:.1f}{} (bar {:g}: {})", figure, unit, bar,
                     met(figure >= bar));
}

std::string at_most(double figure, double bar, const char* unit) {
  return fmt::format("{:.1f}{} (bar {:g}: {})", figure, unit, bar,
                     met(figure <= bar));
}

// One understander and what it took to make it.
struct Trained {
  Understander understander;
  double milliseconds = 0;
  double mebibytes = 0;
};

Expected<Trained> train(const UnderstandingModel& model,
                        const ColumnReader& columns,
                        Understander::Options options) {
  const auto bytes = bytes_in_use();
  const auto start = cpu_nanoseconds();
  auto built = Understander::build(model, columns, std::move(options));
  const auto taken = cpu_nanoseconds() - start;
  if (!built)
    return tl::make_unexpected(built.error().front());
  const auto more = bytes_in_use() - std::min(bytes, bytes_in_use());
  return Trained{std::move(*built), taken / 1e6, double(more) / (1 << 20)};
}

// How many slots were found as they should be.
struct SlotCount {
  std::size_t wanted = 0;
  std::size_t found = 0;
  std::size_t right = 0;

  void add(const NluText& text, const Understanding& made) {
    wanted += text.slots.size();
    const auto slots = made.acts.empty() ? Value() : made.acts[0]["slots"];
    if (!slots.if_map())
      return;
    for (const auto& [name, slot] : slots.if_map()->entries()) {
      ++found;
      right += std::ranges::count(text.slots,
                                  std::pair(name, slot["value"].text())) > 0
                   ? 1U
                   : 0U;
    }
  }

  double f1() const {
    return percent(2 * right, wanted + found);
  }
};

// Everything is taken for what it is likeliest about: the threshold is none.
struct DataTrial {
  std::size_t asked = 0; // about a topic
  std::size_t right = 0;
  SlotCount slots;
  std::vector<double> scores;    // of texts about a topic
  std::vector<double> strangers; // of the others
  double seconds = 0;

  DataTrial(const NluData& data, const Understander& understander) {
    const auto start = cpu_nanoseconds();
    for (const auto& text : data.texts)
      add(text, understander.understand(text.text));
    seconds = (cpu_nanoseconds() - start) / 1e9;
  }

  // Of 100 strangers so many have a lower score than 95 of 100 others.
  double rejected() {
    std::ranges::sort(scores);
    const auto limit = scores.empty() ? 0 : scores[scores.size() / 20];
    return percent(static_cast<std::size_t>(std::ranges::count_if(
                       strangers, [&](double one) { return one < limit; })),
                   strangers.size());
  }

private:
  void add(const NluText& text, const Understanding& made) {
    if (text.topic.empty()) {
      strangers.push_back(made.score);
      return;
    }
    ++asked;
    scores.push_back(made.score);
    slots.add(text, made);
    right += !made.acts.empty() && made.acts[0]["topic"].text() == text.topic
                 ? 1U
                 : 0U;
  }
};

using Read = Expected<NluData> (*)(const std::filesystem::path&);

bool data_row(const char* name, Read read, double bar,
              const NluBenchOptions& options, std::ostream& out) {
  if (options.data.empty()) {
    out << fmt::format("{:<12} not measured: --data names no folder\n", name);
    return true;
  }
  const auto data = read(options.data);
  const auto trained = data.and_then([](const auto& one) {
    return train(one.model, {}, {0, {}});
  });
  if (!trained) {
    out << fmt::format("{:<12} {}\n", name, to_string(trained.error()));
    return false;
  }
  DataTrial trial(*data, trained->understander);
  out << fmt::format("{:<12} intent {}", name,
                     at_least(percent(trial.right, trial.asked), bar));
  if (trial.slots.wanted > 0)
    out << fmt::format(", slot F1 {}", at_least(trial.slots.f1(), 91));
  if (!trial.strangers.empty())
    out << fmt::format(", strangers rejected where 95 % are accepted {:.1f} %",
                       trial.rejected());
  out << fmt::format("; trained in {:.1f} s, {:.0f} MiB, {:.0f} texts/s\n",
                     trained->milliseconds / 1000, trained->mebibytes,
                     double(data->texts.size()) / trial.seconds);
  return true;
}

// What was understood of a name, as a person would say it.
const char* const before_names = "I am here to meet ";

struct Heard {
  bool accepted = false;
  std::string value; // "" where several fit
};

Heard hear(const Understander& understander, const std::string& said) {
  const auto made = understander.understand(before_names + said);
  const auto host = made.acts.empty() ? Value() : made.acts[0]["slots"]["Host"];
  if (!host.if_map() || host["unmatched"])
    return {};
  return {true, host["value"].text()};
}

bool names_row(const NluApplication& application, std::ostream& out) {
  UnderstandingModel model;
  model.topics = {{"Visit",
                   false,
                   {{"Host", "query", {}, "db:people.name", true, false}},
                   {}}};
  model.grammars = {
      {"visit", "public <meet> = to meet @Visit.Host;", {"bench", 1, 1}}};
  const auto trained =
      train(model,
            [&](const std::string&) {
              return Expected<std::vector<std::string>>(application.names);
            },
            {0.4, {}});
  if (!trained) {
    out << "names        " << to_string(trained.error()) << '\n';
    return false;
  }
  std::size_t right = 0, accepted = 0, strangers = 0;
  const auto trials = name_trials(application.names);
  for (const auto& trial : trials) {
    const auto heard = hear(trained->understander, trial.said);
    accepted += heard.accepted ? 1U : 0U;
    right += heard.value == trial.meant ? 1U : 0U;
  }
  const auto others = stranger_trials(application.names);
  for (const auto& trial : others)
    strangers += hear(trained->understander, trial.said).accepted ? 1U : 0U;
  out << fmt::format("names        of {} said in another order, in part or "
                     "misspelt, right {}, "
                     "accepted {}; strangers accepted {}\n",
                     trials.size(),
                     at_least(percent(right, trials.size()), 97.5),
                     at_least(percent(accepted, trials.size()), 90),
                     at_most(percent(strangers, others.size()), 2, " %"));
  return true;
}

constexpr std::size_t speed_rounds = 5;

bool application_row(const NluApplication& application, std::ostream& out) {
  // Once to have its columns read, and once to be measured.
  if (const auto first = train(application.model, application.columns,
                               {0.4, application.generic});
      !first) {
    out << "application  " << to_string(first.error()) << '\n';
    return false;
  }
  const auto trained =
      train(application.model, application.columns, {0.4, application.generic});
  if (!trained || application.said.empty()) {
    out << "application  nothing was said to it\n";
    return false;
  }
  std::size_t understood = 0;
  const auto start = cpu_nanoseconds();
  for (std::size_t round = 0; round < speed_rounds; ++round)
    for (const auto& text : application.said)
      understood +=
          trained->understander.understand(text).acts.empty() ? 0U : 1U;
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
  return {"clinc", "snips", "names", "application"};
}

bool nlu_bench(const NluBenchOptions& options,
               const NluApplication& application, std::ostream& out) {
  const auto wanted = [&](const char* row) {
    return options.only.empty() || options.only == row;
  };
  bool well = true;
  if (wanted("clinc"))
    well &= data_row("clinc", read_clinc, 91, options, out);
  if (wanted("snips"))
    well &= data_row("snips", read_snips, 98, options, out);
  if (wanted("names"))
    well &= names_row(application, out);
  if (wanted("application"))
    well &= application_row(application, out);
  return well;
}

} // namespace parlour::tools
