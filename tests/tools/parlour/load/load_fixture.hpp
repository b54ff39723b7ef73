// LoadTest: a server whose conversations greet and repeat what is said
// (FakeHost), and visitors for it.
#pragma once

#include <list>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/adapters/web/fake_host.hpp"
#include "tools/parlour/load/load_run.hpp"

namespace parlour::tools {

class LoadTest : public testing::Test {
protected:
  LoadTest() : clients(std::move(*web::TextClients::start())) {
    server = std::move(*web::TextServer::start({}, host, {}));
    host.teller = server.get();
    const auto address = server->address();
    parts.port = static_cast<std::uint16_t>(
        std::stoi(address.substr(address.rfind(':') + 1)));
  }
  void add(const std::string& text) {
    files.push_back(parse_conversation(text, "one.txt").conversation);
    conversations.push_back(played(files.back()));
  }
  std::vector<std::string> run(const LoadWishes& wishes) {
    LoadRun one(parts, conversations, wishes, {});
    one.run();
    return figures.lines(one.time());
  }

  web::test::FakeHost<web::TextServer> host;
  std::unique_ptr<web::TextServer> server;
  std::unique_ptr<web::TextClients> clients;
  LoadFigures figures;
  VisitorParts parts{*clients, figures};
  std::list<Conversation> files;
  std::vector<Played> conversations;
};

} // namespace parlour::tools
