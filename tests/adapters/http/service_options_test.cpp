#include <gmock/gmock.h>

#include "adapters/http/service_options.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::http {
namespace {

using testing::HasSubstr;

class ServiceOptionsTest : public testing::Test {
protected:
  Expected<ServiceOptions> read(const Options& options) {
    return read_service_options(options, folder.path().string());
  }
  test::TemporaryFolder folder;
};

TEST_F(ServiceOptionsTest, HaveDefaults) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->client.timeout, Milliseconds(8'000));
  EXPECT_EQ(options->client.transfer.max_answer, 1u << 20);
  EXPECT_EQ(options->client.connections, 8u);
  EXPECT_EQ(options->client.breaker.failures, 5u);
  EXPECT_FALSE(options->samples);
}

TEST_F(ServiceOptionsTest, AreRead) {
  folder.write("ca.pem", "");
  const auto options = read({{"timeout", "500ms"},
                             {"retries", "0"},
                             {"samples", "true"},
                             {"ca", "ca.pem"},
                             {"failures", "0"},
                             {"pause", "1m"}});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->client.timeout, Milliseconds(500));
  EXPECT_EQ(options->client.exchange.retry.retries, 0u);
  EXPECT_EQ(options->client.breaker.pause, Milliseconds(60'000));
  EXPECT_EQ(options->client.transfer.authority.filename(), "ca.pem");
  EXPECT_TRUE(options->samples);
}

TEST_F(ServiceOptionsTest, HaveBounds) {
  auto error = [this](const std::string& name, const std::string& value) {
    const auto options = read({{name, value}});
    return options ? "" : options.error().message;
  };
  EXPECT_THAT(error("connections", "0"), HasSubstr("from 1 to 100"));
  EXPECT_THAT(error("retries", "11"), HasSubstr("from 0 to 10"));
  EXPECT_THAT(error("max-bytes", "-1"), HasSubstr("from 1 to"));
  EXPECT_THAT(error("timeout", "0s"), HasSubstr("a time from 1ms, not '0s'"));
  EXPECT_THAT(error("ca", "../x"), HasSubstr("ca"));
  EXPECT_NE(error("ca", "none.pem"), "");
}

TEST_F(ServiceOptionsTest, SayWhereWebhooksAreHeard) {
  ServiceRules rules;
  auto error = [&](const Options& options) {
    const auto checked = check_webhooks(read(options).value(), rules);
    return checked ? "" : checked.error().message;
  };
  EXPECT_EQ(error({}), "");
  rules.webhooks.push_back({"/a", {}, {}});
  EXPECT_THAT(error({}), HasSubstr("the option 'listen' says where"));
  EXPECT_EQ(error({{"samples", "true"}}), "");
  EXPECT_EQ(error({{"listen", "127.0.0.1:80"}}), "");
  EXPECT_THAT(error({{"listen", "0.0.0.0:80"}}), HasSubstr("'token'"));
  EXPECT_EQ(error({{"listen", "0.0.0.0:80"}, {"token", "t"}}), "");
}

TEST_F(ServiceOptionsTest, NameTheFileOfRules) {
  auto load = [this](const Options& options) {
    return load_service_rules(options, folder.path().string(), {});
  };
  EXPECT_FALSE(load({}));
  EXPECT_FALSE(load({{"rules", "none.xml"}}));
  EXPECT_THAT(load({{"rules", "../a.xml"}}).error()[0].message,
              HasSubstr("rules"));
  folder.write("a.xml", "<service><command name='A'><get url='/x'/>"
                        "<on><event name='E'/></on></command></service>");
  EXPECT_FALSE(load({{"rules", "a.xml"}})); // no address
  const auto rules = load({{"rules", "a.xml"}, {"address", "http://b.com"}});
  ASSERT_TRUE(rules);
  EXPECT_EQ(rules->rules.commands[0].request.server, "b.com");
}

} // namespace
} // namespace parlour::adapters::http
