#include <gmock/gmock.h>

#include "adapters/http/rules/text_template.hpp"

namespace parlour::adapters::http {
namespace {

using Kind = TemplatePart::Kind;
using testing::ElementsAre;
using testing::HasSubstr;

TemplateNames of_request() {
  return {{"place", "when"}, true, 0, [](const std::string& name) {
            return name == "KEY" ? "geheim" : "";
          }};
}

TemplateNames of_event() {
  return {{"place"}, false, 2, {}};
}

// Each part as its kind and text, such as "0:a text".
std::vector<std::string> parts(std::string_view text,
                               const TemplateNames& names) {
  std::vector<std::string> missing;
  const auto read = read_template(text, names, missing);
  if (!read)
    return {read.error()};
  std::vector<std::string> all;
  for (const auto& part : read->parts)
    all.push_back(std::to_string(static_cast<int>(part.kind)) + ":" +
                  (part.kind == Kind::path ? part.path.text() : part.text));
  for (const auto& name : missing)
    all.push_back("missing " + name);
  return all;
}

TEST(TextTemplate, HasPlacesForValues) {
  EXPECT_THAT(parts("in {place} {when}", of_request()),
              ElementsAre("0:in ", "1:place", "0: ", "1:when"));
  EXPECT_THAT(parts("Key ${KEY}", of_request()),
              ElementsAre("0:Key ", "2:geheim"));
  EXPECT_THAT(parts("{request.id}", of_request()), ElementsAre("3:"));
  EXPECT_THAT(parts("{/a/b} {0}{2}{place}", of_event()),
              ElementsAre("4:/a/b", "0: ", "5:", "5:", "1:place"));
  EXPECT_THAT(parts("", of_event()), ElementsAre());
}

TEST(TextTemplate, OtherBracesAreBraces) {
  EXPECT_THAT(
      parts(R"({"a": {"b": "{place}"}, "c": {}})", of_request()),
      ElementsAre(R"(0:{"a": {"b": ")", "1:place", R"(0:"}, "c": {}})"));
  EXPECT_THAT(parts("{ {", of_request()), ElementsAre("0:{ {"));
  EXPECT_THAT(parts("{{place}}", of_request()),
              ElementsAre("0:{", "1:place", "0:}"));
}

TEST(TextTemplate, SaysWhatIsNotKnown) {
  EXPECT_THAT(parts("{plase}", of_request()),
              ElementsAre("'{plase}' is not known here; there are {place}, "
                          "{when}, {request.id} and ${VARIABLE}"));
  EXPECT_THAT(parts("{/a}", of_request()), ElementsAre(HasSubstr("not known")));
  EXPECT_THAT(parts("{request.id}", of_event()),
              ElementsAre(HasSubstr("not known")));
  EXPECT_THAT(parts("{3}", of_event()), ElementsAre(HasSubstr("2 groups")));
  EXPECT_THAT(parts("{1x}", of_event()), ElementsAre(HasSubstr("2 groups")));
}

TEST(TextTemplate, SecretsStayOutOfEvents) {
  EXPECT_THAT(parts("${KEY}", of_event()),
              ElementsAre(HasSubstr("cannot be a part of an event")));
}

TEST(TextTemplate, NamesWhatTheEnvironmentLacks) {
  EXPECT_THAT(parts("a ${OTHER}", of_request()),
              ElementsAre("0:a ", "2:", "missing OTHER"));
}

TEST(TextTemplate, KnowsWhatStandsBetweenQuotes) {
  std::vector<std::string> missing;
  auto read = read_template(R"({"a\"{place}": {when}, "b": "x{when}"})",
                            of_request(), missing);
  ASSERT_TRUE(read);
  mark_quoted(*read);
  std::vector<bool> quoted;
  for (const auto& part : read->parts)
    if (part.kind == Kind::parameter)
      quoted.push_back(part.is_quoted);
  EXPECT_THAT(quoted, ElementsAre(true, false, true));
}

} // namespace
} // namespace parlour::adapters::http
