#include "tools/parlour/status/node_watch.hpp"

#include <chrono>
#include <utility>

#include <unistd.h>

#include "adapters/web/metrics_text.hpp"
#include "tools/parlour/status/process_metrics.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/status_report.hpp"

namespace parlour::tools {

namespace {

namespace web = adapters::web;

Nanoseconds steady_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::string label(const MetricSample& sample) {
  return sample.labels.empty() ? "" : sample.labels.front().second;
}

// A line for each sample of that name that is 0.
std::string of_those_at_zero(const Metrics& all, const char* name,
                             const char* text) {
  std::string lines;
  if (const auto* found = find(all, name))
    for (const auto& sample : found->samples)
      if (sample.value == 0)
        lines += label(sample) + text + "\n";
  return lines;
}

} // namespace

NodeWatch::NodeWatch(Of of)
    : of_(std::move(of)), begun_(steady_now()), tails_(of_.roles) {}

NodeWatch::~NodeWatch() {
  end();
}

void NodeWatch::see(const Inspection& seen) {
  if (const auto* node = node_.load())
    tails_.see(seen, node->now());
}

void NodeWatch::connect(actors::Node& node, Reload reload,
                        std::function<Metrics()> more) {
  reload_ = std::move(reload);
  more_ = std::move(more);
  tails_.connect([&node](bool wanted) { node.watch_all(wanted); });
  node_ = &node;
}

Expected<void> NodeWatch::serve_commands(const std::filesystem::path& sockets) {
  auto server = StatusServer::open(
      sockets, [this](const std::string& question) { return answer(question); },
      {{questions::tail,
        [this](Descriptor reader, const std::string& filter) {
          if (auto wanted = filter_from_json(filter))
            tails_.add(std::move(reader), std::move(*wanted));
        }},
       {questions::reload,
        [this](Descriptor connection, const std::string& request) {
          reload(std::move(connection), request);
        }}});
  if (!server)
    return tl::make_unexpected(server.error());
  commands_ = std::move(*server);
  return {};
}

Expected<void> NodeWatch::serve(const std::filesystem::path& sockets,
                                const std::optional<HostAndPort>& pages,
                                const Tell& log, const Tell& note) {
  if (auto served = serve_commands(sockets); !served)
    log("parlour status, top, tail and reload cannot ask this run: " +
        to_string(served.error()));
  if (!pages)
    return {};
  return serve_pages(*pages, log).map([&](const std::string& where) {
    note("metrics at " + where);
  });
}

Expected<std::string> NodeWatch::serve_pages(const HostAndPort& address,
                                             const Tell& log) {
  web::PageServerOptions options;
  options.address = address.host;
  options.port = address.port;
  options.pages["/metrics"] = [this] {
    return web::Page{true, web::metrics_text(metrics().metrics),
                     web::metrics_content_type};
  };
  options.pages["/health"] = [this] { return health(); };
  auto server = web::PageServer::start(
      std::move(options),
      [log](const std::string& what) { log("error: " + what); });
  if (!server)
    return tl::make_unexpected(server.error());
  pages_ = std::move(*server);
  return "http://" + pages_->address() + "/metrics";
}

void NodeWatch::end() {
  pages_.reset();
  commands_.reset();
  if (reloading_.valid())
    reloading_.wait();
  tails_.close();
  node_ = nullptr;
}

// -- what is told -------------------------------------------------------------

std::string NodeWatch::answer(const std::string& question) {
  if (question == questions::who)
    return to_json(RunningNode{of_.application, of_.folder, getpid()});
  if (question == questions::metrics)
    return to_json(metrics());
  auto& node = *node_.load();
  return to_json(StatusReport{of_.application, of_.folder, getpid(), node.now(),
                              node.status()});
}

// -- changes ------------------------------------------------------------------

void NodeWatch::reload(Descriptor connection, const std::string& request) {
  if (reloading_.valid() &&
      reloading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return send_all(connection,
                    to_json(ReloadReply{{"another reload is going on"}, {}}));
  // Closed at the end of its answer; the future would keep it for longer.
  reloading_ =
      std::async(std::launch::async,
                 [this, request, held = std::move(connection)]() mutable {
                   const auto to = std::move(held);
                   send_all(to, to_json(carry_out(request)));
                 });
}

ReloadReply NodeWatch::carry_out(const std::string& request) {
  const auto wanted = reload_request_from_json(request);
  if (!wanted)
    return {{wanted.error().message}, {}};
  if (!reload_)
    return {{"this run cannot be changed while it runs"}, {}};
  return reload_(*wanted);
}

// -- metrics and health -------------------------------------------------------

MetricsReport NodeWatch::metrics() {
  auto& node = *node_.load();
  MetricsReport report{of_.application, of_.folder, getpid(), node.now(),
                       node.metrics()};
  auto& all = report.metrics;
  all.push_back(metric("parlour_uptime_seconds", MetricKind::gauge,
                       "Since the application was started.",
                       static_cast<double>(steady_now() - begun_) / 1e9));
  for (auto& one : more_ ? more_() : Metrics())
    all.push_back(std::move(one));
  for (auto& one : process_metrics())
    all.push_back(std::move(one));
  return report;
}

// A component that is down is told and is no reason to end the process: its
// role falls to the next, and it is tried again.
web::Page NodeWatch::health() {
  const auto all = node_.load()->metrics();
  auto ills = of_those_at_zero(all, "parlour_actor_answers",
                               ": this actor does not answer in time");
  if (const auto* journal = find(all, "parlour_journal_writable");
      journal && journal->samples.at(0).value == 0)
    ills += "the journal cannot be written\n";
  return {ills.empty(),
          (ills.empty() ? "well\n" : ills) +
              of_those_at_zero(all, "parlour_component_up", ": is down")};
}

} // namespace parlour::tools
