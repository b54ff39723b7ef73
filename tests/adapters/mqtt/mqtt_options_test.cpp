#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/mqtt_options.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::HasSubstr;
using Tls = ServerOptions::Tls;

const std::string keys = test::source_path("tests/fixtures/tls/");

class MQTTOptionsTest : public testing::Test {
protected:
  Expected<MQTTOptions> read(const Options& options) {
    return read_mqtt_options(options, folder.path().string());
  }
  MQTTOptions made(const Options& options) {
    const auto all = read(options);
    EXPECT_TRUE(all) << all.error().message;
    return all.value_or(MQTTOptions());
  }
  std::string mistake(const Options& options) {
    const auto all = read(options);
    return all ? "none" : all.error().message;
  }

  test::TemporaryFolder folder;
};

TEST_F(MQTTOptionsTest, HaveDefaults) {
  const auto all = made({});
  EXPECT_EQ(all.server.host, "localhost");
  EXPECT_EQ(all.server.port, 1883);
  EXPECT_EQ(all.server.tls, Tls::off);
  EXPECT_EQ(all.server.keep_alive, Milliseconds(30'000));
  EXPECT_EQ(all.policy.prefix, "homeassistant");
  EXPECT_EQ(all.policy.patience, Milliseconds(5'000));
  EXPECT_TRUE(all.devices.empty());
  EXPECT_FALSE(all.one_by_one);
}

// Encryption follows from a certificate or from the port that is meant for it.
TEST_F(MQTTOptionsTest, Tls) {
  EXPECT_EQ(made({{"tls-ca", keys + "ca.pem"}}).server.tls, Tls::verify);
  EXPECT_EQ(made({{"tls-ca", keys + "ca.pem"}}).server.port, 8883);
  EXPECT_EQ(made({{"port", "8883"}}).server.tls, Tls::verify);
  EXPECT_EQ(made({{"port", "8883"}, {"tls", "off"}}).server.tls, Tls::off);
  EXPECT_EQ(made({{"tls", "encrypt"}}).server.port, 8883);
  EXPECT_EQ(made({{"tls", "verify"}, {"port", "99"}}).server.port, 99);
}

TEST_F(MQTTOptionsTest, Login) {
  folder.write("secret", "open sesame\n");
  const auto all =
      made({{"user", "parlour"}, {"password-file", "secret"}}).server;
  EXPECT_EQ(all.user, "parlour");
  EXPECT_EQ(all.password, "open sesame");
}

TEST_F(MQTTOptionsTest, Mistakes) {
  EXPECT_THAT(mistake({{"port", "0"}}), HasSubstr("'port'"));
  EXPECT_THAT(mistake({{"port", "65536"}}), HasSubstr("'port'"));
  EXPECT_THAT(mistake({{"port", "mqtt"}}), HasSubstr("'port'"));
  EXPECT_THAT(mistake({{"tls", "maybe"}}), HasSubstr("'tls'"));
  EXPECT_THAT(mistake({{"keep-alive", "1s"}}), HasSubstr("'keep-alive'"));
  EXPECT_THAT(mistake({{"keep-alive", "48h"}}), HasSubstr("'keep-alive'"));
  EXPECT_THAT(mistake({{"connect-timeout", "0s"}}),
              HasSubstr("'connect-timeout'"));
  EXPECT_THAT(mistake({{"pause", "0s"}}), HasSubstr("'pause'"));
  EXPECT_THAT(mistake({{"discovery", "home/#"}}), HasSubstr("'discovery'"));
  EXPECT_THAT(mistake({{"discovery", "home/"}}), HasSubstr("'discovery'"));
  EXPECT_THAT(mistake({{"devices", "../devices.tsv"}}), HasSubstr("'devices'"));
  EXPECT_THAT(mistake({{"tls-ca", "/nowhere"}}), HasSubstr("/nowhere"));
  EXPECT_THAT(mistake({{"tls-certificate", keys + "server.pem"}}),
              HasSubstr("'tls-key'"));
  EXPECT_THAT(mistake({{"tls-certificate", keys + "server.pem"},
                       {"tls-key", keys + "server-key.pem"}}),
              HasSubstr("'tls-ca'"));
}

// No message contains a secret.
TEST_F(MQTTOptionsTest, KeepSecrets) {
  folder.write("secret", "open sesame\n");
  for (const auto& text :
       {mistake({{"password", "open sesame"}}),
        mistake({{"user", "x"},
                 {"password", "open sesame"},
                 {"password-file", "secret"}}),
        mistake({{"user", "x"}, {"password-file", "none"}})}) {
    EXPECT_THAT(text, HasSubstr("option 'password"));
    EXPECT_EQ(text.find("sesame"), std::string::npos) << text;
  }
}

} // namespace
} // namespace parlour::adapters::mqtt
