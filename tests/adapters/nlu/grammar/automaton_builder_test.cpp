#include <gtest/gtest.h>

#include "adapters/nlu/grammar/automaton_builder.hpp"

namespace parlour::adapters::nlu {
namespace {

std::vector<Error> errors_of(const std::string& text) {
  UnderstandingModel model;
  model.topics = {
      {"Facility", true, {{"Name", "", {}, "", false, false}}, {}},
      {"Taxi", false, {{"Phone", "phone", {}, "", false, false}}, {}}};
  std::vector<Error> errors;
  Schema schema(model, {}, errors);
  AutomatonBuilder builder(schema, errors);
  builder.add(jsgf::parse({"g", text, {}}, errors), {});
  builder.finish();
  return errors;
}

std::string first_error(const std::string& text) {
  const auto errors = errors_of(text);
  return errors.empty() ? "" : errors[0].message;
}

TEST(AutomatonBuilder, TakesWhatIsWellFormed) {
  EXPECT_EQ(first_error("public <a> = [b] c* (d | <e>)+ {act=inform};"
                        "<e> = at @phone {Phone} | <NULL> | x <VOID>;"),
            "");
}

TEST(AutomatonBuilder, KnowsItsNames) {
  EXPECT_EQ(first_error("public <a> = <place>; <plaze> = b;"),
            "there is no rule <place>, did you mean 'plaze'?");
  EXPECT_EQ(first_error("public <a> = b {act=informs};"),
            "there is no act 'informs', did you mean 'inform'?");
  EXPECT_EQ(first_error("public <a> = b {act};"),
            "the tag {act} needs a value: {act=…}");
  EXPECT_EQ(first_error("public <a> = b {denies=last};"),
            "what can be denied is the next words: {denies=next}");
  EXPECT_EQ(first_error("public <a> = b {topic=Taxis};"),
            "there is no topic 'Taxis', did you mean 'Taxi'?");
  EXPECT_EQ(first_error("public <a> = @phon;"),
            "there is no value @phon, did you mean 'phone'?");
  EXPECT_EQ(first_error("public <a> = @Facility.Nam;"),
            "the topic 'Facility' has no slot 'Nam', did you mean 'Name'?");
  EXPECT_EQ(first_error("public <a> = b {Phone} {topic=Facility};"),
            "the topic 'Facility' has no slot 'Phone'");
  EXPECT_EQ(first_error("<a> = b;"), "the grammar 'g' has no public rule, so "
                                     "nothing of it is ever tried");
}

TEST(AutomatonBuilder, RefusesARuleInsideItself) {
  EXPECT_EQ(first_error("public <a> = b <c>; <c> = d [<a>];"),
            "the rule <a> refers to itself; use * or + to repeat");
}

// Each rule is ten of the one before: a million words.
TEST(AutomatonBuilder, RefusesWhatGrowsTooLarge) {
  std::string text = "<r0> = word;";
  for (int at = 1; at <= 6; ++at) {
    const auto inner = "<r" + std::to_string(at - 1) + "> ";
    text += (at == 6 ? "public <r" : "<r") + std::to_string(at) + "> = ";
    for (int copy = 0; copy < 10; ++copy)
      text += inner;
    text += ";";
  }
  EXPECT_EQ(first_error(text).substr(0, 35),
            "the grammars are too large together");
}

} // namespace
} // namespace parlour::adapters::nlu
