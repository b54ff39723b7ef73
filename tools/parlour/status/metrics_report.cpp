#include "tools/parlour/status/metrics_report.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const MetricSample& sample, MetricKind kind) {
  Json json = {{"labels", sample.labels}};
  if (kind != MetricKind::histogram) {
    json["value"] = sample.value;
    return json;
  }
  json["buckets"] = sample.time.buckets;
  json["sum"] = sample.time.sum;
  return json;
}

Json json_of(const Metric& metric) {
  auto samples = Json::array();
  for (const auto& sample : metric.samples)
    samples.push_back(json_of(sample, metric.kind));
  return {{"name", metric.name},
          {"kind", static_cast<int>(metric.kind)},
          {"samples", std::move(samples)}};
}

Metric metric_from(const Json& json) {
  Metric metric;
  metric.name = json.at("name");
  metric.kind = static_cast<MetricKind>(json.at("kind").get<int>());
  for (const auto& one : json.at("samples")) {
    auto& sample = metric.samples.emplace_back();
    sample.labels = one.at("labels").get<MetricSample::Labels>();
    if (metric.kind != MetricKind::histogram) {
      sample.value = one.at("value");
      continue;
    }
    sample.time.buckets =
        one.at("buckets").get<decltype(sample.time.buckets)>();
    sample.time.sum = one.at("sum");
  }
  return metric;
}

} // namespace

std::string to_json(const MetricsReport& report) {
  auto all = Json::array();
  for (const auto& metric : report.metrics)
    all.push_back(json_of(metric));
  const Json json = {{"application", report.application},
                     {"folder", report.folder},
                     {"process", report.process},
                     {"time", report.time},
                     {"metrics", std::move(all)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Expected<MetricsReport> metrics_from_json(const std::string& text) {
  try {
    const auto json = Json::parse(text);
    MetricsReport report;
    report.application = json.at("application");
    report.folder = json.at("folder");
    report.process = json.at("process");
    report.time = json.at("time");
    for (const auto& one : json.at("metrics"))
      report.metrics.push_back(metric_from(one));
    return report;
  } catch (const Json::exception& thrown) {
    return fail(ErrorKind::network,
                std::string("no metrics were told: ") + thrown.what());
  }
}

} // namespace parlour::tools
