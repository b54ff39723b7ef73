#include <gmock/gmock.h>

#include "script/compiler/application/application_loader.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

class Loading : public testing::Test {
protected:
  void script(const std::string& name, const std::string& inside) {
    folder_.write(name, "<dialogue>" + inside + "</dialogue>");
  }

  // The names of the variables that the loaded documents declare, in order.
  std::vector<std::string> load(const std::string& name) {
    Findings findings;
    ApplicationLoader loader(folder_.path() / "app",
                             test::source_path("config/platform"), findings);
    loader.load_script(name, {findings.add_file("settings.xml"), 1, 1});
    findings.sort();
    lines_ = test::lines_of(findings, (folder_.path() / "app").string());
    std::vector<std::string> names;
    for (const auto& document : loader.take_documents())
      for (const auto& child : document.root.children)
        if (child.is("var"))
          names.push_back(child.value("name"));
    return names;
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> lines_;
};

} // namespace

TEST_F(Loading, reads_what_is_included_first_and_once) {
  script("app/a.xml", "<include href='sub/b.xml'/><include href='c.xml'/>"
                      "<var name='a'/>");
  script("app/sub/b.xml", "<include href='c.xml'/><var name='b'/>");
  script("app/c.xml", "<var name='c'/>");
  EXPECT_THAT(load("a.xml"), ElementsAre("c", "b", "a"));
  EXPECT_THAT(lines_, IsEmpty());
}

TEST_F(Loading, refuses_files_that_include_each_other) {
  script("app/a.xml", "<include href='b.xml'/><var name='a'/>");
  script("app/b.xml", "<include href='a.xml'/><var name='b'/>");
  EXPECT_THAT(load("a.xml"), ElementsAre("b", "a"));
  EXPECT_THAT(lines_,
              ElementsAre("b.xml:1:26: error: 'a.xml' includes this file; "
                          "files may not include each other"));
}

TEST_F(Loading, keeps_to_the_application_s_folder) {
  script("outside.xml", "<var name='o'/>");
  script("app/a.xml", "<include href='../outside.xml'/>"
                      "<include href='/etc/passwd'/>"
                      "<include href='link.xml'/>"
                      "<include href=''/>"
                      "<include href='sub/../../outside.xml'/>");
  std::filesystem::create_symlink(folder_.path() / "outside.xml",
                                  folder_.path() / "app/link.xml");
  EXPECT_THAT(load("a.xml"), IsEmpty());
  EXPECT_THAT(
      lines_,
      ElementsAre(
          "a.xml:1:26: error: '../outside.xml' leaves the application's "
          "folder",
          "a.xml:1:58: error: '/etc/passwd' must be relative to the "
          "application's folder",
          "a.xml:1:87: error: 'link.xml' leaves the application's folder",
          "a.xml:1:113: error: a file's name is empty",
          "a.xml:1:131: error: 'sub/../../outside.xml' leaves the "
          "application's folder"));
}

TEST_F(Loading, reads_the_platform_s_libraries) {
  script("app/a.xml", "<include href='parlour:names'/><include "
                      "href='parlour:nmaes'/><var name='a'/>");
  EXPECT_THAT(load("a.xml"), ElementsAre("NameVariants", "NoNames", "a"));
  EXPECT_THAT(lines_,
              ElementsAre("a.xml:1:57: error: the platform has no library "
                          "'parlour:nmaes', did you mean 'names'?"));
}

TEST_F(Loading, tells_what_is_missing_or_broken_and_goes_on) {
  script("app/a.xml", "<include href='no.xml'/><include href='bad.xml'/>"
                      "<var name='a'/>");
  folder_.write("app/bad.xml", "<dialogue>");
  EXPECT_THAT(load("a.xml"), ElementsAre("a"));
  EXPECT_THAT(lines_,
              ElementsAre("a.xml:1:26: error: there is no file 'no.xml'",
                          "bad.xml:1:11: error: the file ends while <dialogue> "
                          "of line 1 is open; expected </dialogue>"));
}

} // namespace parlour::script
