// The rules of XML 1.0 that the parser does not check.
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "script/xml/well_formed.hpp"

namespace parlour::script {

namespace {

struct Fault {
  const char* text;
  const char* said;             // "offset: message" of each, a line each
  const char* mended = nullptr; // by the corrections; null: there is none
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.text;
}

std::string mend(std::string text, const std::vector<XmlMistake>& faults) {
  for (auto fault = faults.rbegin(); fault != faults.rend(); ++fault)
    if (fault->replacement)
      text.replace(fault->offset, fault->length, *fault->replacement);
  return text;
}

} // namespace

class WellFormed : public testing::TestWithParam<Fault> {};

TEST_P(WellFormed, is_told_with_place_and_way_out) {
  const auto faults = find_faults(GetParam().text);
  std::string said;
  for (const auto& fault : faults)
    said += std::to_string(fault.offset) + ": " + fault.message + '\n';
  EXPECT_EQ(said, GetParam().said);
  const auto mended = mend(GetParam().text, faults);
  EXPECT_EQ(mended, GetParam().mended ? GetParam().mended : GetParam().text);
  if (GetParam().mended) {
    EXPECT_TRUE(find_faults(mended).empty()) << mended;
  }
}

INSTANTIATE_TEST_SUITE_P(
    references, WellFormed,
    testing::Values(
        Fault{"<a b='&amp; &#233; &#xE9; &lt; &gt; &quot; &apos;'>&#x9;</a>",
              ""},
        Fault{"<a b='x & y'/>",
              "8: '&' must be written &amp; (in an expression: and)\n",
              "<a b='x &amp; y'/>"},
        Fault{"<a>AT&T</a>",
              "5: '&' must be written &amp; (in an expression: and)\n",
              "<a>AT&amp;T</a>"},
        Fault{"<a b='x && y'/>",
              "8: '&&' must be written &amp;&amp; (in an expression: and)\n",
              "<a b='x &amp;&amp; y'/>"},
        Fault{"<a b='x &lt y'/>", "8: ';' is missing: expected &lt;\n",
              "<a b='x &lt; y'/>"},
        Fault{"<a>&nbsp;</a>",
              "3: there is no &nbsp; in XML: write the character itself\n"},
        Fault{"<a>&#0;</a>", "3: &#0; is a character that XML does not allow; "
                             "take it out\n"},
        Fault{"<a>&#x1;</a>", "3: &#x1; is a character that XML does not "
                              "allow; take it out\n"},
        Fault{"<a>&#xD800;</a>", "3: &#xD800; is a character that XML does "
                                 "not allow; take it out\n"},
        Fault{"<a b='&#xFFFF;'/>", "6: &#xFFFF; is a character that XML does "
                                   "not allow; take it out\n"},
        Fault{"<a b='&#x110000;'/>", "6: &#x110000; is a character that XML "
                                     "does not allow; take it out\n"},
        Fault{"<a>&#99999999999;</a>",
              "3: &#99999999999; is a character that XML does not allow; take "
              "it out\n"},
        Fault{"<a>&#65 b</a>", "3: ';' is missing behind &#65\n",
              "<a>&#65; b</a>"},
        Fault{"<a>&#X41;</a>", "3: &#X41; is written &#x41;\n"},
        Fault{"<a>&#;</a>", "3: &#; is no character; expected its number, "
                            "such as &#233; or &#xe9;\n"}));

INSTANTIATE_TEST_SUITE_P(
    values_and_texts, WellFormed,
    testing::Values(
        Fault{"<a b='x < y'/>",
              "8: '<' in a value must be written &lt; (in an expression: "
              "lt)\n",
              "<a b='x &lt; y'/>"},
        Fault{"<a b='>]]>'>></a>", ""},
        Fault{"<a>x]]>y</a>", "4: ']]>' in a text is written ]]&gt;\n",
              "<a>x]]&gt;y</a>"},
        Fault{"<a><![CDATA[& < <b ]] --]]></a>", ""}));

INSTANTIATE_TEST_SUITE_P(
    comments, WellFormed,
    testing::Values(
        Fault{"<a><!----><!-- & < - <b> --></a>", ""},
        Fault{"<!-- a -- b --><a/>",
              "7: '--' may not stand in a comment; put a blank between the "
              "dashes\n",
              "<!-- a - - b --><a/>"},
        Fault{"<!-------- a --><a/>",
              "4: '--' may not stand in a comment; put a blank between the "
              "dashes\n",
              "<!--- - - - - - a --><a/>"},
        Fault{"<!-- a ---><a/>",
              "7: '--' may not stand in a comment; put a blank between the "
              "dashes\n",
              "<!-- a - --><a/>"},
        Fault{"<!-- a --\n<a/><!-- b -->",
              "7: a comment ends with '-->': '>' is missing here\n"
              "14: a comment cannot stand in another one, which would end at "
              "the first '-->'\n"},
        Fault{"<!-- a <!-- b --><a/>",
              "7: a comment cannot stand in another one, which would end at "
              "the first '-->'\n"}));

INSTANTIATE_TEST_SUITE_P(
    instructions, WellFormed,
    testing::Values(
        Fault{"<?xml version='1.0'?><a/>", ""},
        Fault{"<?xml version = \"1.1\" encoding='utf-8' standalone='no' ?>\n"
              "<?xml-model href='parlour.rng'?><a><?x y?></a>",
              ""},
        Fault{"\n <?xml version='1.0'?><a/>",
              "0: the XML declaration stands at the very beginning of a file; "
              "take the blanks before it out\n",
              "<?xml version='1.0'?><a/>"},
        Fault{"<!-- x --><?xml version='1.0'?><a/>",
              "10: an XML declaration stands at the very beginning of a file; "
              "take this one out\n",
              "<!-- x --><a/>"},
        Fault{"<a><?XML x?></a>",
              "3: an XML declaration stands at the very beginning of a file; "
              "take this one out\n",
              "<a></a>"},
        Fault{"<?xml encoding='UTF-8'?><a/>",
              "0: the XML declaration is written <?xml version=\"1.0\" "
              "encoding=\"UTF-8\"?>; it may be left out\n",
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?><a/>"},
        Fault{"<?xml version='1.0' standalone='no' encoding='UTF-8'?><a/>",
              "0: the XML declaration is written <?xml version=\"1.0\" "
              "encoding=\"UTF-8\"?>; it may be left out\n",
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?><a/>"},
        Fault{"<?xml version='1.0'encoding='UTF-8'?><a/>",
              "0: the XML declaration is written <?xml version=\"1.0\" "
              "encoding=\"UTF-8\"?>; it may be left out\n",
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?><a/>"},
        Fault{"<?xml version='3'?><a/>",
              "15: there is no version '3' of XML; expected 1.0\n",
              "<?xml version='1.0'?><a/>"},
        Fault{"<?xml version='1.0' encoding='ISO-8859-1'?><a/>",
              "30: this file says that it is written in 'ISO-8859-1'; save it "
              "as UTF-8 and write encoding=\"UTF-8\"\n",
              "<?xml version='1.0' encoding='UTF-8'?><a/>"},
        Fault{"<?xml version='1.0' encoding='ISO-8859-1'?><a>é</a>",
              "30: this file says that it is written in 'ISO-8859-1'; save it "
              "as UTF-8 and write encoding=\"UTF-8\"\n"},
        Fault{"<?xml version='1.0' standalone='maybe'?><a/>",
              "32: standalone is yes or no, not 'maybe'; it may be left "
              "out\n"},
        Fault{"<? x?><a/>", "2: the name of an instruction is missing here\n"},
        Fault{"<?1 x?><a/>",
              "2: '1' cannot be the name of an instruction: a name begins "
              "with a letter or _, and goes on with letters, digits, _, - or "
              ".\n"}));

INSTANTIATE_TEST_SUITE_P(
    names, WellFormed,
    testing::Values(
        Fault{"<é.1-ü·><名前 b:c='' _='' ></名前 ></é.1-ü·>", ""},
        Fault{"<a×b/>",
              "1: 'a×b' cannot be the name of an element: a name begins with "
              "a letter or _, and goes on with letters, digits, _, - or .\n"},
        Fault{"<a\n÷='1'/>",
              "3: '÷' cannot be the name of an attribute: a name begins with "
              "a letter or _, and goes on with letters, digits, _, - or "
              ".\n"}));

TEST(FindFaults, of_any_text_ends) {
  for (const auto* text : {"", "<", "</", "<a", "<a b", "<a b=", "<a b='",
                           "<a b='&", "<!--", "<!-", "<!---", "<![CDATA[", "<?",
                           "<?xml ", "<?xml version", "&", "&#", "]]>", "</a"})
    EXPECT_LT(find_faults(text).size(), 3u) << text;
}

} // namespace parlour::script
