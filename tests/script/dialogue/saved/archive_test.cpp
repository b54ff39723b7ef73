#include "script/dialogue/acts/acts.hpp"
#include "script/dialogue/saved/archive.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

enum class Colour : std::uint8_t { red, green };

// One field of each kind.
struct Part {
  bool flag = false;
  std::uint64_t number = 0;
  std::int64_t time = 0;
  int count = 0;
  Milliseconds length{0};
  std::string text;
  Value value;
  Colour colour = Colour::red;
  script::TopicId topic = script::no_id;
  script::SlotId slot = script::no_id;
  script::StateId state = script::no_id;
  std::vector<std::string> list;
  std::map<std::string, std::uint64_t> map;
  std::set<std::uint64_t> set;
  std::optional<Error> error;
  std::optional<Expected<Value>> outcome;
  Random random{0};
  std::pair<std::uint64_t, Subscription> pair;
  ActPointer first, second, none;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(flag, number, time, count, length, text, value);
    archive.up_to(colour, Colour::green);
    archive.slot(topic, slot);
    archive.state(state);
    archive(list, map, set, error, outcome, random, pair, first, second, none);
  }
};

Part full() {
  Part part;
  part.flag = true;
  part.number = ~std::uint64_t{0};
  part.time = -5;
  part.count = -7;
  part.length = Milliseconds(1500);
  part.text = "café";
  part.value = Map{{"a", List{1, "b"}}};
  part.colour = Colour::green;
  part.topic = 0;
  part.slot = 1;
  part.state = 0;
  part.list = {"x", ""};
  part.map = {{"k", 1}, {"l", 2}};
  part.set = {3, 4};
  part.error = Error{ErrorKind::settings, "no", {"f.xml", 2, 3}};
  part.outcome = fail(ErrorKind::timeout, "late");
  part.random = Random(99);
  part.pair = {5, {"VAD", "*"}};
  Act act;
  act.kind = ActKind::refuse;
  act.slots.resize(1);
  act.alternatives.resize(1);
  part.first = part.second = std::make_shared<const Act>(act);
  return part;
}

TEST(Archive, EveryKindOfFieldComesBack) {
  const auto part = full();
  const auto again = round_trip(part);
  EXPECT_EQ(again.number, part.number);
  EXPECT_EQ(again.time, -5);
  EXPECT_EQ(again.count, -7);
  EXPECT_EQ(again.length, part.length);
  EXPECT_EQ(again.text, part.text);
  EXPECT_EQ(again.value, part.value);
  EXPECT_EQ(again.colour, part.colour);
  EXPECT_EQ(again.slot, 1u);
  EXPECT_EQ(again.list, part.list);
  EXPECT_EQ(again.map, part.map);
  EXPECT_EQ(again.set, part.set);
  EXPECT_EQ(again.error, part.error);
  EXPECT_EQ(again.outcome, part.outcome);
  EXPECT_EQ(again.random.state(), part.random.state());
  EXPECT_EQ(again.pair, part.pair);
}

TEST(Archive, WhatIsSharedStaysShared) {
  const auto again = round_trip(full());
  ASSERT_TRUE(again.first);
  EXPECT_EQ(again.first, again.second);
  EXPECT_EQ(again.first->kind, ActKind::refuse);
  EXPECT_EQ(again.none, nullptr);
}

TEST(Archive, DefaultsComeBack) {
  const auto again = round_trip(Part());
  EXPECT_EQ(again.topic, script::no_id);
  EXPECT_FALSE(again.error);
}

TEST(Archive, EqualPartsHaveEqualBytes) {
  const auto program = small_program();
  EXPECT_EQ(bytes_of(program, full()), bytes_of(program, full()));
}

// Ids, enumerations and numbers are held against what there is.
TEST(Archive, WhatIsNotThereIsRefused) {
  const auto refuses = [](auto change, const char* why) {
    auto part = full();
    change(part);
    const auto program = small_program();
    Part again;
    const auto done = read(program, again, bytes_of(program, part));
    ASSERT_FALSE(done) << why;
    EXPECT_EQ(done.error().kind, ErrorKind::file);
    EXPECT_NE(done.error().message.find(why), std::string::npos)
        << done.error().message;
  };
  refuses([](Part& part) { part.topic = 1; }, "no such topic");
  refuses([](Part& part) { part.slot = 2; }, "no such slot");
  refuses([](Part& part) { part.state = 7; }, "no such state");
  refuses([](Part& part) { part.colour = Colour(2); }, "choice 2");
  refuses([](Part& part) { part.time = std::int64_t{1} << 60; }, "too large");
  refuses([](Part& part) { part.count = 2'000'000'000; }, "too large");
}

struct Nested {
  std::vector<Nested> inner;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(inner);
  }
};

TEST(Archive, WhatIsNestedTooDeeplyIsRefused) {
  const auto program = small_program();
  const auto empty = bytes_of(program, Nested());
  // Each level has one element: a byte 1 instead of the 0.
  const auto bytes =
      empty.substr(0, empty.size() - 1) + std::string(100'000, '\1') + '\0';
  Nested nested;
  const auto done = read(program, nested, bytes);
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("too deeply"), std::string::npos);
}

} // namespace
} // namespace parlour::dialogue
