#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, check_finds_nothing_wrong_with_a_sound_application) {
  EXPECT_EQ(call({"check", "greeter"}), exit_code::well);
  EXPECT_EQ(out_.str(), "");
  EXPECT_EQ(err_.str(), "greeter: 0 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_says_all_that_is_wrong_at_once) {
  EXPECT_EQ(call({"check", "broken"}), exit_code::wrong);
  const std::string script = "broken/broken.xml";
  const std::string settings = "broken/settings.xml";
  EXPECT_EQ(out_.str(),
            script +
                ":4:7: error: unknown element <speek> in <Entrance>, did you "
                "mean 'speak'?\n" +
                script +
                ":5:23: error: there is no state 'Wellcome', did you mean "
                "'Welcome'?\n" +
                script + ":6:30: error: the expression ends too early\n" +
                settings +
                ":1:32: error: there is no state or topic 'Nowhere' to "
                "start with\n" +
                settings +
                ":2:12: error: there is no plug-in 'SQLiteDatabse', did "
                "you mean 'SQLiteDatabase'?\n" +
                settings + ":3:39: error: there is no file 'missing.xml'\n");
  EXPECT_EQ(err_.str(), "broken: 6 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_loads_the_database_s_sql) {
  EXPECT_EQ(call({"check", "bad-sql"}), exit_code::wrong);
  EXPECT_EQ(out_.str(),
            "bad-sql/sql/schema.sql:1:1: error: 'create tabel guest (name "
            "text);' failed: near \"tabel\": syntax error.\n");
  EXPECT_EQ(err_.str(), "bad-sql: 1 error, 0 warnings\n");
}

TEST_F(CommandTest, check_names_the_nearest_option) {
  EXPECT_EQ(call({"check", "bad-option"}), exit_code::wrong);
  EXPECT_EQ(out_.str(),
            "bad-option/settings.xml:2:12: error: SQLiteDatabase has no option "
            "'fiel', did you mean 'file'?\n"
            "bad-option/sql/schema.sql:1:1: error: 'create tabel guest (name "
            "text);' failed: near \"tabel\": syntax error.\n");
  EXPECT_EQ(err_.str(), "bad-option: 2 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_prints_json) {
  EXPECT_EQ(call({"check", "bad-sql", "--json"}), exit_code::wrong);
  EXPECT_EQ(out_.str(),
            "[\n  {\n    \"file\": \"" + application("bad-sql/sql/schema.sql") +
                "\",\n    \"line\": 1,\n    \"column\": 1,\n"
                "    \"severity\": \"error\",\n"
                "    \"message\": \"'create tabel guest (name text);' failed: "
                "near \\\"tabel\\\": syntax error.\"\n  }\n]\n");
  EXPECT_EQ(call({"check", "greeter", "--json"}), exit_code::well);
  EXPECT_EQ(out_.str(), "[]\n");
}

TEST_F(CommandTest, check_takes_one_file) {
  EXPECT_EQ(call({"check", "broken/broken.xml"}), exit_code::wrong);
  EXPECT_EQ(out_.str(),
            "broken/broken.xml:4:7: error: unknown element <speek> in "
            "<Entrance>, did you mean 'speak'?\n"
            "broken/broken.xml:5:23: error: there is no state 'Wellcome', did "
            "you mean 'Welcome'?\n"
            "broken/broken.xml:6:30: error: the expression ends too early\n");
}

TEST_F(CommandTest, check_knows_what_is_not_there) {
  EXPECT_EQ(call({"check", "nobody"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no application 'nobody'"));
}

} // namespace
} // namespace parlour::tools
