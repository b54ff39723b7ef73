#include <fstream>

#include <gtest/gtest.h>

#include "adapters/nlu/forms/first_words.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::nlu {
namespace {

// "~" before what is weak, "" for none.
std::string read(Form form, const std::string& words) {
  const auto tokens = tokenize(words);
  const auto now = *parse_timestamp("2026-11-21 09:00"); // a Saturday
  const auto found = form_at(form, tokens, 0, now);
  if (!found || found->length != tokens.list.size())
    return "";
  return (found->weak ? "~" : "") + found->value.text();
}

// "form: words = value" of forms.txt, a line each.
struct Line {
  std::string form, words, expected;
};

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  const auto end = text.find_last_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<Line> table() {
  std::ifstream file(
      parlour::test::source_path("tests/adapters/nlu/forms.txt"));
  std::vector<Line> lines;
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    const auto equals = line.rfind('=');
    if (line.starts_with('#') || colon == std::string::npos)
      continue;
    lines.push_back({line.substr(0, colon),
                     trimmed(line.substr(colon + 2, equals - colon - 2)),
                     trimmed(line.substr(equals + 1))});
  }
  return lines;
}

TEST(Forms, OfADeskAreRead) {
  const auto lines = table();
  EXPECT_GE(lines.size(), 200U);
  for (const auto& line : lines) {
    const auto form = form_of(line.form);
    ASSERT_TRUE(form) << line.form;
    EXPECT_EQ(read(*form, line.words), line.expected)
        << line.form << ": " << line.words;
  }
}

// What is said anew ends the clause, or it is something else.
TEST(Forms, AreMendedAtTheEndOfAClauseAlone) {
  const auto value = [](Form form, const char* words) {
    const auto found = form_at(form, tokenize(words), 0, {});
    return found ? found->value : Value();
  };
  const auto number = [&](const char* words) {
    return value(Form::number, words);
  };
  EXPECT_EQ(number("two oh six eight seven, sorry, nine, please"), 20689);
  EXPECT_EQ(number("two oh six eight seven, sorry, nine please"), 20689);
  EXPECT_EQ(number("two oh six eight seven, no, one moment"), 20687);
  EXPECT_EQ(number("two oh four, sorry, two more pillows"), 204);
  const auto phone = [&](const char* words) {
    return value(Form::phone, words);
  };
  EXPECT_EQ(phone("nine one two three four five six seven, no, eight"),
            "91234568");
  EXPECT_EQ(phone("nine one two three four five six seven, no, one moment"),
            "91234567");
  EXPECT_EQ(phone("91234567, no one answered"), "91234567");
}

TEST(Forms, BeginWithAFirstWord) {
  for (const auto& line : table()) {
    if (line.expected.empty())
      continue;
    const auto tokens = tokenize(line.words);
    EXPECT_TRUE(forms_from(tokens.list[0].word) &
                forms_bit(*form_of(line.form)))
        << line.form << ": " << line.words;
  }
}

TEST(Forms, TellHowLongFromWhen) {
  const auto now = *parse_timestamp("2026-11-21 09:00");
  const auto weak = [&](const std::string& words) {
    return form_at(Form::date, tokenize(words), 1, now)->weak;
  };
  EXPECT_TRUE(weak("for three days from monday"));
  EXPECT_FALSE(weak("for a week from monday"));
  EXPECT_FALSE(weak("for three days from now"));
  EXPECT_FALSE(weak("meet three days from monday"));
}

TEST(Forms, NeedANowForWhatIsRelative) {
  EXPECT_FALSE(form_at(Form::date, tokenize("tomorrow"), 0, {}));
  EXPECT_TRUE(form_at(Form::date, tokenize("2026-11-21"), 0, {}));
}

TEST(Forms, AreNamed) {
  EXPECT_EQ(form_of("level"), Form::level);
  EXPECT_EQ(name_of(Form::phone), "phone");
  EXPECT_FALSE(form_of("colour"));
}

} // namespace
} // namespace parlour::adapters::nlu
