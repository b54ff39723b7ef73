#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/conformance.hpp"

namespace parlour {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A taxi office that does what a test says.
struct Ways {
  bool starts = true;
  bool answers = true;
  bool answers_strangers = true;
  bool refuses_nothing = true; // without parameters it says no
  bool keeps_session = true;
  bool throws = false;
  std::string event = "Booked";
};

class Office : public IPlugin {
public:
  explicit Office(Ways ways) : ways_(std::move(ways)) {}

protected:
  Expected<void> on_start(const Options&) override {
    if (!ways_.starts)
      return fail(ErrorKind::settings, "the line is dead");
    return {};
  }
  void on_message(const Message& message) override {
    if (ways_.throws)
      throw std::runtime_error("no fuel");
    auto to = message;
    if (!ways_.keeps_session)
      to.session.clear();
    if (message.command != "Book") {
      if (ways_.answers_strangers)
        answer(to, "Refused", {"what?"});
    } else if (message.params.empty() && ways_.refuses_nothing) {
      answer(to, "Refused", {"from where?"});
    } else if (ways_.answers) {
      host().after(Milliseconds(1'900), [this, to] {
        answer(to, ways_.event, {"SHA 1234", 5});
      });
    }
  }

private:
  Ways ways_;
};

std::vector<std::string> wrong_with(const Ways& ways,
                                    Milliseconds deadline = Milliseconds(2'000),
                                    Milliseconds warm_up = Milliseconds(0)) {
  PluginFactory factory;
  factory.description.name = "Office";
  factory.description.roles = {"Taxi"};
  factory.description.sentence = "sends a taxi";
  factory.create = [ways] { return std::make_unique<Office>(ways); };
  TestOptions terms;
  // What is due comes without waiting; only silence is waited for.
  terms.deadline = deadline;
  terms.warm_up = warm_up;
  return conformance_errors(factory, terms);
}

TEST(Conformance, FindsNothingInAGoodPlugin) {
  EXPECT_THAT(wrong_with({}), IsEmpty());
}

TEST(Conformance, WantsItToStart) {
  EXPECT_THAT(wrong_with({.starts = false}),
              ElementsAre("it does not start: the line is dead"));
}

TEST(Conformance, WantsAnswersInTime) {
  EXPECT_THAT(wrong_with({.answers = false}),
              ElementsAre(HasSubstr("is not answered in time by Booked, "
                                    "Refused")));
}

// Its answer takes 1.9 s.
TEST(Conformance, LetsItWarmUp) {
  EXPECT_THAT(wrong_with({}, Milliseconds(1'000), Milliseconds(60'000)),
              IsEmpty());
  EXPECT_THAT(wrong_with({}, Milliseconds(1'000)),
              ElementsAre(HasSubstr("is not answered in time by Booked")));
}

TEST(Conformance, WantsWhatLacksParametersRefused) {
  EXPECT_THAT(wrong_with({.refuses_nothing = false}),
              ElementsAre("Book without its parameters is answered by Booked "
                          "instead of Refused"));
}

TEST(Conformance, WantsUnknownCommandsRefused) {
  EXPECT_THAT(wrong_with({.answers_strangers = false}),
              ElementsAre(HasSubstr("a command that it does not know is not "
                                    "refused")));
}

TEST(Conformance, WantsTheSessionInTheAnswer) {
  EXPECT_THAT(wrong_with({.keeps_session = false}),
              Contains("Book is answered by Booked without the session of the "
                       "message"));
}

TEST(Conformance, WantsNothingThrown) {
  EXPECT_THAT(wrong_with({.throws = true}),
              Contains("Book: it throws 'no fuel'"));
}

TEST(Conformance, WantsEventsThatAreDescribed) {
  EXPECT_THAT(wrong_with({.event = "Ordered"}),
              Contains("it fires Ordered, which neither its roles nor its "
                       "description know"));
}

TEST(Conformance, WantsInlineOnesToBeInline) {
  PluginFactory factory;
  factory.description = {"Office", {"Taxi"}, "sends a taxi"};
  factory.description.is_inline = true;
  factory.create = [] { return std::make_unique<Office>(Ways{}); };
  EXPECT_THAT(conformance_errors(factory, {}),
              ElementsAre(HasSubstr("described as inline")));
}

TEST(Conformance, WantsAPluginToBeMade) {
  PluginFactory factory;
  factory.description = {"Office", {"Taxi"}, "sends a taxi"};
  factory.create = [] { return nullptr; };
  EXPECT_THAT(conformance_errors(factory, {}),
              ElementsAre("its factory makes nothing"));
}

} // namespace
} // namespace parlour
