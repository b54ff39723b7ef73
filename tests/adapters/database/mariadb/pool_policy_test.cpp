// What a pool of connections decides: without a server, a thread or a clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/adapters/database/mariadb/pool_policy_fixture.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;
using Kind = DatabaseCommand;
using Moment = PoolPolicy::Moment;

// -- opening ------------------------------------------------------------------

TEST_F(PoolPolicyTest, OpensOneConnectionBeforeAnybodyNeedsIt) {
  policy.begin();
  EXPECT_THAT(deeds(), ElementsAre("set up 0"));
  opens(0);
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_EQ(policy.next_moment(now), Moment::max());
}

TEST_F(PoolPolicyTest, OpensOneAtATimeAndOnlyForWhoNeedsIt) {
  policy.begin();
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("set up 0"));
  opens(0);
  EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
  queue("s2", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("open 1"));
  EXPECT_TRUE(policy.is_busy());
  opens(1);
  EXPECT_THAT(deeds(), ElementsAre("run 1: s2"));
  queue("s3", Kind::query);
  EXPECT_THAT(deeds(), IsEmpty()) << "there may be two";
  succeeds(0);
  EXPECT_THAT(answers(), ElementsAre("s1: well"));
  EXPECT_THAT(deeds(), ElementsAre("run 0: s3"));
}

TEST_F(PoolPolicyTest, TriesAgainAfterALongerPauseEachTime) {
  policy.begin();
  policy.deeds();
  for (const auto pause :
       {50ms, 100ms, 200ms, 400ms, 800ms, 1'600ms, 3'200ms, 5'000ms, 5'000ms}) {
    does_not_open(0);
    EXPECT_THAT(deeds(), ElementsAre("close 0"));
    EXPECT_EQ(policy.next_moment(now), Moment::max()) << "nobody needs one";
    now += pause - 1ms;
    queue("s1", Kind::query);
    EXPECT_THAT(deeds(), IsEmpty());
    EXPECT_EQ(policy.next_moment(now), now + 1ms);
    now += 1ms;
    EXPECT_THAT(deeds(), ElementsAre("set up 0"));
    now += busy_timeout;
    policy.decide(now);
  }
  opens(0);
  policy.hung_up(0);
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("close 0", "open 0"));
  does_not_open(0);
  policy.decide(now);
  EXPECT_EQ(policy.next_moment(now), now + 50ms) << "it begins anew";
}

TEST_F(PoolPolicyTest, DoesNotOpenForASessionThatWaitsForItsOwn) {
  connect(1);
  begin_transaction("s1");
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), IsEmpty());
  now += busy_timeout;
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), IsEmpty()) << "it may wait as long as it takes";
  succeeds(0);
  EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
}

// -- which connection ---------------------------------------------------------

TEST_F(PoolPolicyTest, PrefersAConnectionInTheRightMode) {
  connect(2);
  for (const auto place : {0, 1})
    queue("s" + std::to_string(place), Kind::query);
  deeds();
  succeeds(0, Access::read);
  succeeds(1, Access::write);
  queue("w", Kind::query, true);
  queue("r", Kind::query, false);
  EXPECT_THAT(deeds(), ElementsAre("run 1: w", "run 0: r"));
}

TEST_F(PoolPolicyTest, KeepsAConnectionForItsTransaction) {
  connect(2);
  const auto place = begin_transaction("s1");
  const auto other = 1 - place;
  queue("s2", Kind::query);
  queue("s3", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("run " + std::to_string(other) + ": s2"));
  queue("s1", Kind::commit);
  EXPECT_THAT(deeds(), ElementsAre("run " + std::to_string(place) + ": s1"));
  succeeds(place);
  EXPECT_THAT(deeds(), ElementsAre("run " + std::to_string(place) + ": s3"));
}

TEST_F(PoolPolicyTest, RefusesBeginCommitAndRollbackInTheWrongOrder) {
  connect(2);
  queue("s1", Kind::commit);
  queue("s1", Kind::rollback);
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), SizeIs(2));
  begin_transaction("s1");
  queue("s1", Kind::begin);
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), SizeIs(1));
}

// -- lost orders --------------------------------------------------------------

struct Loss {
  const char* name;
  Kind kind;
  bool write;
  bool in_transaction;
  bool in_doubt;
  ErrorKind error;
  // What is answered; empty: it is repeated.
  const char* answer;
};

class LostOrderTest : public PoolPolicyTest,
                      public testing::WithParamInterface<Loss> {};

TEST_P(LostOrderTest, IsRepeatedOrFailsOrIsInDoubt) {
  connect(1);
  const auto& loss = GetParam();
  if (loss.in_transaction)
    begin_transaction("s1");
  queue("s1", loss.kind, loss.write);
  ASSERT_THAT(deeds(), ElementsAre("run 0: s1"));
  fails(0, {true, loss.in_doubt, false, Access::write}, loss.error);
  const std::string answer = loss.answer;
  if (answer.empty()) {
    EXPECT_THAT(deeds(), ElementsAre("close 0", "open 0"));
    EXPECT_THAT(answers(), IsEmpty());
    opens(0);
    EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
  } else {
    EXPECT_THAT(deeds(), ElementsAre("close 0"));
    EXPECT_THAT(answers(), ElementsAre("s1: " + answer));
  }
}

constexpr auto offline = ErrorKind::offline;
constexpr auto timeout = ErrorKind::timeout;
constexpr Loss losses[] = {
    // name, kind, write, in a transaction, in doubt, error, answer
    {"Connect", Kind::connect, false, false, true, offline, ""},
    {"Read", Kind::query, false, false, true, offline, ""},
    {"ReadNotSent", Kind::query, false, false, false, offline, ""},
    {"ReadTooLate", Kind::query, false, false, true, timeout, "Timeout"},
    {"Write", Kind::query, true, false, true, offline, "InDoubt"},
    {"WriteTooLate", Kind::query, true, false, true, timeout, "InDoubt"},
    {"WriteNotSent", Kind::query, true, false, false, offline, ""},
    {"Begin", Kind::begin, false, false, true, offline, ""},
    {"ReadInside", Kind::query, false, true, true, offline, "Offline"},
    {"WriteInside", Kind::query, true, true, true, offline, "Offline"},
    {"Commit", Kind::commit, false, true, true, offline, "InDoubt"},
    {"CommitNotSent", Kind::commit, false, true, false, offline, "Offline"},
    {"Rollback", Kind::rollback, false, true, true, offline, "Offline"},
};
INSTANTIATE_TEST_SUITE_P(All, LostOrderTest, testing::ValuesIn(losses),
                         [](const auto& param) {
                           return std::string(param.param.name);
                         });

// Once for each connection that a restarted server broke, and once more.
TEST_F(PoolPolicyTest, RepeatsAnOrderNotForEver) {
  connect(2);
  queue("s1", Kind::query);
  for (int i = 0; i < 3; ++i) {
    policy.decide(now);
    const auto all = policy.deeds();
    const auto* run = std::get_if<PoolPolicy::Run>(&all.back());
    if (!run) {
      opens(std::get<PoolPolicy::Open>(all.back()).place);
      --i;
      continue;
    }
    EXPECT_THAT(answers(), IsEmpty());
    fails(run->place, {true, false, false, Access::write}, offline);
  }
  EXPECT_THAT(answers(), ElementsAre("s1: Offline"));
}

TEST_F(PoolPolicyTest, WhatIsRepeatedComesFirst) {
  connect(1);
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
  queue("s2", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("open 1"));
  fails(0, {true, false, false, Access::write}, offline);
  opens(1);
  EXPECT_THAT(deeds(), ElementsAre("close 0", "run 1: s1", "open 0"));
}

// -- failed orders ------------------------------------------------------------

TEST_F(PoolPolicyTest, KeepsTheConnectionOfAFailedStatement) {
  connect(1);
  queue("s1", Kind::query);
  deeds();
  fails(0, {});
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), ElementsAre("s1: Database"));
}

TEST_F(PoolPolicyTest, ClosesAfterABeginCommitOrRollbackThatFailed) {
  connect(1);
  queue("s1", Kind::begin);
  deeds();
  fails(0, {});
  EXPECT_THAT(deeds(), ElementsAre("close 0"));
  EXPECT_THAT(answers(), ElementsAre("s1: Database"));
  queue("s1", Kind::commit);
  EXPECT_THAT(deeds(), IsEmpty()) << "there is no transaction";
}

// The next statement of the session would run outside of its transaction.
TEST_F(PoolPolicyTest, ASessionLearnsOnceThatItsTransactionIsLost) {
  connect(1);
  begin_transaction("s1");
  queue("s1", Kind::query);
  deeds();
  fails(0, {false, false, true, Access::write});
  EXPECT_THAT(deeds(), ElementsAre("close 0"));
  EXPECT_THAT(answers(), ElementsAre("s1: Database"));
  queue("s1", Kind::query);
  queue("s1", Kind::rollback);
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), ElementsAre("s1: Database", "s1: Database"));
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("open 0"));
}

TEST_F(PoolPolicyTest, ASessionLearnsOfAServerThatHungUp) {
  connect(1);
  begin_transaction("s1");
  policy.hung_up(0);
  EXPECT_THAT(deeds(), ElementsAre("close 0"));
  queue("s1", Kind::commit);
  EXPECT_THAT(deeds(), IsEmpty());
  EXPECT_THAT(answers(), ElementsAre("s1: Database"));
}

// -- time ---------------------------------------------------------------------

TEST_F(PoolPolicyTest, EndsATransactionThatIsOpenForTooLong) {
  connect(1);
  begin_transaction("s1");
  EXPECT_EQ(policy.next_moment(now), now + transaction_timeout);
  queue("s1", Kind::query);
  EXPECT_THAT(deeds(), ElementsAre("run 0: s1"));
  now += transaction_timeout;
  EXPECT_THAT(deeds(), IsEmpty()) << "not while a statement runs";
  succeeds(0);
  EXPECT_THAT(deeds(),
              ElementsAre("close 0", HasSubstr("was open for too long")));
}

TEST_F(PoolPolicyTest, SaysWhyAnOrderHasWaitedTooLong) {
  const auto why = [&] {
    queue("s1", Kind::query);
    policy.decide(now);
    EXPECT_LE(policy.next_moment(now), now + busy_timeout);
    now += busy_timeout;
    policy.decide(now);
    const auto answers = policy.answers();
    return answers.empty() ? "nothing" : answers[0].outcome.error().message;
  };
  policy.begin();
  EXPECT_THAT(why(), HasSubstr("has not answered yet"));
  does_not_open(0);
  EXPECT_THAT(why(), StartsWith("The database server cannot be reached: "
                                "nobody is there"));
  opens(0);
  queue("s2", Kind::query);
  policy.decide(now);
  EXPECT_THAT(why(), StartsWith("All connections to the database are busy"));
}

// Nobody wakes a pool that is busy.
TEST_F(PoolPolicyTest, LooksForNewOrdersWhileItIsBusy) {
  PoolPolicy one({1, busy_timeout, transaction_timeout});
  one.begin();
  EXPECT_TRUE(one.is_busy());
  EXPECT_EQ(one.next_moment(now), now + busy_timeout);
  one.opened(0, StatementAnswer{}, now);
  EXPECT_FALSE(one.is_busy());
  EXPECT_EQ(one.next_moment(now), Moment::max());
}

// -- the end ------------------------------------------------------------------

TEST_F(PoolPolicyTest, AnswersEverythingInTheEnd) {
  connect(2);
  queue("reads", Kind::query);
  queue("writes", Kind::query, true);
  queue("waits", Kind::query);
  deeds();
  policy.end();
  EXPECT_THAT(answers(), ElementsAre("reads: Offline", "writes: InDoubt",
                                     "waits: Offline"));
  EXPECT_THAT(deeds(), ElementsAre("close 0", "close 1"));
}

TEST_F(PoolPolicyTest, AWriteInsideOfATransactionIsRolledBackInTheEnd) {
  connect(1);
  begin_transaction("s1");
  queue("s1", Kind::query, true);
  deeds();
  policy.end();
  EXPECT_THAT(answers(), ElementsAre("s1: Offline"));
}

} // namespace
} // namespace parlour::adapters
