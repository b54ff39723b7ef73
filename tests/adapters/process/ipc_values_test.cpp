#include <gtest/gtest.h>

#include "adapters/process/ipc_values.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

TEST(IpcValues, AreMessages) {
  auto message = test::message("Book", {"home", Value(), Map{{"a", 1}}});
  message.time = 5;
  message.number = 6;
  message.sinks = {"Taxi", "SMS"};
  EXPECT_EQ(message_from(to_value(message)).value(), message);
  EXPECT_FALSE(message_from({}));
  EXPECT_FALSE(message_from(List{1, 2, "source", "command"}));
  EXPECT_FALSE(message_from(List{1, 2, "source", 3, List{}, List{}}));
}

TEST(IpcValues, AreErrors) {
  const Error error{ErrorKind::database, "no file", {"a.db", 3, 4}};
  EXPECT_EQ(error_from(to_value(error)), error);
  EXPECT_EQ(error_from("text").kind, ErrorKind::network);
}

TEST(IpcValues, AreRenderedPhrases) {
  const Rendering rendering{"hello", {{ErrorKind::type, "no", {"a.xml", 3}}}};
  const auto read = rendering_from(to_value(rendering));
  EXPECT_EQ(read.words, rendering.words);
  EXPECT_EQ(read.failures, rendering.failures);
  EXPECT_EQ(rendering_from(to_value(Rendering{})).words, std::nullopt);
  EXPECT_EQ(rendering_from(7).words, std::nullopt);
}

TEST(IpcValues, AreOptionsAndTexts) {
  const Options options{{"file", "a.db"}, {"seed", ""}};
  EXPECT_EQ(options_from(to_value(options)).value(), options);
  EXPECT_FALSE(options_from(7));
  const std::vector<std::string> texts{"one", ""};
  EXPECT_EQ(texts_from(to_value(texts)).value(), texts);
  EXPECT_FALSE(texts_from("one"));
}

TEST(IpcValues, AreTheUnderstandingOfAnApplication) {
  const auto model =
      std::make_shared<const UnderstandingModel>(UnderstandingModel{
          {{"Visit",
            true,
            {{"Visitor", "set", {"David"}, "db:a.b", true, true},
             {"Time", "time", {}, "", false, false, true, 10, 99}},
            {"I am [David](Visitor)"}}},
          {{"greet", "public <a> = hi;", {"a.jsgf", 1, 2}}},
          {{"Ho", "HH OW"}}});
  const auto read = understanding_from(to_value(model)).value();
  ASSERT_EQ(read->topics.size(), 1u);
  const auto& topic = read->topics[0];
  EXPECT_EQ(topic.name, "Visit");
  EXPECT_TRUE(topic.enquiry);
  EXPECT_EQ(topic.examples, model->topics[0].examples);
  ASSERT_EQ(topic.slots.size(), 2u);
  EXPECT_EQ(topic.slots[0].values, model->topics[0].slots[0].values);
  EXPECT_EQ(topic.slots[0].source, "db:a.b");
  EXPECT_TRUE(topic.slots[0].functional);
  EXPECT_FALSE(topic.slots[1].relevant_to_query);
  EXPECT_EQ(topic.slots[1].type, "time");
  EXPECT_EQ(topic.slots[1], model->topics[0].slots[1]);
  ASSERT_EQ(read->grammars.size(), 1u);
  EXPECT_EQ(read->grammars[0].text, "public <a> = hi;");
  EXPECT_EQ(read->grammars[0].place, (SourceLocation{"a.jsgf", 1, 2}));
  ASSERT_EQ(read->pronunciations.size(), 1u);
  EXPECT_EQ(read->pronunciations[0].word, "Ho");
  EXPECT_EQ(read->pronunciations[0].phones, "HH OW");
  EXPECT_EQ(understanding_from({}).value(), nullptr);
  EXPECT_FALSE(understanding_from(7));
}

} // namespace
} // namespace parlour::adapters
