// parlour plugin list, roles, new and test, and what check reports about
// plug-ins.
#include "tests/support/sample_plugins.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using test::sample_plugins;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class PluginCommandsTest : public CommandTest {
protected:
  PluginCommandsTest() {
    places_.working = folder_.path();
    for (const auto* name : {"EchoTTS.so", "Stranger.so"}) {
      std::filesystem::create_directories(folder_.path() / "plugins");
      std::filesystem::copy_file(sample_plugins() / name,
                                 folder_.path() / "plugins" / name);
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(PluginCommandsTest, list_tells_what_there_is) {
  EXPECT_EQ(call({"plugin", "list"}), exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("PhraseNLG (NLG), part of the program\n"));
  EXPECT_THAT(out_.str(),
              HasSubstr("EchoTTS (TTS), plugins/EchoTTS.so\n"
                        "  says what it is to say as an event\n"
                        "  prefix: text; what stands before each text\n"
                        "  pace: duration, else 0ms; how long a text takes\n"
                        "  understands Whisper(text)\n"
                        "  fires Echo(text)\n"));
  EXPECT_THAT(err_.str(), HasSubstr("Stranger.so cannot be used: it is no "
                                    "plug-in of Parlour"));
}

TEST_F(PluginCommandsTest, list_looks_where_it_is_told) {
  std::filesystem::remove(folder_.path() / "plugins/Stranger.so");
  EXPECT_EQ(call({"plugin", "list", "--plugins", "elsewhere"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no folder 'elsewhere'"));
  std::filesystem::create_directories(folder_.path() / "elsewhere");
  EXPECT_EQ(call({"plugin", "list", "--plugins", "elsewhere"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("EchoTTS")));
  EXPECT_EQ(call({"plugin", "list", "--plugins", "plugins"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("EchoTTS"));
}

TEST_F(PluginCommandsTest, new_writes_files_once) {
  EXPECT_EQ(call({"plugin", "new", "MyTTS", "--role", "TTS"}),
            exit_code::success);
  EXPECT_EQ(out_.str(), "MyTTS/CMakeLists.txt\nMyTTS/my_tts.cpp\n"
                        "MyTTS/my_tts_test.cpp\nMyTTS/README.md\n");
  EXPECT_EQ(call({"plugin", "new", "MyTTS", "--role", "TTS"}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("is there already; --folder names"));
  EXPECT_EQ(call({"plugin", "new", "MyTTS", "--role", "TTS", "--folder", "b"}),
            exit_code::success);
  EXPECT_EQ(call({"plugin", "new", "MyTTS", "--role", "Balloon"}),
            exit_code::usage);
}

TEST_F(PluginCommandsTest, test_tries_a_file_and_a_name) {
  EXPECT_EQ(call({"plugin", "test", "plugins/EchoTTS.so"}), exit_code::success);
  EXPECT_EQ(out_.str(), "plugins/EchoTTS.so: conforms\n");
  EXPECT_EQ(call({"plugin", "test", "EchoTTS", "--option", "pace=1s"}),
            exit_code::success);
  EXPECT_EQ(call({"plugin", "test", "LogTaxi"}), exit_code::success)
      << out_.str();
}

TEST_F(PluginCommandsTest, test_finds_what_is_too_slow) {
  EXPECT_EQ(call({"plugin", "test", "EchoTTS", "--option", "pace=1m",
                  "--load-seconds", "0"}),
            exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("is not answered in time by Finished"));
  EXPECT_THAT(out_.str(), HasSubstr("EchoTTS: 1 wrong\n"));
}

TEST_F(PluginCommandsTest, test_refuses_what_cannot_be_tried) {
  EXPECT_EQ(call({"plugin", "test", "plugins/Stranger.so"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("it is no plug-in of Parlour"));
  EXPECT_EQ(call({"plugin", "test", "EchoTT"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'EchoTTS'?"));
  EXPECT_EQ(call({"plugin", "test", "EchoTTS", "--option", "pace=soon"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("the option 'pace' takes a time"));
  EXPECT_EQ(call({"plugin", "test", "EchoTTS", "--option", "pace"}),
            exit_code::usage);
  EXPECT_EQ(call({"plugin", "test", "EchoTTS", "--option", "pase=1s"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("EchoTTS has no option 'pase', did you "
                                    "mean 'pace'?"));
  EXPECT_EQ(call({"plugin", "test", "LogDevices"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("the option 'devices' is missing"));
}

TEST_F(PluginCommandsTest, test_says_where_a_plugin_crashes) {
  const auto file = (sample_plugins() / "Abrupt.so").string();
  EXPECT_EQ(call({"plugin", "test", file}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("Goto: it ends its process: Aborted"));
}

TEST_F(PluginCommandsTest, test_says_where_a_plugin_ends_its_process) {
  const auto file = (sample_plugins() / "Abrupt.so").string();
  EXPECT_EQ(call({"plugin", "test", file, "--option", "way=exit"}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("Goto: it ends its process with status 0"));
}

TEST_F(PluginCommandsTest, roles_tells_what_a_role_means) {
  EXPECT_EQ(call({"plugin", "roles", "Record"}), exit_code::success);
  EXPECT_THAT(out_.str(),
              AllOf(StartsWith("Microphone: hears: audio from a device\n"),
                    HasSubstr("also called  Record\n"),
                    HasSubstr("start_mic(); always answered\n"),
                    HasSubstr("SetFormat(rate, channels)\n"),
                    HasSubstr("Failed(reason); ends a request with an error")));
  EXPECT_EQ(call({"plugin", "roles"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("TTS: turns text into speech\n"));
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("Timer")));
  EXPECT_EQ(call({"plugin", "roles", "Tsx"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no role 'Tsx'"));
}

// -- an application that names a file ----------------------------------------

class FilePluginTest : public PluginCommandsTest {
protected:
  void write(const std::string& option, const std::string& command) {
    folder_.write("settings.xml",
                  "<settings name=\"echo\"><Plugins><Plugin>EchoTTS</Plugin>"
                  "</Plugins><component name=\"EchoTTS\">" +
                      option +
                      "</component><Scripts><Script>echo.xml</Script>"
                      "</Scripts></settings>");
    folder_.write("echo.xml", R"(<dialogue>
  <handler name="Loud"><messages><component>
    <ASR><RecognitionResult>
      <post module="EchoTTS" command=")" +
                                  command + R"(">
        <param expr="_LPARAM1"/><param expr="1"/>
      </post>
    </RecognitionResult></ASR>
    <EchoTTS><Echo>
      <if cond="_LPARAM1 eq 'You said: hello'"><speak param="{_LPARAM1}"/></if>
    </Echo></EchoTTS>
  </component></messages></handler>
</dialogue>
)");
  }
};

TEST_F(FilePluginTest, talks_in_a_conversation) {
  write(R"(<option name="prefix" value="You said: "/>)", "Speak");
  folder_.write("dialogues/echo.txt", "U: hello\nR: You said: hello\n");
  EXPECT_EQ(call({"test", folder_.path().string(), "--quiet"}),
            exit_code::success)
      << out_.str() << err_.str();
}

TEST_F(FilePluginTest, its_options_and_commands_are_checked) {
  write(R"(<option name="pace" value="2s"/>)", "Whisper");
  EXPECT_EQ(call({"check", folder_.path().string()}), exit_code::success)
      << out_.str();
  write(R"(<option name="pase" value="2s"/>)", "Whisper");
  EXPECT_EQ(call({"check", folder_.path().string()}), exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("settings.xml:1:92: error: EchoTTS has no "
                                    "option 'pase', did you mean 'pace'?"));
  write(R"(<option name="pace" value="slow"/>)", "Whisper");
  EXPECT_EQ(call({"check", folder_.path().string()}), exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("the option 'pace' takes a time"));
  write("", "Wisper");
  call({"check", folder_.path().string()});
  EXPECT_THAT(out_.str(), HasSubstr("EchoTTS has no command 'Wisper', did you "
                                    "mean 'Whisper'?"));
}

TEST_F(FilePluginTest, is_missed_where_its_file_is) {
  write("", "Speak");
  std::filesystem::create_directories(folder_.path() / "none");
  EXPECT_EQ(call({"check", folder_.path().string(), "--plugins", "none"}),
            exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("there is no plug-in 'EchoTTS', and no "
                                    "EchoTTS.so in "));
}

} // namespace
} // namespace parlour::tools
