#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, check_finds_nothing_wrong_with_a_sound_application) {
  EXPECT_EQ(call({"check", "greeter"}), exit_code::success);
  EXPECT_EQ(out_.str(), "");
  EXPECT_EQ(err_.str(), "greeter: 0 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_says_all_that_is_wrong_at_once) {
  EXPECT_EQ(call({"check", "broken"}), exit_code::wrong);
  EXPECT_EQ(
      out_.str(),
      R"(broken/broken.xml:4:7: error: unknown element <speek> in <Entrance>, did you mean 'speak'?
    4 |       <speek param="Hello."/>
      |       ^^^^^^
broken/broken.xml:5:23: error: there is no state 'Wellcome', did you mean 'Welcome'?
    5 |       <transit state="Wellcome"/>
      |                       ^^^^^^^^
broken/broken.xml:6:29: error: a value is missing behind '+'
    6 |       <var name="x" expr="1 +"/>
      |                             ^
broken/settings.xml:1:32: error: there is no state or topic 'Nowhere' to start with
    1 | <settings name="broken" start="Nowhere">
      |                                ^^^^^^^
broken/settings.xml:2:12: error: there is no plug-in 'SQLiteDatabse', did you mean 'SQLiteDatabase'?
    2 |   <Plugins><Plugin>SQLiteDatabse</Plugin></Plugins>
      |            ^^^^^^^^
broken/settings.xml:3:39: error: there is no file 'missing.xml'
    3 |   <Scripts><Script>broken.xml</Script><Script>missing.xml</Script></Scripts>
      |                                       ^^^^^^^^
)");
  EXPECT_EQ(err_.str(), "broken: 6 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_loads_the_database_s_sql) {
  EXPECT_EQ(call({"check", "bad-sql"}), exit_code::wrong);
  EXPECT_THAT(out_.str(),
              testing::StartsWith(
                  "bad-sql/sql/schema.sql:1:1: error: 'create tabel guest "
                  "(name text);' failed: near \"tabel\": syntax error.\n"
                  "    1 | create tabel guest (name text);\n"));
  EXPECT_EQ(err_.str(), "bad-sql: 1 error, 0 warnings\n");
}

TEST_F(CommandTest, check_names_the_nearest_option) {
  EXPECT_EQ(call({"check", "bad-option"}), exit_code::wrong);
  EXPECT_THAT(out_.str(),
              testing::StartsWith(
                  "bad-option/settings.xml:5:5: error: SQLiteDatabase has no "
                  "option 'fiel', did you mean 'file'?\n"));
  EXPECT_EQ(err_.str(), "bad-option: 2 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_prints_json) {
  EXPECT_EQ(call({"check", "broken/broken.xml", "--json"}), exit_code::wrong);
  const auto all = nlohmann::json::parse(out_.str());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0]["file"], application("broken/broken.xml"));
  EXPECT_EQ(all[0]["line"], 4);
  EXPECT_EQ(all[0]["column"], 7);
  EXPECT_EQ(all[0]["end"]["column"], 13);
  EXPECT_EQ(all[0]["kind"], "error");
  EXPECT_EQ(all[0]["name"], "element");
  EXPECT_EQ(call({"check", "greeter", "--json"}), exit_code::success);
  EXPECT_EQ(out_.str(), "[]\n");
}

TEST_F(CommandTest, check_tells_what_could_be_better_about_examples) {
  EXPECT_EQ(call({"check", "bicycles", "--examples"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr(" would be understood, "));
  EXPECT_THAT(err_.str(), HasSubstr("bicycles: 0 errors"));
  EXPECT_EQ(call({"check", "greeter", "--examples"}), exit_code::success);
  EXPECT_EQ(out_.str(), "There are no examples that can be tried.\n");
  // Errors come first, and one file has no examples of its own.
  EXPECT_EQ(call({"check", "bad-sql", "--examples"}), exit_code::wrong);
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("examples")));
  EXPECT_EQ(call({"check", "broken/broken.xml", "--examples"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("is one file of it"));
  EXPECT_EQ(call({"check", "greeter", "--examples", "--json"}),
            exit_code::usage);
}

TEST_F(CommandTest, check_takes_one_file) {
  EXPECT_EQ(call({"check", "broken/broken.xml"}), exit_code::wrong);
  EXPECT_EQ(err_.str(), "broken/broken.xml: 3 errors, 0 warnings\n");
}

TEST_F(CommandTest, check_corrects_what_is_sure_until_nothing_is_left) {
  test::TemporaryFolder folder;
  places_.working = folder.path();
  // The expression is checked after the quotes are corrected.
  folder.write("a.xml", "<dialogue><function name=\"main\">\n"
                        "<let name=a expr=\"NULL\"/>\n"
                        "<if cond=\"a = 1 && a < 2\"><PRINT param=\"b\"></if>\n"
                        "</function></dialogue>\n");
  const std::string right = "<dialogue><function name=\"main\">\n"
                            "<var name=\"a\" expr=\"unknown\"/>\n"
                            "<if cond=\"a == 1 &amp;&amp; a &lt; 2\">"
                            "<print param=\"b\"/></if>\n"
                            "</function></dialogue>\n";
  EXPECT_EQ(call({"check", "a.xml", "--fix"}), exit_code::success)
      << out_.str();
  EXPECT_EQ(folder.read("a.xml"), right);
  EXPECT_THAT(err_.str(), HasSubstr("a.xml:2:11: fixed: "));
  EXPECT_THAT(err_.str(), HasSubstr("a.xml: 0 errors, 0 warnings\n"));
  EXPECT_EQ(call({"check", "a.xml", "--fix"}), exit_code::success);
  EXPECT_EQ(folder.read("a.xml"), right);
  EXPECT_EQ(err_.str(), "a.xml: 0 errors, 0 warnings\n");
}

// The error hid the warnings.
TEST_F(CommandTest, check_corrects_errors_that_hide_warnings) {
  test::TemporaryFolder folder;
  places_.working = folder.path();
  folder.write("a.xml", "<dialogue><function name=\"main\">"
                        "<var name=\"a\" expr=\"null\"/>"
                        "<var name=\"b\" expr=\"1\"/></function></dialogue>");
  EXPECT_EQ(call({"check", "a.xml", "--fix"}), exit_code::success)
      << out_.str();
  EXPECT_THAT(folder.read("a.xml"), HasSubstr("expr=\"unknown\""));
  EXPECT_THAT(err_.str(), HasSubstr("a.xml: 0 errors, 2 warnings\n"));
}

TEST_F(CommandTest, check_leaves_files_alone_unless_told) {
  test::TemporaryFolder folder;
  places_.working = folder.path();
  folder.write("a.xml", "<dialogue><var name=a/></dialogue>");
  EXPECT_EQ(call({"check", "a.xml"}), exit_code::wrong);
  EXPECT_EQ(folder.read("a.xml"), "<dialogue><var name=a/></dialogue>");
}

TEST_F(CommandTest, check_warns_and_leaves_with_success) {
  test::TemporaryFolder folder;
  places_.working = folder.path();
  folder.write("a.xml", "<dialogue><function name=\"main\">"
                        "<while cond=\"true\"/></function></dialogue>");
  EXPECT_EQ(call({"check", "a.xml"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("warning: this loop cannot end"));
  EXPECT_EQ(err_.str(), "a.xml: 0 errors, 1 warning\n");
}

TEST_F(CommandTest, check_knows_what_is_not_there) {
  EXPECT_EQ(call({"check", "nobody"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no application 'nobody'"));
}

} // namespace
} // namespace parlour::tools
