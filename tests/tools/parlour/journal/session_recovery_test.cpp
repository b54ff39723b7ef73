#include <gmock/gmock.h>

#include "actors/node/node.hpp"
#include "adapters/journal/journal_format.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tests/support/memory_journal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/journal/session_recovery.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionRecoveryTest : public ApplicationTest {
protected:
  const Application application = load("greeter");
  const test::TemporaryFolder folder;

  // A node that says hello to one visitor, in virtual time; then it is gone
  // without a word, as far as its journal knows.
  void hold_and_crash() {
    auto journal = std::make_shared<test::MemoryJournal>();
    auto data = DataFolder::temporary().value();
    auto options = node_options(application, rehearsed(application.composition),
                                {data.path().string(), Timestamp{5}, 7});
    options.journal = journal;
    auto node = actors::Node::start(std::move(options)).value();
    const auto seat = node->open_seat({});
    node->enter(seat, {"hello"});
    node->run_until_quiet();
    auto bytes = adapters::part_header(1);
    for (const auto& record : journal->records)
      bytes += adapters::framed(record);
    folder.write("000001.journal", bytes);
  }
  RecoveredSessions recovered(const Application& with) {
    return recover_sessions(folder.path(), with.program,
                            script::make_phrase_evaluator(with.program))
        .value();
  }
};

TEST_F(SessionRecoveryTest, BringsBackWhatWasLeft) {
  hold_and_crash();
  const auto left = recovered(application);
  EXPECT_THAT(left.sessions, SizeIs(1));
  EXPECT_THAT(left.notices, IsEmpty());
}

TEST_F(SessionRecoveryTest, SaysWhatCannotGoOn) {
  hold_and_crash();
  const auto left = recovered(load("parting"));
  EXPECT_THAT(left.sessions, IsEmpty());
  EXPECT_THAT(left.notices, ElementsAre(HasSubstr("other scripts")));
}

TEST_F(SessionRecoveryTest, SaysWhatIsDamaged) {
  hold_and_crash();
  auto bytes = folder.read("000001.journal");
  bytes.back() ^= 1;
  folder.write("000001.journal", bytes);
  const auto left = recovered(application);
  EXPECT_THAT(left.sessions, IsEmpty());
  EXPECT_THAT(left.notices,
              ElementsAre(HasSubstr("damaged"), HasSubstr("cannot be read")));
}

} // namespace
} // namespace parlour::tools
