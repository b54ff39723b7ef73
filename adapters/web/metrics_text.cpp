#include "adapters/web/metrics_text.hpp"

#include <string_view>

#include <fmt/format.h>

namespace parlour::adapters::web {

namespace {

const char* name_of(MetricKind kind) {
  switch (kind) {
  case MetricKind::counter:
    return "counter";
  case MetricKind::gauge:
    return "gauge";
  case MetricKind::histogram:
    break;
  }
  return "histogram";
}

// A sentence needs no quotes to be escaped, a label does.
std::string escaped(std::string_view text, bool quotes) {
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += "\\n";
    else if (c == '\\' || (quotes && c == '"'))
      result += {'\\', c};
    else
      result += c;
  return result;
}

// `more`: a label of a bucket; may be empty.
//
// {component="City",role="Database"}
std::string labels_of(const MetricSample& sample, const std::string& more) {
  std::string all;
  for (const auto& [name, value] : sample.labels)
    all += fmt::format("{}{}=\"{}\"", all.empty() ? "" : ",", name,
                       escaped(value, true));
  all += all.empty() || more.empty() ? more : "," + more;
  return all.empty() ? "" : "{" + all + "}";
}

double seconds(Nanoseconds time) {
  return static_cast<double>(time) / 1e9;
}

// Buckets are told as how many there are up to their bound.
// 'parlour_turn_seconds_bucket{le="0.1"} 12': twelve took 0.1 s or less.
void add_histogram(std::string& text, const std::string& name,
                   const MetricSample& sample) {
  std::uint64_t so_far = 0;
  for (std::size_t i = 0; i < sample.time.buckets.size(); ++i) {
    so_far += sample.time.buckets[i];
    const auto bound = i < Histogram::bounds.size()
                           ? fmt::format("{}", seconds(Histogram::bounds[i]))
                           : std::string("+Inf");
    text += fmt::format("{}_bucket{} {}\n", name,
                        labels_of(sample, "le=\"" + bound + "\""), so_far);
  }
  const auto labels = labels_of(sample, "");
  text += fmt::format("{}_sum{} {}\n", name, labels, seconds(sample.time.sum));
  text += fmt::format("{}_count{} {}\n", name, labels, so_far);
}

} // namespace

std::string metrics_text(const Metrics& all) {
  std::string text;
  for (const auto& metric : all) {
    text += fmt::format("# HELP {} {}\n# TYPE {} {}\n", metric.name,
                        escaped(metric.sentence, false), metric.name,
                        name_of(metric.kind));
    for (const auto& sample : metric.samples)
      if (metric.kind == MetricKind::histogram)
        add_histogram(text, metric.name, sample);
      else
        text += fmt::format("{}{} {}\n", metric.name, labels_of(sample, ""),
                            sample.value);
  }
  return text;
}

} // namespace parlour::adapters::web
