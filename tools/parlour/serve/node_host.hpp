// NodeHost: gives each visitor of a text server a seat of a node, and tells the
// server what is said there. Both are made first; then the host is connected,
// and until then visitors wait.
#pragma once

#include <future>
#include <unordered_map>
#include <vector>

#include "actors/node/node.hpp"
#include "adapters/web/text_server.hpp"

namespace parlour::tools {

namespace web = adapters::web;

// Two threads meet here: the server's calls open(), take(), close() and
// clock(), and the node's threads call the server with what is said. `seats_`
// belongs to the server's thread; connect() fills it before that thread may use
// it.
class NodeHost : public web::Host {
public:
  // Once. Both must live until the server has been destroyed and the node has
  // stopped. The sessions that a crash has left go on: they are those of the
  // visitors 1, 2, … (ServerOptions::left).
  void connect(actors::Node& node, web::TextServer& server,
               std::vector<dialogue::SavedSession> left = {});

  // -- web::Host, on the server's thread
  void open(web::VisitorId visitor) override;
  void take(web::VisitorId visitor, const web::Turn& turn) override;
  void close(web::VisitorId visitor) override;
  std::string clock() override;

private:
  static actors::SeatCallbacks calls_of(web::TextServer* server,
                                        web::VisitorId visitor);

  struct Ends {
    actors::Node* node;
    web::TextServer* server;
  };
  const Ends& ends() const {
    return connected_.get();
  }

  std::promise<Ends> connect_;
  std::shared_future<Ends> connected_ = connect_.get_future().share();
  std::unordered_map<web::VisitorId, actors::SeatId> seats_;
};

// What a text server counts.
// With the names of docs/operations.md.
Metrics metrics_of(const web::TextServer::Counts& counts);

// As the server knows them.
// `left` in the same order as NodeHost::connect() gets it, as visitors are
// numbered by it.
std::vector<web::LeftVisitor>
visitors_of(const std::vector<dialogue::SavedSession>& left);

} // namespace parlour::tools
