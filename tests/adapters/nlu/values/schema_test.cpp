#include <gtest/gtest.h>

#include "adapters/nlu/values/schema.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

TEST(Schema, KnowsWhatKindOfValueASlotTakes) {
  UnderstandingModel model;
  model.topics = {{"T",
                   true,
                   {{"Words", "", {}, "", false, false},
                    {"Range", "range", {}, "", false, false},
                    {"Phone", "phone", {}, "", false, false},
                    {"Pattern", "pattern", {}, "", false, false},
                    {"Set", "set", {"a", "b"}, "", false, false},
                    {"Host", "query", {}, "db:staff.name", false, false}},
                   {}}};
  std::vector<Error> errors;
  const Schema schema(model, sample_column, errors);
  EXPECT_TRUE(errors.empty());
  const auto& topic = schema.at(0);
  EXPECT_TRUE(topic.enquiry);
  EXPECT_EQ(topic.find("Words")->entity, words_entity);
  EXPECT_EQ(topic.find("Range")->entity, static_cast<EntityId>(Form::number));
  EXPECT_EQ(topic.find("Phone")->entity, static_cast<EntityId>(Form::phone));
  EXPECT_EQ(topic.find("Pattern")->entity, words_entity);
  EXPECT_TRUE(is_set(topic.find("Set")->entity));
  EXPECT_TRUE(is_set(topic.find("Host")->entity));
  EXPECT_NE(topic.find("Set")->entity, topic.find("Host")->entity);
  EXPECT_EQ(topic.find("Colour"), nullptr);
}

class SchemaOfSample : public testing::Test {
protected:
  std::string error_of(const char* reference) {
    errors.clear();
    EXPECT_FALSE(schema.resolve(reference, {"f", 4, 2}, errors)) << reference;
    return errors.size() == 1 ? errors[0].message : "not one error";
  }

  std::vector<std::string> columns; // that were read
  std::vector<Error> errors;
  Schema schema{sample_model(),
                [this](const std::string& name) {
                  columns.push_back(name);
                  return sample_column(name);
                },
                errors};
};

TEST_F(SchemaOfSample, FindsTopicsAndSlots) {
  EXPECT_EQ(schema.topic("Facility"), 1U);
  EXPECT_EQ(schema.topic("Weather"), no_topic);
  EXPECT_EQ(schema.topics_with("Time"), (std::vector<TopicNumber>{0, 2}));
  EXPECT_TRUE(schema.topics_with("Colour").empty());
  EXPECT_EQ(schema.topic_names(),
            (std::vector<std::string>{"Appointment", "Facility", "Taxi"}));
  EXPECT_EQ(schema.slot_names(1),
            (std::vector<std::string>{"Name", "Category", "Location"}));
  EXPECT_EQ(schema.slot_names(no_topic).size(), 11U);
}

TEST_F(SchemaOfSample, ResolvesReferences) {
  const auto slot = schema.resolve("Facility.Location", {}, errors);
  EXPECT_EQ(slot->entity, static_cast<EntityId>(Form::level));
  EXPECT_EQ(slot->topic, 1U);
  EXPECT_EQ(slot->slot, "Location");
  const auto form = schema.resolve("date", {}, errors);
  EXPECT_EQ(form->entity, static_cast<EntityId>(Form::date));
  EXPECT_EQ(form->topic, no_topic);
  EXPECT_EQ(schema.resolve("words", {}, errors)->entity, words_entity);
  EXPECT_EQ(schema.resolve("asked", {}, errors)->entity, asked_entity);
}

TEST_F(SchemaOfSample, ReadsAColumnOnce) {
  const auto host = schema.at(0).find("Host")->entity;
  EXPECT_EQ(schema.resolve("db:staff.name", {}, errors)->entity, host);
  EXPECT_EQ(columns,
            (std::vector<std::string>{"db:staff.name", "db:facility.name"}));
}

TEST_F(SchemaOfSample, SaysWhatIsNotThere) {
  EXPECT_NE(error_of("Taxis.Time").find("did you mean 'Taxi'?"),
            std::string::npos);
  EXPECT_NE(error_of("Taxi.Tim").find("did you mean 'Time'?"),
            std::string::npos);
  EXPECT_NE(error_of("tyme").find("did you mean 'time'?"), std::string::npos);
}

TEST_F(SchemaOfSample, AColumnThatCannotBeReadIsAnErrorAndEmpty) {
  const auto made = schema.resolve("db:no.where", {"f", 4, 2}, errors);
  ASSERT_TRUE(made);
  EXPECT_TRUE(is_set(made->entity));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].message, "@db:no.where: no such column");
  EXPECT_EQ(errors[0].place.line, 4U);
}

TEST(SchemaOfNumbers, KnowsWhatIsTooSmall) {
  const auto fewest = [](std::int64_t least, std::int64_t most) {
    UnderstandingModel model;
    SlotModel slot{"Card", "range", {}, "", true};
    slot.least = least;
    slot.most = most;
    model.topics = {{"Loan", false, {slot}, {}}};
    std::vector<Error> errors;
    return Schema(model, {}, errors).at(0).find("Card")->fewest;
  };
  EXPECT_EQ(fewest(10'000, 99'999), 1000);
  EXPECT_EQ(fewest(100, 400), 10);
  EXPECT_EQ(fewest(5, 30), 0);
  EXPECT_EQ(fewest(5, 300), 0);
  EXPECT_EQ(fewest(0, 0), 0);
}

TEST(SchemaOfNumbers, KnowsItOfAColumn) {
  UnderstandingModel model;
  model.topics = {{"Stay",
                   false,
                   {{"Room", "query", {}, "db:room.number", true},
                    {"Place", "query", {}, "db:place.name", true}},
                   {}}};
  std::vector<Error> errors;
  const auto read = [](const std::string& column) {
    return Expected<std::vector<std::string>>(
        column == "db:room.number" ? std::vector<std::string>{"101", "412"}
                                   : std::vector<std::string>{"101", "bar"});
  };
  const Schema schema(model, read, errors);
  EXPECT_EQ(schema.at(0).find("Room")->fewest, 10);
  EXPECT_EQ(schema.at(0).find("Place")->fewest, 0);
}

} // namespace
} // namespace parlour::adapters::nlu::test
