#include "tests/tools/parlour/voice_test/spoken_application.hpp"
#include "tools/parlour/voice_test/voice_user.hpp"

namespace parlour::tools {
namespace {

// What it does in a node is tested by row_runner_test and spoken_lines_test.
class VoiceUserTest : public SpokenTest {
protected:
  const ChosenComponent& find(const Composition& composition,
                              const std::string& name) {
    return *std::ranges::find(composition.components, name,
                              &ChosenComponent::name);
  }
};

TEST_F(VoiceUserTest, takes_the_place_of_the_files) {
  VoiceUser user({}, false, nullptr);
  const auto seated = user.seated(spoken.composition, "/nowhere");
  EXPECT_EQ(find(seated, "FileMicrophone").factory.description.name,
            "UserMicrophone");
  EXPECT_TRUE(find(seated, "FileMicrophone").options.empty());
  EXPECT_EQ(find(seated, "FileSpeaker").factory.description.name,
            "FileSpeaker");
}

} // namespace
} // namespace parlour::tools
