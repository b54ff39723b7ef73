#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/mqtt/mqtt_fixture.hpp"
#include "tests/support/no_descriptors.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// -- with a server that behaves -----------------------------------------------

TEST_F(MosquittoTest, SwitchesALampThatAnnouncesItself) {
  Home home(server_options(server.port()));
  announce(home);
  home.publish("kitchen/lamp", R"({"state": "OFF", "brightness": 7})", true);
  home.subscribe("kitchen/lamp/set");
  ASSERT_TRUE(start(options(server.port())));
  EXPECT_EQ(ask("lamp", "kitchen"), "State lamp kitchen off");
  send("Set", {"lamp", "kitchen", "on"});
  EXPECT_TRUE(home.wait(R"(kitchen/lamp/set {"state":"ON"})"));
  home.publish("kitchen/lamp", R"({"state": "ON", "brightness": 7})", true);
  EXPECT_EQ(next(), "State lamp kitchen on");
  EXPECT_EQ(ask("lamp", "kitchen"), "State lamp kitchen on");
}

TEST_F(MosquittoTest, LearnsOfDevicesThatComeLater) {
  Home home(server_options(server.port()));
  ASSERT_TRUE(start(options(server.port())));
  EXPECT_EQ(ask("lamp", "kitchen"), "Failed There is no 'lamp' in 'kitchen'.");
  home.subscribe("kitchen/lamp/set");
  announce(home);
  home.publish("kitchen/lamp", R"({"state": "OFF"})", true);
  while (ask("lamp", "kitchen") != "State lamp kitchen off")
    ASSERT_FALSE(HasFailure());
}

TEST_F(MosquittoTest, ALockIsOpenOnlyWhenItSaysSo) {
  Home home(server_options(server.port()));
  announce(home);
  home.publish("front/state", "LOCKED", true);
  home.subscribe("front/set");
  ASSERT_TRUE(start(with(options(server.port()), "answer-timeout", "300ms")));
  EXPECT_EQ(set("door", "hall", "open"),
            "Failed The door in the hall does not answer.");
  EXPECT_TRUE(home.wait("front/set UNLOCK"));
  plugin = nullptr;
  ASSERT_TRUE(start(options(server.port())));
  send("Set", {"door", "hall", "open"});
  EXPECT_TRUE(home.wait("front/set UNLOCK"));
  home.publish("front/state", "UNLOCKED");
  EXPECT_EQ(next(), "State door hall open");
}

TEST_F(MosquittoTest, WhatIsSwitchedOffDoesNotAnswer) {
  Home home(server_options(server.port()));
  announce(home);
  home.publish("kitchen/lamp", R"({"state": "OFF"})", true);
  home.publish("kitchen/lamp/there", R"({"state": "offline"})", true);
  ASSERT_TRUE(start(options(server.port())));
  while (set("lamp", "kitchen", "on") !=
         "Failed The lamp in the kitchen does not answer.")
    ASSERT_FALSE(HasFailure());
}

TEST_F(MosquittoTest, TellsThatSomebodyRings) {
  Home home(server_options(server.port()));
  home.publish("homeassistant/binary_sensor/bell/config",
               R"({"stat_t": "bell", "name": "Doorbell", "off_dly": 1,
                   "dev": {"sa": "Hall"}})",
               true);
  home.publish("bell", "OFF", true);
  ASSERT_TRUE(start(options(server.port())));
  EXPECT_EQ(ask("bell", "hall"), "State bell hall off");
  home.publish("bell", "ON");
  EXPECT_EQ(next(), "unasked State bell hall on");
  home.publish("bell", "ON");
  EXPECT_EQ(next(), "unasked State bell hall on");
}

// Commands without number, and devices without end: nothing is lost on the way.
TEST_F(MosquittoTest, AnswersEveryRequest) {
  Home home(server_options(server.port()));
  for (int i = 0; i < 50; ++i)
    home.publish("homeassistant/light/" + std::to_string(i) + "/config",
                 R"({"cmd_t": "c/)" + std::to_string(i) +
                     R"(", "dev": {"sa": "Room )" + std::to_string(i) +
                     R"("}})",
                 true);
  ASSERT_TRUE(start(options(server.port())));
  ASSERT_TRUE(logs("50 devices are known"));
  for (int i = 0; i < 500; ++i)
    send("Set", {"lamp", "room " + std::to_string(i % 50), "on"});
  for (int i = 0; i < 500; ++i)
    EXPECT_THAT(next(), StartsWith("State lamp room "));
}

TEST_F(MosquittoTest, ComesBackWithTheServer) {
  ASSERT_TRUE(start(options(server.port())));
  EXPECT_TRUE(logs("connected to"));
  server.kill();
  EXPECT_TRUE(is_available(false));
  EXPECT_THAT(ask("lamp", "kitchen"),
              StartsWith("Failed The devices' server cannot be reached"));
  server.start();
  EXPECT_TRUE(is_available(true));
  Home home(server_options(server.port()));
  announce(home);
  home.publish("kitchen/lamp", R"({"state": "ON"})", true);
  while (ask("lamp", "kitchen") != "State lamp kitchen on")
    ASSERT_FALSE(HasFailure());
}

// The time of a script may be virtual; the server's is not.
TEST_F(MosquittoTest, AnswersOneByOne) {
  Home home(server_options(server.port()));
  announce(home);
  home.publish("kitchen/lamp", R"({"state": "OFF"})", true);
  ASSERT_TRUE(start(with(options(server.port()), "one-by-one", "true")));
  send("Ask", {"lamp", "kitchen"});
  EXPECT_EQ(host.take_events().size(), 1u);
}

class PasswordTest : public MosquittoTest {
protected:
  void SetUp() override {
    if (!test::MosquittoServer::program().empty())
      guarded.add_user("parlour", "open sesame");
    start(guarded);
  }
  Options login(const std::string& password) {
    return with(with(options(guarded.port()), "user", "parlour"), "password",
                password);
  }

  test::MosquittoServer guarded{"allow_anonymous false\n"
                                "password_file FOLDER/users\n"};
};

TEST_F(PasswordTest, NeedsTheRightOne) {
  ASSERT_TRUE(start(login("wrong secret")));
  EXPECT_TRUE(logs("this user in"));
  EXPECT_TRUE(is_available(false));
  for (const auto& line : logged)
    EXPECT_EQ(line.find("wrong secret"), std::string::npos);
  plugin = nullptr;
  ASSERT_TRUE(start(login("open sesame")));
  EXPECT_TRUE(logs("connected to"));
}

class TlsTest : public MosquittoTest {
protected:
  void SetUp() override {
    start(encrypted);
  }

  const std::string keys = test::source_path("tests/fixtures/tls/");
  test::MosquittoServer encrypted{"allow_anonymous true\ncertfile " + keys +
                                  "server.pem\nkeyfile " + keys +
                                  "server-key.pem\n"};
};

TEST_F(TlsTest, ConnectsToWhomItTrusts) {
  const auto plain = options(encrypted.port());
  ASSERT_TRUE(start(with(plain, "tls-ca", keys + "ca.pem")));
  EXPECT_TRUE(logs("connected to the MQTT server 127.0.0.1"));
  EXPECT_THAT(ask("lamp", "kitchen"), HasSubstr("There is no"));
  plugin = nullptr;
  logged.clear();
  ASSERT_TRUE(start(with(plain, "tls", "encrypt")));
  EXPECT_TRUE(logs("connected to"));
}

TEST_F(TlsTest, ConnectsToNobodyElse) {
  const auto plain = options(encrypted.port());
  // The machine's own authorities have not signed it.
  ASSERT_TRUE(start(with(plain, "tls", "verify")));
  EXPECT_TRUE(logs("cannot be reached"));
  EXPECT_TRUE(is_available(false));
  plugin = nullptr;
  logged.clear();
  // The certificate is for the address, not for the name.
  ASSERT_TRUE(
      start(with(with(plain, "host", "localhost"), "tls-ca", keys + "ca.pem")));
  EXPECT_TRUE(logs("host name verification failed"));
  plugin = nullptr;
  logged.clear();
  ASSERT_TRUE(start(plain));
  EXPECT_TRUE(logs("cannot be reached"));
}

// -- the plug-in --------------------------------------------------------------

TEST_F(MQTTTest, Conforms) {
  TestOptions terms;
  // Nobody listens on port 1.
  terms.options = options(1);
  terms.data_folder = folder.path().string();
  terms.application_folder = folder.path().string();
  EXPECT_THAT(conformance_errors(mqtt_devices_factory(), terms), IsEmpty());
}

TEST_F(MQTTTest, DoesNotStartWithWrongSettings) {
  const auto mistake = [&](const std::string& name, const std::string& value) {
    const auto started = start(with(options(1), name, value));
    return started ? "none" : to_string(started.error());
  };
  EXPECT_THAT(mistake("devices", "nothing.tsv"), HasSubstr("nothing.tsv"));
  EXPECT_THAT(mistake("tls-ca", "/nowhere/ca.pem"), HasSubstr("/nowhere"));
  EXPECT_EQ(mistake("host", "no..such"), "none");
  EXPECT_TRUE(logs("'no..such' is not found"));
}

TEST_F(MQTTTest, DoesNotStartWithoutDescriptors) {
  plugin = mqtt_devices_factory().create();
  const test::NoDescriptors none;
  EXPECT_FALSE(plugin->start(host, {}));
}

TEST_F(MQTTTest, RefusesBeforeAndAfter) {
  ASSERT_TRUE(start(options(1)));
  plugin->stop();
  EXPECT_EQ(ask("lamp", "kitchen"), "Failed The component is stopped.");
}

} // namespace
} // namespace parlour::adapters::mqtt
