#include "actors/node/metrics_collector.hpp"

#include <utility>

namespace parlour::actors {

namespace {

double number(std::uint64_t count) {
  return static_cast<double>(count);
}

void add_messages(Metrics& all, const Counters& counters) {
  const auto counter = [&](const char* name, const char* sentence,
                           std::uint64_t count) {
    all.push_back(metric(name, MetricKind::counter, sentence, number(count)));
  };
  counter("parlour_messages_total", "Messages that were routed.",
          counters.messages());
  counter("parlour_messages_to_sessions_total", "Messages that sessions got.",
          counters.to_sessions);
  counter("parlour_messages_unhandled_total", "Messages that nobody took.",
          counters.unhandled);
  Metric routes{"parlour_routes_total", MetricKind::counter,
                "Messages to which a rule of the routes was applied; ring: "
                "dropped, as they went in a ring."};
  for (const auto& [route, count] :
       {std::pair("relay", counters.relayed.load()),
        std::pair("filter", counters.filtered.load()),
        std::pair("drop", counters.dropped.load()),
        std::pair("ring", counters.circled.load())})
    routes.samples.push_back({{{"route", route}}, number(count)});
  all.push_back(std::move(routes));
}

std::vector<std::shared_ptr<ComponentMailbox>>
mailboxes_of(const Target& target) {
  std::vector<std::shared_ptr<ComponentMailbox>> all;
  if (!target.by_session)
    all.push_back(target.mailbox);
  else
    for (const auto& session : target.by_session->sessions())
      all.push_back(target.mailbox_of(session));
  std::erase(all, nullptr);
  return all;
}

// Where each session has an instance of its own, it is up if there is one.
bool is_up(const Target& target) {
  return target.by_session ? !target.by_session->sessions().empty()
                           : target.up && *target.up;
}

void add_components(Metrics& all, const RoutingTable& table) {
  Metric up{"parlour_component_up", MetricKind::gauge,
            "1: it serves; 0: it is down, or its agent is away."};
  Metric waiting{"parlour_component_mailbox_messages", MetricKind::gauge,
                 "Messages that wait for it."};
  Metric received{"parlour_component_messages_total", MetricKind::counter,
                  "Messages that it has got."};
  for (const auto& target : table.targets()) {
    const MetricSample::Labels labels = {
        {"component", target.name},
        {"role", target.roles.empty() ? "" : target.roles.front()}};
    double waits = 0;
    double got = 0;
    for (const auto& mailbox : mailboxes_of(target)) {
      waits += static_cast<double>(mailbox->size());
      got += number(mailbox->received());
    }
    up.samples.push_back({labels, is_up(target) ? 1.0 : 0.0});
    waiting.samples.push_back({labels, waits});
    // What was counted for sessions that are over is forgotten.
    if (!target.by_session)
      received.samples.push_back({labels, got});
  }
  for (auto* one : {&up, &waiting, &received})
    all.push_back(std::move(*one));
}

// Of an actor that does not answer, the length of its mailbox is not known: the
// figure is left out, as 0 would look healthy.
void add_actors(Metrics& all, const std::vector<ActorStatus>& actors,
                std::int64_t in_flight) {
  Metric answers{"parlour_actor_answers", MetricKind::gauge,
                 "1: it says how it is; 0: it has not done so in time."};
  Metric waiting{"parlour_actor_mailbox_messages", MetricKind::gauge,
                 "Messages that it has not come to."};
  for (const auto& actor : actors) {
    answers.samples.push_back(
        {{{"actor", actor.kind}}, actor.answered ? 1.0 : 0.0});
    if (actor.answered)
      waiting.samples.push_back({{{"actor", actor.kind}}, number(actor.queue)});
  }
  all.push_back(std::move(answers));
  all.push_back(std::move(waiting));
  all.push_back(metric("parlour_work_in_flight", MetricKind::gauge,
                       "Messages that are queued or being handled, and what "
                       "else keeps the node busy.",
                       static_cast<double>(in_flight)));
}

} // namespace

Metrics collect_metrics(const MetricSources& sources) {
  auto all = sources.node.told();
  add_messages(all, sources.table.counters());
  add_components(all, sources.table);
  add_actors(all, sources.actors, sources.in_flight);
  if (sources.journal)
    for (auto& one : sources.journal->metrics())
      all.push_back(std::move(one));
  return all;
}

} // namespace parlour::actors
