#include "tests/script/lint/lint_case.hpp"

namespace parlour::script::lint {
namespace {

// The understanding knows the names of guests, by a slot, and their rooms, by a
// grammar.
std::string linted(const std::string& sql, const std::string& before = "") {
  return lints_of(
      "<topic name='Q'><slot name='Name' type='Functional' question='Who?'>"
      "<cardinality type='query' source='db:guest.name'/></slot></topic>"
      "<grammar name='g'>public &lt;x&gt; = in @db:guest.room {topic=Q};"
      "</grammar>\n"
      "<function name='main'><param name='x'/><connectdb name='desk' param='' "
      "write='true'/>" +
      before + "\n<querydb db='desk' param='" + sql + "'/></function>");
}

TEST(ColumnLints, WarnWhereScriptsChangeWhatIsUnderstood) {
  for (const auto* sql : {"insert into guest (name) values ({x})",
                          "delete from Guest where id={x}",
                          "update guest set paid=max(1, 2), room={x}",
                          "update \"guest\" set name={x}"})
    EXPECT_EQ(linted(sql), "5:27 changing-values") << sql;
}

TEST(ColumnLints, AreSilentAboutOtherColumnsAndTables) {
  for (const auto* sql :
       {"update guest set paid={x} where room=1", "select name from guest",
        "insert into visit (name) values ({x})"})
    EXPECT_EQ(linted(sql), "") << sql;
}

TEST(ColumnLints, AreSilentAboutOtherDatabases) {
  EXPECT_EQ(linted("delete from guest",
                   "<connectdb name='desk' param='Archive' write='true'/>"),
            "");
}

} // namespace
} // namespace parlour::script::lint
