// <transaction>: which statements the database gets, and in which order, even
// if the body fails or is cancelled.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/effect_handler.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

// A bell that runs the statements; the database notes what it is told.
struct Bank : World {
  explicit Bank(const std::string& statements, const std::string& more = "",
                const WorldOptions& options = {})
      : World(R"xml(<handler name="H"><messages><component><Bell><Rings>
          <connectdb param="SQLite" write="true"/><try>)xml" +
                  statements + R"xml(
            <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
          </try></Rings></Bell></component></messages></handler>)xml" +
                  more,
              options) {
    components["Bell"] = {};
    database = [this](const QueryRequest& request) -> Expected<ResultSet> {
      constexpr const char* kinds[] = {"", "begin", "commit", "rollback"};
      const auto told = kinds[static_cast<std::size_t>(request.kind)] +
                        request.sql + " " + request.database;
      log.push_back(told);
      if (told.starts_with(failing))
        return fail(ErrorKind::database, "it does not");
      return ResultSet{};
    };
  }
  Texts ring() {
    event("Bell", "Rings");
    return std::exchange(log, {});
  }

  Texts log;
  std::string failing = "nothing";
};

const std::string pay = "<querydb param='pay'/>";

TEST(Transactions, CommitWhenTheyEndWell) {
  Bank world("<transaction>" + pay + pay + "</transaction>");
  EXPECT_EQ(world.ring(), (Texts{"begin SQLite", "pay SQLite", "pay SQLite",
                                 "commit SQLite"}));
}

TEST(Transactions, RollBackByAnError) {
  Bank world("<transaction>" + pay + "<throw expr=\"'no'\"/></transaction>" +
             pay);
  EXPECT_EQ(world.ring(),
            (Texts{"begin SQLite", "pay SQLite", "rollback SQLite"}));
  EXPECT_EQ(world.said(), Texts{"Thrown: no"});
}

TEST(Transactions, RollBackByAQuerysError) {
  Bank world("<transaction>" + pay + "</transaction>");
  world.failing = "pay";
  EXPECT_EQ(world.ring(),
            (Texts{"begin SQLite", "pay SQLite", "rollback SQLite"}));
  EXPECT_EQ(world.said(), Texts{"Database: it does not"});
}

TEST(Transactions, GoOnAfterAnErrorThatIsCaughtInside) {
  Bank world("<transaction><try><throw expr='1'/><catch/></try>" + pay +
             "</transaction>");
  EXPECT_EQ(world.ring(),
            (Texts{"begin SQLite", "pay SQLite", "commit SQLite"}));
}

TEST(Transactions, OfAnotherDatabase) {
  Bank world("<transaction db='Ledger'><querydb param='pay' db='Ledger'/>"
             "</transaction>");
  world.components["Ledger"] = {"Database"};
  EXPECT_EQ(world.ring(),
            (Texts{"begin Ledger", "pay Ledger", "commit Ledger"}));
}

TEST(Transactions, ReturnBreakAndContinueLeaveThemWell) {
  Bank world("<call function='f'/><for name='i' from='1' to='3'><transaction>"
             "<if cond='i == 1'><continue/></if><break/></transaction></for>",
             "<function name='f'><transaction><return/></transaction>" + pay +
                 "</function>");
  EXPECT_EQ(world.ring(),
            (Texts{"begin SQLite", "commit SQLite", "begin SQLite",
                   "commit SQLite", "begin SQLite", "commit SQLite"}));
}

TEST(Transactions, AreNotBegunWhereThatFails) {
  Bank world("<transaction>" + pay + "</transaction>");
  world.failing = "begin";
  EXPECT_EQ(world.ring(), Texts{"begin SQLite"});
  EXPECT_EQ(world.said(), Texts{"Database: it does not"});
}

// The error of the commit counts, not one of the rollback after it.
TEST(Transactions, ACommitThatFails) {
  Bank world("<transaction>" + pay + "</transaction>");
  world.failing = "commit";
  EXPECT_EQ(world.ring(), (Texts{"begin SQLite", "pay SQLite", "commit SQLite",
                                 "rollback SQLite"}));
  EXPECT_EQ(world.said(), Texts{"Database: it does not"});
}

TEST(Transactions, ARollbackThatFails) {
  Bank world("<transaction><throw expr=\"'no'\"/></transaction>");
  world.failing = "rollback";
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Thrown: no"});
}

TEST(Transactions, RollBackPastALimit) {
  Bank world("<transaction><while cond='true'/></transaction>");
  EXPECT_EQ(world.ring(), (Texts{"begin SQLite", "rollback SQLite"}));
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
}

TEST(Transactions, RollBackPastTheLimitOfMemory) {
  WorldOptions options;
  options.settings = "<limits bytes='64KB'/>";
  Bank world("<transaction><var name='l' expr='[1]'/><while cond='true'>"
             "<set name='l' expr='l + l'/></while></transaction>",
             "", options);
  EXPECT_EQ(world.ring(), (Texts{"begin SQLite", "rollback SQLite"}));
}

TEST(Transactions, RollBackWhenTheSessionEnds) {
  Bank world("<transaction>" + pay + "<wait for='1s'/></transaction>");
  world.ring();
  world.hold_queries = true; // nobody answers any more
  world.take(input::Closed());
  ASSERT_EQ(world.queries.size(), 1u);
  EXPECT_EQ(world.queries[0].kind, QueryRequest::Kind::rollback);
}

TEST(Transactions, RollBackWhenTheUserWantsOut) {
  Bank world("", R"xml(<topic name="T"><slot name="S" type="Functional"
    question="S?"><filled><transaction><confirm question="Sure?"/>
    </transaction></filled></slot></topic>)xml");
  world.say(inform("T", {{"S", 1}}));
  world.say("cancel");
  EXPECT_EQ(world.log, (Texts{"begin ", "rollback "}));
}

} // namespace
} // namespace parlour::dialogue
