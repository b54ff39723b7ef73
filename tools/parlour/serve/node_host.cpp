#include "tools/parlour/serve/node_host.hpp"

#include <utility>

#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

namespace {

// The words of adapters/web/PROTOCOL.md for an output's act.
const char* name_of(dialogue::OutputAct act) {
  switch (act) {
  case dialogue::OutputAct::answer:
    return "answer";
  case dialogue::OutputAct::question:
    return "question";
  case dialogue::OutputAct::reprompt:
    return "reprompt";
  case dialogue::OutputAct::resume:
    return "resume";
  case dialogue::OutputAct::chat:
    break;
  }
  return "chat";
}

} // namespace

// The server's thread waits for the ends before it looks at the seats.
void NodeHost::connect(actors::Node& node, web::TextServer& server,
                       std::vector<dialogue::SavedSession> left) {
  web::VisitorId visitor = 0;
  for (auto& session : left) {
    ++visitor;
    seats_[visitor] =
        node.begin_visit(calls_of(&server, visitor), std::move(session));
  }
  connect_.set_value({&node, &server});
}

// The callbacks come from threads of the node.
actors::SeatCallbacks NodeHost::calls_of(web::TextServer* server,
                                         web::VisitorId visitor) {
  actors::SeatCallbacks calls;
  calls.on_session_begin = [=](const SessionId& session) {
    server->began(visitor, session);
  };
  calls.on_output = [=](const SessionId& session,
                        const dialogue::Output& output) {
    server->said(visitor, session,
                 {0, output.id, name_of(output.act), output.text});
  };
  calls.on_turns_done = [=](const SessionId& session, std::uint64_t turn) {
    server->done(visitor, session, turn);
  };
  calls.on_session_end = [=](const SessionId& session) {
    server->ended(visitor, session);
  };
  return calls;
}

// The seat is noted when begin_visit() returns; the first word of the session
// may be on its way to the server by then, which takes it later.
void NodeHost::open(web::VisitorId visitor) {
  seats_[visitor] = ends().node->begin_visit(calls_of(ends().server, visitor));
}

// A visitor who was closed meanwhile has no seat.
void NodeHost::take(web::VisitorId visitor, const web::Turn& turn) {
  auto* const node = ends().node;
  const auto found = seats_.find(visitor);
  if (found != seats_.end())
    node->enter_turn(found->second, turn.number, turn.lines);
}

void NodeHost::close(web::VisitorId visitor) {
  auto* const node = ends().node;
  if (const auto closed = seats_.extract(visitor))
    node->end_visit(closed.mapped());
}

std::string NodeHost::clock() {
  return format_timestamp(ends().node->now(), "%Y-%m-%d %H:%M:%S");
}

Metrics metrics_of(const web::TextServer::Counts& counts) {
  using enum MetricKind;
  const auto number = [](auto count) { return static_cast<double>(count); };
  return {metric("parlour_visitor_connections", gauge,
                 "Connections of visitors.", number(counts.connections)),
          metric("parlour_visitors_total", counter, "Visitors who came.",
                 number(counts.book.visitors)),
          metric("parlour_visitors_resumed_total", counter,
                 "Visitors who came back to their session.",
                 number(counts.book.resumed)),
          metric("parlour_sessions_refused_total", counter,
                 "Visitors for whom there was no room.",
                 number(counts.book.refused))};
}

std::vector<web::LeftVisitor>
visitors_of(const std::vector<dialogue::SavedSession>& left) {
  std::vector<web::LeftVisitor> visitors;
  for (const auto& session : left) {
    auto& visitor = visitors.emplace_back(web::LeftVisitor{
        session.id, session.turns.taken, session.turns.done, {}});
    for (const auto& said : session.turns.said)
      visitor.said.push_back(
          {said.turn, said.output, name_of(said.act), said.text});
  }
  return visitors;
}

} // namespace parlour::tools
