#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {

using testing::HasSubstr;

class SqlLintTest : public ApplicationTest {
protected:
  std::string said(const std::string& body) {
    folder_.write("schema.sql", guest_schema);
    folder_.write("settings.xml", std::string("<settings name=\"own\">") +
                                      guest_settings +
                                      "<Scripts><Script>own.xml</Script>"
                                      "</Scripts></settings>");
    folder_.write("own.xml", "<dialogue>" + body + "</dialogue>");
    return findings(load_application(std::filesystem::canonical(folder_.path()),
                                     platform(), Scrutiny::lint));
  }
  std::string said_of_query(const std::string& attributes) {
    return said("<function name=\"main\"><param name=\"x\"/><querydb " +
                attributes + " return=\"r\"/></function>");
  }
};

TEST_F(SqlLintTest, is_silent_where_statements_fit) {
  EXPECT_EQ(said_of_query("param=\"select name from guest where name={x}\""),
            "");
  EXPECT_THAT(said_of_query("db=\"other\" param=\"select a from b\""),
              testing::Not(HasSubstr("the database says")));
}

TEST_F(SqlLintTest, names_columns_and_tables_with_their_places) {
  EXPECT_EQ(said_of_query("param=\"select nme from guest where name={x}\""),
            "own.xml:1:73: warning: the database says: no such column: nme, "
            "did you mean 'name'?\n");
  EXPECT_THAT(said_of_query("param=\"select name from guests\""),
              HasSubstr("no such table: guests, did you mean 'guest'?"));
  EXPECT_EQ(said_of_query("param=\"select name frm guest where\""),
            "own.xml:1:82: warning: the database says: near \"guest\": syntax "
            "error\n");
}

TEST_F(SqlLintTest, looks_at_topics_and_their_columns) {
  const std::string topic =
      "<topic name=\"Q\" kind=\"enquiry\"><slot name=\"Name\" "
      "type=\"Functional\" question=\"Who?\"/><query source=\"db\" "
      "param=\"select * from guest\">";
  EXPECT_EQ(said(topic + "<by slot=\"Name\" column=\"name\"/></query></topic>"),
            "");
  EXPECT_THAT(
      said(topic + "<by slot=\"Name\" column=\"nam\"/></query></topic>"),
      HasSubstr("no such column: nam, did you mean 'name'?"));
}

TEST_F(SqlLintTest, can_be_told_to_be_silent) {
  EXPECT_EQ(said("<!-- check: allow sql in this file --><function "
                 "name=\"main\"><querydb param=\"select a from b\" "
                 "return=\"r\"/></function>"),
            "");
}

} // namespace parlour::tools
