#include <future>

#include <gmock/gmock.h>

#include "adapters/agents/client/reconnection.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;

// Answers when it is told to.
class WaitingDialler : public PlatformDialler {
public:
  void dial(ConnectionId id, PeerConnection::Owner&, Done done) override {
    dialled.push_back(id);
    answer = std::move(done);
  }
  void cancel() override {
    is_cancelled = true;
  }

  std::vector<ConnectionId> dialled;
  Done answer;
  bool is_cancelled = false;
};

class NoOwner : public PeerConnection::Owner {
public:
  void heard(ConnectionId) override {}
  void arrived(ConnectionId, Read<AgentMessage>&&) override {}
  void lost(ConnectionId) override {}
};

class ReconnectionTest : public testing::Test {
protected:
  ReconnectionTest() {
    auto made = std::make_unique<WaitingDialler>();
    dialler = made.get();
    reconnection = std::make_unique<Reconnection>(
        *loop, std::move(made), "there:1", [this] { retried.set_value(); },
        [this](const std::string& text) { notes.push_back(text); });
  }
  ~ReconnectionTest() override {
    loop->post([this] { reconnection.reset(); });
    loop->stop();
  }
  // On the loop's thread, until it is done.
  void on_loop(const std::function<void()>& action) {
    std::promise<void> done;
    loop->post([&] {
      action();
      done.set_value();
    });
    done.get_future().get();
  }
  void dial() {
    reconnection->dial(owner, [this](PlatformDialler::Connected connection) {
      ++answers;
      EXPECT_FALSE(connection);
    });
  }
  void fail_to_connect() {
    dialler->answer(fail(ErrorKind::network, "nobody is there"));
  }

  const std::unique_ptr<Loop> loop = test::start_loop();
  WaitingDialler* dialler;
  std::unique_ptr<Reconnection> reconnection;
  NoOwner owner;
  std::promise<void> retried;
  std::vector<std::string> notes;
  int answers = 0;
};

TEST_F(ReconnectionTest, DialsOnceAtATime) {
  on_loop([&] {
    dial();
    dial();
    EXPECT_THAT(dialler->dialled, ElementsAre(1u));
    fail_to_connect();
    EXPECT_EQ(answers, 1);
    dial();
    EXPECT_THAT(dialler->dialled, ElementsAre(1u, 2u));
  });
}

TEST_F(ReconnectionTest, NotesEachLossOnce) {
  on_loop([&] {
    reconnection->try_later("it is gone");
    reconnection->try_later("it is still gone");
    EXPECT_THAT(notes, ElementsAre("not connected to there:1: it is gone"));
    reconnection->succeeded();
    reconnection->try_later("again");
    EXPECT_EQ(notes.size(), 2u);
  });
}

TEST_F(ReconnectionTest, RetriesAfterAPause) {
  on_loop([&] { reconnection->try_later("it is gone"); });
  retried.get_future().get();
}

TEST_F(ReconnectionTest, DoesNothingOnceItHasStopped) {
  on_loop([&] {
    reconnection->stop();
    EXPECT_TRUE(dialler->is_cancelled);
    dial();
    reconnection->try_later("it is gone");
    EXPECT_TRUE(dialler->dialled.empty());
    EXPECT_TRUE(notes.empty());
  });
}

} // namespace
} // namespace parlour::adapters::agents
