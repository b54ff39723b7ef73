#include "actors/routing/component_mailbox.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class ComponentMailboxTest : public testing::Test {
protected:
  const char* put(const char* command) {
    ComponentMailbox::Job job{shared(event("Script", command)), bench.work()};
    return mailbox->put(job);
  }

  // An instance that takes and notes whatever comes.
  component_host_actor reader(const char* name) {
    return bench.component_probe(name, mailbox);
  }

  Bench bench;
  std::shared_ptr<ComponentMailbox> mailbox =
      std::make_shared<ComponentMailbox>();
};

TEST_F(ComponentMailboxTest, GivesInOrderWhatWaited) {
  put("One");
  put("Two");
  mailbox->add_worker(reader("ear"));
  bench.run();
  put("Three");
  bench.run();
  EXPECT_THAT(bench.seen,
              ElementsAre("ear gets Script.One()", "ear gets Script.Two()",
                          "ear gets Script.Three()"));
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(ComponentMailboxTest, AnotherTakesWhatOneLeaves) {
  const auto first = reader("first");
  mailbox->add_worker(first);
  mailbox->add_worker(reader("second"));
  put("One"); // somebody is told
  mailbox->remove_worker(first);
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("second gets Script.One()"));
  EXPECT_FALSE(mailbox->take(first));
  put("Two");
  bench.run();
  EXPECT_THAT(bench.seen, testing::SizeIs(2));
}

TEST_F(ComponentMailboxTest, KeepsTheOrderOfWhatComesWhileSeveralTake) {
  const auto first = reader("first");
  const auto second = reader("second");
  mailbox->add_worker(first);
  mailbox->add_worker(second);
  put("One");
  put("Two");
  EXPECT_EQ(mailbox->take(first)->message->command, "One");
  put("Four");
  mailbox->put_back({shared(event("Script", "Three")), bench.work()});
  for (const char* command : {"Three", "Two", "Four"})
    EXPECT_EQ(mailbox->take(second)->message->command, command);
  EXPECT_FALSE(mailbox->take(first));
}

TEST_F(ComponentMailboxTest, DoesFirstWhatIsPutBack) {
  put("Two");
  mailbox->put_back({shared(event("Script", "One")), bench.work()});
  mailbox->add_worker(reader("ear"));
  bench.run();
  EXPECT_THAT(bench.seen,
              ElementsAre("ear gets Script.One()", "ear gets Script.Two()"));
}

TEST_F(ComponentMailboxTest, RefusesWhenItIsFullOrClosed) {
  for (std::size_t i = 0; i < ComponentMailbox::capacity; ++i)
    ASSERT_EQ(put("Go"), nullptr);
  ComponentMailbox::Job job{shared(event("Script", "Late")), bench.work()};
  EXPECT_STREQ(mailbox->put(job), "has more messages waiting than it may");
  EXPECT_EQ(job.message->command, "Late"); // still whose it was
  EXPECT_EQ(mailbox->take_all().size(), ComponentMailbox::capacity);
  EXPECT_TRUE(mailbox->empty());
  mailbox->close("is down");
  EXPECT_STREQ(put("Go"), "is down");
  mailbox->open();
  EXPECT_EQ(put("Go"), nullptr);
}

// What its slow instance has not come to counts, too.
TEST_F(ComponentMailboxTest, RefusesWhenItIsFullWhoeverWorksHere) {
  const auto slow = reader("slow");
  mailbox->add_worker(slow);
  for (std::size_t i = 0; i < ComponentMailbox::capacity; ++i)
    ASSERT_EQ(put("Go"), nullptr);
  EXPECT_TRUE(mailbox->take(slow));
  EXPECT_EQ(put("Go"), nullptr);
  EXPECT_STREQ(put("Go"), "has more messages waiting than it may");
  EXPECT_EQ(mailbox->size(), ComponentMailbox::capacity);
  EXPECT_TRUE(mailbox->take(slow));
  EXPECT_TRUE(mailbox->take(slow));
  EXPECT_EQ(put("Go"), nullptr);
  EXPECT_EQ(mailbox->take_all().size(), ComponentMailbox::capacity - 1);
  EXPECT_EQ(put("Go"), nullptr);
}

} // namespace
} // namespace parlour::actors
