#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {
namespace {

TEST_F(ApplicationTest, gives_a_node_all_it_needs) {
  const auto greeter = load("greeter");
  const auto options =
      node_options(greeter, in_memory(greeter.composition), {"/data", 5, 7});
  EXPECT_EQ(options.program, greeter.program);
  ASSERT_EQ(options.components.size(), 2u);
  EXPECT_EQ(options.components[0].name, "LogTelephone");
  EXPECT_EQ(options.components[1].options.count("file"), 0u);
  EXPECT_EQ(options.aliases.at("Record"), "Microphone");
  EXPECT_TRUE(options.phrases);
  EXPECT_EQ(options.columns("db:guest.name").value().size(), 1u);
  EXPECT_EQ(options.virtual_start, Timestamp(5));
  EXPECT_EQ(options.seed, 7u);
  EXPECT_EQ(options.data_folder, "/data");
  EXPECT_EQ(options.application_folder, greeter.folder.string());
}

} // namespace
} // namespace parlour::tools
