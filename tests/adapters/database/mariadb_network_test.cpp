// A server as on another machine: reached through a port, with TLS, a user name
// and a password.
#include "adapters/database/mariadb/connection/mariadb_connection.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string keys = test::source_path("tests/fixtures/tls/");
const std::string how_many = "select count(*) from staff";

class MariaDBNetworkTest : public MariaDBTest {
protected:
  tools::MariaDBServer& server() override {
    static const test::TemporaryFolder place;
    static tools::MariaDBServer shared(
        place.path(), {{"--ssl-cert=" + keys + "server.pem",
                        "--ssl-key=" + keys + "server-key.pem"},
                       true,
                       true});
    return shared;
  }

  // root has no password.
  Options by_port(const std::string& database) {
    auto all = options_for(database);
    all.erase("socket");
    all["host"] = "127.0.0.1";
    all["port"] = std::to_string(server().port());
    return all;
  }
  Options by_tls(const std::string& database) {
    return with(with(by_port(database), "tls", "verify"), "tls-ca",
                keys + "ca.pem");
  }
  std::string cipher() {
    return query("select variable_value <> '' from "
                 "information_schema.session_status "
                 "where variable_name = 'ssl_cipher'");
  }
  // Whatever root alone may do.
  void command(const std::string& sql) {
    auto read = read_mariadb_options(by_port("test"), host.application);
    ASSERT_TRUE(read);
    MariaDBConnection root(std::make_shared<const MariaDBOptions>(*read));
    ASSERT_TRUE(
        carry_out(root, root.open(MariaDBConnection::To::server)).has_value());
    const auto done = carry_out(root, root.control(sql));
    ASSERT_TRUE(done) << done.error().message;
  }
};

TEST_F(MariaDBNetworkTest, IsReachedByItsPort) {
  ASSERT_TRUE(start(by_port("port")));
  EXPECT_EQ(query(how_many), "Result([3])");
  EXPECT_EQ(cipher(), "Result([0])");
  ASSERT_TRUE(start(with(by_port("port"), "host", "localhost")));
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBNetworkTest, SpeaksTls) {
  const auto started = start(with(by_tls("tls"), "connections", "1"));
  ASSERT_TRUE(started) << started.error().message;
  EXPECT_EQ(cipher(), "Result([1])");
  const auto connection = query("select connection_id()");
  EXPECT_EQ(write("insert into staff (name) values (?)", List{"Ong"}),
            "Result([], 1)");
  EXPECT_EQ(query("select char_length(?), char_length(repeat('x', 300000))",
                  List{std::string(200'000, 'y')}),
            "Result([200000, 300000])");
  EXPECT_EQ(query("select repeat('x', 100000)"),
            "Result([" + std::string(100'000, 'x') + "])");
  EXPECT_EQ(query("select connection_id()"), connection);
}

TEST_F(MariaDBNetworkTest, SpeaksTlsAgainWhenTheServerCameBack) {
  ASSERT_TRUE(start(by_tls("tls_again")));
  EXPECT_EQ(query(how_many), "Result([3])");
  server().kill();
  start_server();
  EXPECT_EQ(query(how_many), "Result([3])");
  EXPECT_EQ(cipher(), "Result([1])");
}

TEST_F(MariaDBNetworkTest, DoesNotTrustEverybody) {
  const auto stranger = start(with(by_port("trust"), "tls", "verify"));
  ASSERT_FALSE(stranger);
  EXPECT_EQ(stranger.error().kind, ErrorKind::refused);
  EXPECT_THAT(stranger.error().message, HasSubstr("TLS"));
  // The certificate knows 127.0.0.1 alone.
  const auto misnamed = start(with(by_tls("trust"), "host", "localhost"));
  ASSERT_FALSE(misnamed);
  EXPECT_EQ(misnamed.error().kind, ErrorKind::refused);
  ASSERT_TRUE(start(with(by_port("trust"), "tls", "encrypt")));
  EXPECT_EQ(cipher(), "Result([1])");
}

TEST_F(MariaDBNetworkTest, SaysWhereACertificateIsMissing) {
  const auto started =
      start(with(by_tls("missing"), "tls-ca", keys + "nobody.pem"));
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("TLS"));
}

TEST_F(MariaDBNetworkTest, WantsThePassword) {
  ASSERT_TRUE(start(by_port("secret")));
  const auto database = name_of("secret");
  command("create or replace user kiosk@'127.0.0.1' identified by 'geheim'");
  command("grant select on \"" + database + "\".* to kiosk@'127.0.0.1'");
  auto kiosk = with(by_port("secret"), "user", "kiosk");
  kiosk.erase("schema");
  kiosk.erase("seed");
  const auto wrong = start(with(kiosk, "password", "geraten"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, ErrorKind::refused);
  EXPECT_THAT(wrong.error().message,
              AllOf(HasSubstr("kiosk"), Not(HasSubstr("geraten"))));
  ASSERT_TRUE(start(with(kiosk, "password", "geheim")));
  EXPECT_EQ(query(how_many), "Result([3])");
  EXPECT_THAT(write("delete from staff"), StartsWith("Error(Refused, "));
  folder.write("password", "geheim\n");
  ASSERT_TRUE(start(with(kiosk, "password-file", "password")));
  EXPECT_EQ(query(how_many), "Result([3])");
}

} // namespace
} // namespace parlour::adapters
