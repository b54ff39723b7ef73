#include "tools/parlour/serve/node_host.hpp"

#include <utility>

#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

namespace {

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

void NodeHost::connect(actors::Node& node, web::TextServer& server) {
  connect_.set_value({&node, &server});
}

// The callbacks come from threads of the node.
void NodeHost::open(web::VisitorId visitor) {
  auto* const server = ends().server;
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
  seats_[visitor] = ends().node->begin_visit(std::move(calls));
}

void NodeHost::take(web::VisitorId visitor, const web::Turn& turn) {
  const auto found = seats_.find(visitor);
  if (found != seats_.end())
    ends().node->enter_turn(found->second, turn.number, turn.lines);
}

void NodeHost::close(web::VisitorId visitor) {
  if (const auto closed = seats_.extract(visitor))
    ends().node->end_visit(closed.mapped());
}

std::string NodeHost::clock() {
  return format_timestamp(ends().node->now(), "%Y-%m-%d %H:%M:%S");
}

} // namespace parlour::tools
