#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/mariadb_options.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::Not;
using Tls = MariaDBOptions::Tls;

Expected<MariaDBOptions> read(const Options& options) {
  return read_mariadb_options(options, "/application");
}

TEST(MariaDBOptions, HoldWithoutSettings) {
  const auto options = read({{"database", "lab"}});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->host, "localhost");
  EXPECT_EQ(options->port, 0u);
  EXPECT_EQ(options->connections, 4u);
  EXPECT_EQ(options->query_timeout, Milliseconds(5'000));
  EXPECT_EQ(options->tls, Tls::off);
  EXPECT_FALSE(options->copy);
}

TEST(MariaDBOptions, TakeTheNameOfSQLitesFile) {
  EXPECT_EQ(read({{"file", "receptionist.db"}})->database, "receptionist");
  EXPECT_EQ(read({{"file", "lab.db"}, {"database", "b"}})->database, "b");
}

TEST(MariaDBOptions, NameTheOptionThatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> all{
      {"database", "a\"b"},        {"database", ""},   {"port", "many"},
      {"port", "70000"},           {"tls", "perhaps"}, {"connections", "0"},
      {"query-timeout", "soon"},   {"copy", "yes"},    {"max-rows", "-1"},
      {"password-file", "nowhere"}};
  for (const auto& [name, value] : all) {
    Options options{{"database", "lab"}};
    options[name] = value;
    const auto wrong = read(options);
    ASSERT_FALSE(wrong) << name << " = " << value;
    EXPECT_EQ(wrong.error().kind, ErrorKind::settings);
    EXPECT_THAT(wrong.error().message, HasSubstr("option '" + name + "'"));
  }
}

TEST(MariaDBOptions, VerifyOtherMachines) {
  EXPECT_EQ(read({{"database", "a"}, {"host", "db.lan"}})->tls, Tls::verify);
  EXPECT_EQ(read({{"database", "a"}, {"host", "127.0.0.1"}})->tls, Tls::off);
  EXPECT_EQ(read({{"database", "a"}, {"tls", "encrypt"}})->tls, Tls::encrypt);
}

TEST(MariaDBOptions, ReadThePasswordsFile) {
  const test::TemporaryFolder folder;
  for (const auto* text : {"swordfish", "swordfish\n", "swordfish\r\n"}) {
    folder.write("secret", text);
    const auto options =
        read_mariadb_options({{"database", "a"}, {"password-file", "secret"}},
                             folder.path().string());
    ASSERT_TRUE(options);
    EXPECT_EQ(options->password, "swordfish");
  }
}

TEST(MariaDBOptions, SayNothingOfThePassword) {
  const auto wrong = read({{"database", "a"},
                           {"password", "swordfish"},
                           {"password-file", "nowhere"}});
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, Not(HasSubstr("swordfish")));
}

} // namespace
} // namespace parlour::adapters
