#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include "adapters/process/ipc_values.hpp"
#include "adapters/process/remote_host.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

class RemoteHostTest : public testing::Test {
protected:
  RemoteHostTest() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("no sockets");
    ours.emplace(ends[0]);
    theirs.emplace(ends[1]);
    host.emplace(*ours);
  }

  IpcMessage said() {
    while (messages.empty()) {
      theirs->wait();
      messages = theirs->receive().value();
    }
    auto message = messages.front();
    messages.erase(messages.begin());
    return message;
  }
  Expected<Options> begin(bool real_time) {
    return host->begin(
        {IpcKind::start,
         {0, real_time, Map{{"a", "b"}}, "/data", "/application"}});
  }

  std::optional<IpcSocket> ours;
  std::optional<IpcSocket> theirs;
  std::optional<RemoteHost> host;
  std::vector<IpcMessage> messages;
};

TEST_F(RemoteHostTest, KeepsWhatItIsToldAtTheStart) {
  EXPECT_EQ(begin(false).value().at("a"), "b");
  EXPECT_EQ(host->data_folder(), "/data");
  EXPECT_EQ(host->application_folder(), "/application");
  EXPECT_FALSE(host->begin({IpcKind::start, {}}));
}

TEST_F(RemoteHostTest, HasTheTimeToldLastOrTheMachines) {
  ASSERT_TRUE(begin(false));
  host->set_time(77);
  EXPECT_EQ(host->clock().now(), 77);
  ASSERT_TRUE(begin(true));
  EXPECT_GT(host->clock().now(), 1'000'000'000'000);
}

TEST_F(RemoteHostTest, SaysWhatThePluginDoes) {
  const auto message = test::message("Booked", {"S1"});
  host->fire_event(message);
  host->send_message(message);
  host->log("line");
  host->failed("gone");
  EXPECT_EQ(message_from(said().at(0)).value(), message);
  EXPECT_EQ(said().kind, IpcKind::send);
  EXPECT_EQ(said().at(0), Value("line"));
  const auto failed = said();
  EXPECT_EQ(failed.kind, IpcKind::failed);
  EXPECT_EQ(failed.at(0), Value("gone"));
  EXPECT_THROW(host->log(std::string(longest_ipc_message, 'x')),
               std::length_error);
}

TEST_F(RemoteHostTest, RunsDelaysOnceAndNoneThatIsCancelled) {
  int runs = 0;
  const auto first = host->after(Milliseconds(5), [&] { ++runs; });
  const auto second = host->after(Milliseconds(6), [&] { ++runs; });
  host->cancel(second);
  host->cancel(second);
  for (const auto id : {first, first, second})
    host->run(static_cast<std::int64_t>(id));
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(said().at(1), Value(5));
  EXPECT_EQ(said().at(1), Value(6));
  EXPECT_EQ(said().kind, IpcKind::cancel);
}

TEST_F(RemoteHostTest, ReactsOnceToWhatAnotherComponentAnswers) {
  std::vector<std::string> answers;
  const auto note = [&](const Expected<Message>& answer) {
    answers.push_back(answer ? answer->command : answer.error().message);
  };
  host->ask(test::message("Query"), Milliseconds(50), note);
  host->ask(test::message("Query"), Milliseconds(50), note);
  const auto first = said();
  EXPECT_EQ(first.at(2), Value(50));
  const auto answer = to_value(test::message("Result"));
  const IpcMessage result{IpcKind::answer, {0, first.at(0), Value(), answer}};
  host->react(result);
  host->react(result);
  host->react({IpcKind::answer,
               {0, said().at(0),
                to_value(Error{ErrorKind::offline, "nobody is there", {}})}});
  EXPECT_THAT(answers, testing::ElementsAre("Result", "nobody is there"));
}

TEST_F(RemoteHostTest, AsksAndIsAnswered) {
  std::thread other([this] {
    const auto good = said();
    host->answered({IpcKind::reply, {999, {}, "nobody asked"}});
    host->answered({IpcKind::reply, {good.at(0), {}, List{good.at(1)}}});
    host->answered({IpcKind::reply,
                    {said().at(0),
                     to_value(Error{ErrorKind::database, "not there", {}})}});
  });
  EXPECT_THAT(host->column("db:a.b").value(), testing::ElementsAre("db:a.b"));
  EXPECT_EQ(host->column("db:c.d").error().kind, ErrorKind::database);
  other.join();
}

TEST_F(RemoteHostTest, AsksOnceForWhatTheScriptsSay) {
  std::thread other([this] {
    const auto question = said();
    EXPECT_EQ(question.kind, IpcKind::language);
    host->answered(
        {IpcKind::reply,
         {question.at(0), {}, List{List{List{}, List{}, List{}}, true}}});
  });
  const auto understanding = host->understanding();
  other.join();
  ASSERT_NE(understanding, nullptr);
  EXPECT_EQ(host->understanding(), understanding);
  const auto phrases = host->phrases();
  theirs.reset();
  ASSERT_NE(phrases, nullptr);
  EXPECT_FALSE(phrases->render("hello").words);
}

TEST_F(RemoteHostTest, SaysWhyWhatTheScriptsSayCannotBeRead) {
  std::thread other([this] {
    host->answered(
        {IpcKind::reply,
         {said().at(0), to_value(Error{ErrorKind::limit, "too long", {}})}});
  });
  EXPECT_THROW(host->understanding(), std::runtime_error);
  other.join();
}

TEST_F(RemoteHostTest, HasNoAnswerWhereNobodyIs) {
  theirs.reset();
  EXPECT_FALSE(host->column("db:a.b"));
  EXPECT_EQ(host->understanding(), nullptr);
  EXPECT_EQ(host->phrases(), nullptr);
}

} // namespace
} // namespace parlour::adapters
