#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"
#include "tools/parlour/talk/text_run.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class OneRead : public ByteSource {
public:
  explicit OneRead(Read first) : first_(std::move(first)) {}
  Read read(std::optional<Milliseconds>) override {
    return std::exchange(first_, Read{});
  }

private:
  Read first_;
};

class NotingDriver : public ConversationDriver {
public:
  explicit NotingDriver(bool is_virtual) : virtual_(is_virtual) {}
  void enter(const std::vector<std::string>& turns) override {
    calls.push_back("enter " + std::to_string(turns.size()));
  }
  void run_until_quiet() override {
    calls.emplace_back("quiet");
  }
  void let_time_pass() override {
    calls.emplace_back("step");
  }
  bool is_virtual() const override {
    return virtual_;
  }
  std::vector<std::string> calls;

private:
  bool virtual_;
};

std::vector<std::string> calls_for(Read read, bool is_virtual, bool ended) {
  OneRead source(std::move(read));
  RowReader rows(source, [](const std::string&) {});
  NotingDriver driver(is_virtual);
  EXPECT_EQ(talk_by_rows(driver, rows), ended);
  return driver.calls;
}

TEST(TalkByRows, lets_virtual_time_stand_still_but_for_empty_lines) {
  EXPECT_THAT(calls_for({Read::Kind::bytes, "a\nb\n\n\nc"}, true, true),
              ElementsAre("enter 2", "quiet", "quiet", "step", "enter 1",
                          "quiet", "quiet"));
}

TEST(TalkByRows, goes_on_reading_in_real_time) {
  EXPECT_THAT(calls_for({Read::Kind::bytes, "a\n"}, false, true),
              ElementsAre("enter 1", "quiet"));
}

TEST(TalkByRows, reads_on_after_a_part_when_all_is_quiet) {
  std::string many;
  for (std::size_t i = 0; i < longest_row; ++i)
    many += "y\n";
  EXPECT_THAT(calls_for({Read::Kind::bytes, many + "z\n"}, false, true),
              ElementsAre("enter 1000", "quiet", "enter 1", "quiet"));
}

TEST(TalkByRows, ends_when_interrupted) {
  EXPECT_THAT(calls_for({Read::Kind::interrupted, {}}, false, false),
              ElementsAre());
}

// A component that fires a hundred ticks a second, and a strike after a second.
class Metronome : public IPlugin {
public:
  void stop() override {}

protected:
  Expected<void> on_start(const Options&) override {
    tick(0);
    return {};
  }
  void on_message(const Message&) override {}

private:
  void tick(int count) {
    fire_event(count == 100 ? "Strikes" : "Ticks", {});
    host().after(10ms, [this, count] { tick(count + 1); });
  }
};

class NodePartnerTest : public ApplicationTest {
protected:
  void talk(const std::string& dialogue) {
    application_ = load("<Plugins/>", dialogue);
    ASSERT_TRUE(application_.program) << findings(application_);
    auto options = node_options(application_, application_.composition,
                                {"", default_start(), 1});
    PluginFactory metronome;
    metronome.description.name = "Metronome";
    metronome.create = [] { return std::make_unique<Metronome>(); };
    options.components.push_back({"Metronome", metronome, {}, {}});
    auto node = actors::Node::start(std::move(options));
    ASSERT_TRUE(node) << to_string(node.error());
    node_ = std::move(*node);
    driver_.emplace(*node_, true,
                    [this](const std::string& text) { said_.push_back(text); });
  }
  // Returns how much time has passed.
  Milliseconds let_time_pass() {
    const auto before = node_->now();
    driver_->let_time_pass();
    return Milliseconds(node_->now() - before);
  }
  ~NodePartnerTest() override {
    node_->stop();
  }

  std::vector<std::string> said_;

private:
  Application application_;
  std::unique_ptr<actors::Node> node_;
  std::optional<NodeDriver> driver_;
};

constexpr const char* timers = R"(<handler name="Begin"><messages><component>
  <Session><Started>
  <speak param="Hello."/>
  <timer name="one" after="3s"><speak param="Three."/></timer>
  <timer name="two" after="5s"><print param="unheard"/></timer>
  </Started></Session></component></messages></handler>)";

TEST_F(NodePartnerTest, goes_from_timer_to_timer_whatever_components_do) {
  ASSERT_NO_FATAL_FAILURE(talk(timers));
  EXPECT_THAT(said_, ElementsAre("Hello."));
  EXPECT_EQ(let_time_pass(), 3s);
  EXPECT_THAT(said_, ElementsAre("Hello.", "Three."));
  EXPECT_EQ(let_time_pass(), 2s);
}

TEST_F(NodePartnerTest, stops_where_something_is_said) {
  ASSERT_NO_FATAL_FAILURE(talk(std::string(timers) + R"(<handler name="Ear">
      <messages><component>
      <Session><Started><subscribe source="Metronome"/></Started></Session>
      <Metronome>
        <Strikes><speak param="Dong."/></Strikes>
      </Metronome></component></messages></handler>)"));
  EXPECT_EQ(let_time_pass(), 1s);
  EXPECT_THAT(said_, ElementsAre("Hello.", "Dong."));
  EXPECT_EQ(let_time_pass(), 2s);
}

TEST_F(NodePartnerTest, goes_on_for_a_minute_where_only_components_do) {
  ASSERT_NO_FATAL_FAILURE(talk(R"(<handler name="Ear"><messages><component>
      <Metronome><Strikes><print param="unheard"/></Strikes></Metronome>
      </component></messages></handler>)"));
  EXPECT_EQ(let_time_pass(), longest_pause);
}

} // namespace
} // namespace parlour::tools
