#include "tools/parlour/status/top_view.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

// "0.8 ms".
std::string time_text(std::optional<double> seconds) {
  if (!seconds)
    return "-";
  const auto ms = *seconds * 1e3;
  return ms < 10    ? fmt::format("{:.2f} ms", ms)
         : ms < 1e3 ? fmt::format("{:.0f} ms", ms)
                    : fmt::format("{:.1f} s", *seconds);
}

std::string rate_text(double each_second) {
  return each_second < 100 ? fmt::format("{:.1f}/s", each_second)
                           : fmt::format("{:.0f}/s", each_second);
}

std::string bytes_text(double bytes) {
  return bytes < 1e6 ? fmt::format("{:.0f} KB", bytes / 1e3)
                     : fmt::format("{:.0f} MB", bytes / 1e6);
}

std::string duration_text(double seconds) {
  const auto all = static_cast<std::uint64_t>(seconds);
  return fmt::format("{}:{:02}:{:02}", all / 3'600, all / 60 % 60, all % 60);
}

// Two reports of the same node.
class View {
public:
  View(const MetricsReport& now, const std::optional<MetricsReport>& before)
      : now_(now), before_(before),
        passed_(std::max(risen("parlour_uptime_seconds"), 1e-3)) {}

  std::string text() const {
    return heading() + sessions() + turns() + messages() + process() +
           journal() + components();
  }

private:
  using Labels = MetricSample::Labels;

  static const MetricSample* sample(const Metrics& all, const std::string& name,
                                    const std::string& label) {
    const auto* metric = find(all, name);
    if (!metric)
      return nullptr;
    for (const auto& one : metric->samples)
      if (label.empty() ||
          (!one.labels.empty() && one.labels.front().second == label))
        return &one;
    return nullptr;
  }
  bool has(const std::string& name) const {
    return find(now_.metrics, name) != nullptr;
  }
  double value(const std::string& name, const std::string& label = "") const {
    const auto* found = sample(now_.metrics, name, label);
    return found ? found->value : 0;
  }
  double risen(const std::string& name, const std::string& label = "") const {
    const auto* found =
        before_ ? sample(before_->metrics, name, label) : nullptr;
    return value(name, label) - (found ? found->value : 0);
  }
  std::string rate(const std::string& name,
                   const std::string& label = "") const {
    return rate_text(risen(name, label) / passed_);
  }
  std::string count(const std::string& name,
                    const std::string& label = "") const {
    return fmt::format("{:.0f}", value(name, label));
  }
  // "p50 0.8 ms, p99 3 ms".
  std::string times(const std::string& name) const {
    const auto* found = sample(now_.metrics, name, "");
    if (!found)
      return "-";
    const auto* earlier =
        before_ ? sample(before_->metrics, name, "") : nullptr;
    const auto time = earlier ? found->time.since(earlier->time) : found->time;
    return fmt::format("p50 {}, p99 {}", time_text(time.quantile(0.5)),
                       time_text(time.quantile(0.99)));
  }

  std::string heading() const {
    return fmt::format("{} (process {}, {}), up {}\n", now_.application,
                       now_.process, now_.folder,
                       duration_text(value("parlour_uptime_seconds")));
  }
  std::string sessions() const {
    auto text = fmt::format("sessions  {} open, {} opened, {} ended, {} lost",
                            count("parlour_sessions"),
                            rate("parlour_sessions_opened_total"),
                            rate("parlour_sessions_ended_total"),
                            count("parlour_sessions_lost_total"));
    if (value("parlour_sessions_recovered_total") > 0)
      text += ", " + count("parlour_sessions_recovered_total") + " recovered";
    if (has("parlour_sessions_refused_total"))
      text += fmt::format(", {} refused, {} connections",
                          count("parlour_sessions_refused_total"),
                          count("parlour_visitor_connections"));
    return text + "\n";
  }
  std::string turns() const {
    return fmt::format(
        "turns     {}, {}; {} in all, {} script errors\n",
        rate("parlour_turns_total"), times("parlour_turn_seconds"),
        count("parlour_turns_total"), count("parlour_script_errors_total"));
  }
  std::string messages() const {
    return fmt::format(
        "messages  {}, {} to sessions; {} dropped, {} unhandled, {} in "
        "flight\n",
        rate("parlour_messages_total"),
        rate("parlour_messages_to_sessions_total"),
        count("parlour_routes_total", "drop"),
        count("parlour_messages_unhandled_total"),
        count("parlour_work_in_flight"));
  }
  std::string process() const {
    return fmt::format("process   {} in memory, {:.0f} % of a processor, {} "
                       "threads\n",
                       bytes_text(value("process_resident_memory_bytes")),
                       100 * risen("process_cpu_seconds_total") / passed_,
                       count("process_threads"));
  }
  std::string journal() const {
    if (!has("parlour_journal_records_total"))
      return "";
    return fmt::format(
        "journal   {} records, {} KB/s, {} groups, {}; {} records wait, {} "
        "lost{}\n",
        rate("parlour_journal_records_total"),
        static_cast<std::int64_t>(risen("parlour_journal_bytes_total") /
                                  passed_ / 1e3),
        rate("parlour_journal_groups_total"),
        times("parlour_journal_write_seconds"),
        count("parlour_journal_waiting_records"),
        count("parlour_journal_lost_records_total"),
        value("parlour_journal_writable") == 0 ? ": IT CANNOT BE WRITTEN" : "");
  }

  std::string components() const {
    using Row = std::array<std::string, 7>;
    std::vector<Row> rows = {{"component", "role", "state", "mailbox",
                              "messages", "failures", "restarts"}};
    if (const auto* up = find(now_.metrics, "parlour_component_up"))
      for (const auto& one : up->samples) {
        const auto& name = one.labels.at(0).second;
        rows.push_back({name, one.labels.size() > 1 ? one.labels[1].second : "",
                        one.value > 0 ? "up" : "down",
                        count("parlour_component_mailbox_messages", name),
                        rate("parlour_component_messages_total", name),
                        count("parlour_component_failures_total", name),
                        count("parlour_component_restarts_total", name)});
      }
    return rows.size() == 1 ? "" : "\n" + table(rows);
  }
  template <std::size_t columns>
  static std::string
  table(const std::vector<std::array<std::string, columns>>& rows) {
    std::array<std::size_t, columns> widths = {};
    for (const auto& row : rows)
      for (std::size_t i = 0; i < columns; ++i)
        widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const auto& row : rows) {
      std::string line;
      for (std::size_t i = 0; i < columns; ++i)
        line += fmt::format("{:<{}}  ", row[i], widths[i]);
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
  }

  const MetricsReport& now_;
  const std::optional<MetricsReport>& before_;
  const double passed_; // seconds
};

} // namespace

std::string top_view(const MetricsReport& now,
                     const std::optional<MetricsReport>& before) {
  return View(now, before).text();
}

} // namespace parlour::tools
