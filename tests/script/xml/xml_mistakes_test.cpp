#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "script/xml/xml_mistakes.hpp"

namespace parlour::script {

namespace {

struct Broken {
  const char* text;
  const char* said;             // "offset: message" of each, a line each
  const char* mended = nullptr; // by the corrections; null: there is none
};

void PrintTo(const Broken& broken, std::ostream* stream) {
  *stream << broken.text;
}

std::string mend(std::string text, const std::vector<XmlMistake>& mistakes) {
  for (auto mistake = mistakes.rbegin(); mistake != mistakes.rend(); ++mistake)
    if (mistake->replacement)
      text.replace(mistake->offset, mistake->length, *mistake->replacement);
  return text;
}

} // namespace

class XmlMistakes : public testing::TestWithParam<Broken> {};

TEST_P(XmlMistakes, are_told_and_mended) {
  const auto mistakes = find_xml_mistakes(GetParam().text);
  std::string said;
  for (const auto& mistake : mistakes)
    said += std::to_string(mistake.offset) + ": " + mistake.message + '\n';
  EXPECT_EQ(said, GetParam().said);
  const auto mended = mend(GetParam().text, mistakes);
  EXPECT_EQ(mended, GetParam().mended ? GetParam().mended : GetParam().text);
  if (GetParam().mended) {
    EXPECT_TRUE(find_xml_mistakes(mended).empty()) << mended;
  }
}

INSTANTIATE_TEST_SUITE_P(
    quotes, XmlMistakes,
    testing::Values(
        Broken{"<a x=1 y='2'/>", "5: a value stands in quotes: x=\"1\"\n",
               "<a x=\"1\" y='2'/>"},
        Broken{"<a x=“b c”/>",
               "5: these are typographic quotation marks; a value stands in "
               "straight ones: \"b c\"\n",
               "<a x=\"b c\"/>"},
        Broken{"<a x=\"b/>\n<c/>",
               "5: the value of 'x' has no closing quote; expected another "
               "\"\n"},
        Broken{"<a x='b 'c' d'/>",
               "8: the value of 'x' ends at this ', and more follows; inside "
               "of '…' texts stand in \"…\", and a value is embedded as "
               "{name}\n"},
        Broken{"<a x='b'y='c'/>", "7: a blank is missing behind this quote\n",
               "<a x='b' y='c'/>"},
        Broken{"<a 'b'/>", "3: a value without the name of its attribute; "
                           "expected name='b'\n"},
        Broken{"<a x/>", "3: the attribute 'x' has no value; expected "
                         "x=\"…\"\n"},
        Broken{"<a x='1', y='2'/>",
               "8: attributes are separated by blanks; leave out the ','\n",
               "<a x='1' y='2'/>"}));

INSTANTIATE_TEST_SUITE_P(
    tags, XmlMistakes,
    testing::Values(
        Broken{"<a><b></a>",
               "6: </a> does not fit: <b> of line 1 is open; expected </b>\n"},
        Broken{"<a><b></b>",
               "10: the file ends while <a> of line 1 is open; expected "
               "</a>\n"},
        Broken{"<a></a></b>", "7: </b> closes nothing: no element is open\n"},
        Broken{"<state>\n</stat>",
               "8: </stat> does not fit: <state> of line 1 is open; expected "
               "</state>\n",
               "<state>\n</state>"},
        Broken{"<a><speak param='x'></a>",
               "19: <speak> is not closed; it holds nothing and ends with "
               "'/>'\n",
               "<a><speak param='x'/></a>"},
        Broken{"<a>\n<speak param='x'\n</a>",
               "4: this tag is not closed: '>' or '/>' is missing\n"},
        Broken{"<a>1 < 2</a>",
               "5: a '<' that begins no tag is written &lt; (in an "
               "expression: lt)\n",
               "<a>1 &lt; 2</a>"},
        Broken{"<else if='x'/>", ""},
        Broken{"<a><else if cond='x'></else></a>",
               "3: 'else if' is one element: <elseif cond=\"…\">\n"}));

TEST(XmlMistakes, are_all_found_at_once) {
  EXPECT_EQ(find_xml_mistakes("<a x=1><b y=2></c></a>").size(), 4u);
}

TEST(XmlMistakes, of_any_text_end) {
  for (const auto* text : {"<", "</", "<a", "<a x", "<a x=", "<a x='", "<a \"",
                           "<a ,", "<a x=“", "<!--", "<![CDATA[", "<?", "</a"})
    EXPECT_FALSE(find_xml_mistakes(text).empty()) << text;
}

} // namespace parlour::script
