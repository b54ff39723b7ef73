#include <chrono>
#include <csignal>

#include <unistd.h>

#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/sample_plugins.hpp"
#include "tests/tools/parlour/changed_application.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/application/plugins/process_isolation.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

using HostingTest = ChangedApplication;

PluginFactory hosted_as(const std::string& host) {
  ComponentPolicy policy;
  policy.host = host;
  return hosted(*find_plugin("PhraseNLG"), policy);
}

TEST(Hosting, LeavesAPluginInTheProgramUnlessItIsToldOtherwise) {
  EXPECT_TRUE(hosted_as("").description.is_inline);
  const auto outside = hosted_as("process");
  EXPECT_EQ(outside.description.name, "PhraseNLG");
  EXPECT_EQ(outside.description.roles,
            find_plugin("PhraseNLG")->description.roles);
  EXPECT_FALSE(outside.description.is_inline);
  EXPECT_TRUE(outside.description.blocks);
}

TEST(Hosting, AsksWhatIsOfAFileInTheTurnOnlyWhereThatIsSaid) {
  ComponentPolicy policy;
  const auto& plugin = *find_plugin("PhraseNLG");
  EXPECT_FALSE(hosted(plugin, policy, "/x/Own.so").description.is_inline);
  policy.scope.kind = Scope::Kind::in_turn;
  EXPECT_TRUE(hosted(plugin, policy, "/x/Own.so").description.is_inline);
}

TEST_F(HostingTest, RunsThePluginOfAFileOutside) {
  Catalogue plugins({test::sample_plugins()});
  ComponentPolicy policy;
  policy.host = "process";
  const auto plugin = hosted(plugins.find("EchoTTS").value(), policy,
                             plugins.file_of("EchoTTS"))
                          .create();
  test::FakePluginHost host;
  const auto started = plugin->start(host, {{"prefix", "so: "}});
  ASSERT_TRUE(started) << started.error().message;
  plugin->receive(test::message("Speak", {"Hello.", 1}));
  host.advance(Milliseconds(1));
  EXPECT_THAT(host.take_events(),
              testing::ElementsAre("Echo(so: Hello.)", "Finished(1)"));
  plugin->stop();
}

// Everything that a component can ask for: NLU with columns, NLG with phrases,
// a database in memory, a telephone with a record.
TEST_F(HostingTest, TableOneIsTheSameOutOfProcess) {
  copy("receptionist");
  change("settings.xml", R"(<component name="GrammarNLU")",
         R"(<component name="GrammarNLU" host="process")");
  change("settings.xml", R"(<component name="SQLiteDatabase")",
         R"(<component name="PhraseNLG" host="process"/>
            <component name="LogTelephone" host="process"/>
            <component name="SQLiteDatabase" host="process")");
  const auto application = load_changed();
  EXPECT_THAT(findings(application), IsEmpty());
  EXPECT_EQ(hold(application, "table-1.txt"), "");
  EXPECT_EQ(hold(application, "table-1-in-other-words.txt"), "");
}

TEST_F(HostingTest, TableOneIsTheSameWithComponentsOfItsOwn) {
  copy("receptionist");
  change("settings.xml", R"(<component name="GrammarNLU")",
         R"(<component name="GrammarNLU" scope="session")");
  change("settings.xml", R"(<component name="SQLiteDatabase")",
         R"(<component name="PhraseNLG" scope="seat"/>
            <component name="LogTelephone" scope="session"/>
            <component name="SQLiteDatabase")");
  const auto application = load_changed();
  EXPECT_THAT(findings(application), IsEmpty());
  EXPECT_EQ(hold(application, "table-1.txt"), "");
}

TEST_F(HostingTest, SaysWhyAComponentDoesNotComeUp) {
  copy("lab");
  change("settings.xml", R"(<component name="SQLiteDatabase")",
         R"(<component name="SQLiteDatabase" host="process")");
  setenv("PARLOUR_PROGRAM", "/no/such/program", 1);
  EXPECT_THAT(hold(load_changed(), "where.txt"),
              HasSubstr("SQLiteDatabase: /no/such/program does not start: No "
                        "such file"));
  setenv("PARLOUR_PROGRAM", "/bin/false", 1);
  EXPECT_THAT(hold(load_changed(), "where.txt"),
              HasSubstr("SQLiteDatabase: its process ended with status 1"));
}

// -- a process that ends in the middle of a conversation ----------------------

class KilledProcessTest : public ChangedApplication {
protected:
  void start() {
    copy("lab");
    change("settings.xml", R"(<component name="SQLiteDatabase")",
           R"(<component name="Spare" plugin="LogTelephone" host="process"
                         scope="loaded"/>
              <component name="SQLiteDatabase" host="process")");
    application_.emplace(load_changed());
    auto options =
        node_options(*application_, application_->composition,
                     {data_.path().string(),
                      parse_timestamp("2026-11-21 09:00").value(), 1});
    options.on_inspection = [this](const Inspection& seen) {
      if (seen.message && seen.message->command == "ComponentFailed")
        failures.push_back(to_string(*seen.message));
    };
    auto started = actors::Node::start(std::move(options));
    ASSERT_TRUE(started) << started.error().message;
    node_ = std::move(*started);
    seat_ = node_->open_seat(
        {[this](const SessionId&, const dialogue::Output& output) {
           said_.push_back(output.text);
         },
         {}});
    node_->open(seat_);
  }

  std::vector<std::string> say(const std::string& text) {
    said_.clear();
    node_->enter(seat_, {text});
    node_->run_until_quiet();
    return said_;
  }

  // The child process of that plug-in; -1: there is none.
  static pid_t process_of(const std::string& plugin) {
    const auto words = std::string("component") + '\0' + plugin + '\0';
    const auto ours = "\nPPid:\t" + std::to_string(getpid()) + "\n";
    for (const auto& entry : std::filesystem::directory_iterator("/proc"))
      if (read(entry.path() / "cmdline").ends_with(words) &&
          read(entry.path() / "status").find(ours) != std::string::npos)
        return std::stoi(entry.path().filename().string());
    return -1;
  }

  Expected<void> load(const std::string& plugin, const std::string& name) {
    return node_->load(plugin, name);
  }

  void wait_for_failure() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (failures.empty() && std::chrono::steady_clock::now() < end)
      node_->run_until_quiet();
  }

  std::vector<std::string> failures;

private:
  test::TemporaryFolder data_;
  std::optional<Application> application_;
  std::vector<std::string> said_;
  actors::SeatId seat_;
  std::unique_ptr<actors::Node> node_;
};

TEST_F(KilledProcessTest, IsAnEventAndAnotherTakesItsPlace) {
  start();
  EXPECT_THAT(say("where is Spot?"), Contains("Spot is in room 12."));
  const auto before = process_of("SQLiteDatabase");
  ASSERT_GT(before, 0);
  ASSERT_EQ(kill(before, SIGKILL), 0);
  wait_for_failure();
  EXPECT_THAT(failures, Contains(HasSubstr("its process was killed by signal 9 "
                                           "(Killed)")));
  EXPECT_THAT(say("where is Rover?"), Contains("Rover is in room 12."));
  EXPECT_NE(process_of("SQLiteDatabase"), before);
}

// A component that a script loads keeps what the settings say about it.
TEST_F(KilledProcessTest, WhatIsLoadedRunsWhereItsSettingsSay) {
  start();
  EXPECT_EQ(process_of("LogTelephone"), -1);
  const auto loaded = load("LogTelephone", "Spare");
  ASSERT_TRUE(loaded) << loaded.error().message;
  const auto process = process_of("LogTelephone");
  ASSERT_GT(process, 0);
  ASSERT_EQ(kill(process, SIGKILL), 0);
  wait_for_failure();
  EXPECT_THAT(failures, Contains(HasSubstr("System.ComponentFailed(Spare")));
}

} // namespace
} // namespace parlour::tools
