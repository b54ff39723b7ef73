#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/bench/support/quiet_port.hpp"

namespace parlour::tools {
namespace {

TEST(QuietPort, hears_what_is_said_and_keeps_silent) {
  const test::TemporaryFolder folder;
  folder.write("x.xml", "<dialogue><topic name=\"Taxi\"><slot name=\"To\" "
                        "type=\"Functional\" question=\"Where?\"/></topic>"
                        "</dialogue>");
  const auto program =
      script::compile_file(folder.path() / "x.xml", {}).program;
  ASSERT_TRUE(program);
  QuietPort port;
  dialogue::Conversation conversation(program, {}, port);
  conversation.open(0);
  port.run(conversation);
  dialogue::Act act;
  act.topic = "Taxi";
  const auto shared = std::make_shared<const dialogue::Act>(act);
  conversation.take_acts({&shared, 1}, 0);
  port.run(conversation);
  EXPECT_EQ(port.said(), std::string("Where?").size());
  EXPECT_EQ(port.said(), 0u);
  port.be_silent(conversation);
  EXPECT_GT(port.said(), 0u);
  EXPECT_EQ(port.trouble(), "");
}

} // namespace
} // namespace parlour::tools
