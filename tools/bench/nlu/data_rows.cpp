#include "tools/bench/nlu/data_rows.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/nlu/data_trial.hpp"
#include "tools/bench/nlu/desk_data.hpp"
#include "tools/bench/nlu/figures.hpp"
#include "tools/bench/nlu/labelled_data.hpp"

namespace parlour::tools {

namespace {

struct Row {
  const char* name;
  Expected<NluSets> (*read)(const std::filesystem::path&, DataPart);
  // Bars in percent; 0: none.
  double intent = 0;
  double f1 = 0;
  double frames = 0;
  double rejected = 0;
};

constexpr Row rows[] = {
    {"clinc", read_clinc, 92.5, 0, 0, 85},
    {"clinc-10", read_ten_of_clinc},
    {"banking", read_banking, 92},
    {"banking-10", read_ten_of_banking, 77},
    {"hwu", read_hwu, 89.5},
    {"atis", read_atis, 95, 94.5},
    {"snips", read_snips, 98.4, 95},
    {"restaurants", read_restaurants, 0, 77.5},
    {"films", read_films, 0, 87},
    {"corpora", read_corpora, 93},
    {"desk", read_desk, 0, 0, 92},
};

// A figure with its bar, if it has one.
std::string figure(double made, double bar) {
  return bar > 0 ? at_least(made, bar) : fmt::format("{:.1f} %", made);
}

std::string text_of(const DataTrial& trial, const Row& row) {
  auto text = fmt::format("intent {}, nearest example {:.1f} %",
                          figure(percent(trial.right, trial.asked), row.intent),
                          percent(trial.nearest, trial.asked));
  if (trial.slots.wanted > 0)
    text +=
        fmt::format(", slot F1 {}, frames {}", figure(trial.slots.f1(), row.f1),
                    figure(percent(trial.frames, trial.asked), row.frames));
  if (trial.strangers > 0)
    text += fmt::format(
        ", strangers rejected {}",
        figure(percent(trial.rejected, trial.strangers), row.rejected));
  return text;
}

} // namespace

std::vector<std::string> data_row_names() {
  std::vector<std::string> names;
  for (const auto& row : rows)
    names.emplace_back(row.name);
  return names;
}

bool data_row(const std::string& name, const DataRowOptions& options,
              std::ostream& out) {
  const auto& row = *std::ranges::find(rows, name, &Row::name);
  const auto say = [&](const std::string& text) {
    out << fmt::format("{:<12} {}\n", name, text) << std::flush;
  };
  if (options.folder.empty()) {
    say("not measured: --data names no folder");
    return true;
  }
  const auto sets = row.read(options.folder, options.part);
  if (!sets) {
    say(to_string(sets.error()));
    return false;
  }
  DataTrial trial;
  double milliseconds = 0, mebibytes = 0;
  for (const auto& set : *sets) {
    const auto trained = train(set.model, set.columns, options.platform);
    if (!trained) {
      say(to_string(trained.error()));
      return false;
    }
    trial.add(set.texts, trained->engine, NearestExample(set.model));
    milliseconds += trained->milliseconds;
    mebibytes = std::max(mebibytes, trained->mebibytes);
  }
  say(fmt::format("{}; trained in {:.1f} s, {:.0f} MiB, {:.0f} texts/s",
                  text_of(trial, row), milliseconds / 1000, mebibytes,
                  double(trial.texts) / trial.seconds));
  return true;
}

} // namespace parlour::tools
