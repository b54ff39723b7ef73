// The receptionist's conversation of the paper's Table I, while components
// throw, hang, flood, die and are replaced: its outcome is still right.
#include <map>
#include <stdexcept>

#include "actors/node/node.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

enum class Misdeed { none, throws, hangs, floods, dies, is_replaced };

// What goes wrong: which fault a component has at its n-th message.
struct Trouble {
  std::string component;
  Misdeed misdeed = Misdeed::none;
  int message = 1;
  int seen = 0;
  actors::Node* node = nullptr;
};

// A real plug-in until its fault is due.
class Misbehaving : public IPlugin {
public:
  Misbehaving(std::unique_ptr<IPlugin> inner, std::string name,
              std::shared_ptr<Trouble> trouble)
      : inner_(std::move(inner)), name_(std::move(name)),
        trouble_(std::move(trouble)) {}
  void stop() override {
    inner_->stop();
  }

protected:
  Expected<void> on_start(const Options& options) override {
    return inner_->start(host(), options);
  }
  void on_message(const Message& message) override {
    if (++trouble_->seen != trouble_->message || strike())
      inner_->receive(message);
  }

private:
  // Whether it answers all the same, although too late or to nobody.
  bool strike() {
    switch (trouble_->misdeed) {
    case Misdeed::throws:
      throw std::runtime_error("broken");
    case Misdeed::hangs:
      trouble_->node->advance(5s);
      trouble_->node->run_until_quiet();
      break;
    case Misdeed::floods:
      for (int i = 0; i < 10'000; ++i)
        host().fire_event(noise());
      break;
    case Misdeed::dies:
      host().failed("gone");
      return false;
    case Misdeed::is_replaced:
      replace();
      break;
    case Misdeed::none:
      break;
    }
    return true;
  }

  void replace() {
    const auto replaced = trouble_->node->load(name_, name_);
    EXPECT_TRUE(replaced) << to_string(replaced.error());
  }

  static Message noise() {
    Message message;
    message.command = "Noise";
    return message;
  }

  std::unique_ptr<IPlugin> inner_;
  std::string name_;
  std::shared_ptr<Trouble> trouble_;
};

class RealPlugins : public PluginCatalogue {
public:
  explicit RealPlugins(const Composition& composition) {
    for (const auto& component : composition.components)
      factories_[component.factory.description.name] = component.factory;
  }
  Expected<PluginFactory> find(const std::string& name) override {
    return factories_.at(name);
  }
  std::vector<PluginDescription> all() override {
    return {};
  }

private:
  std::map<std::string, PluginFactory> factories_;
};

const Application& receptionist() {
  static const auto application =
      load_application(test::source_path("config/apps/receptionist"),
                       test::source_path("config/platform"));
  return application;
}

bool has_part(const std::string& component) {
  return component == "GrammarNLU" || component == "PhraseNLG" ||
         component == "SQLiteDatabase" || component == "LogTelephone";
}

// The visitor of Table I, who answers questions and repeats what was not
// understood.
class Visit {
public:
  explicit Visit(const Trouble& trouble)
      : trouble_(std::make_shared<Trouble>(trouble)) {
    auto options = node_options(receptionist(), receptionist().composition,
                                {data_.path().string(), default_start(), 1});
    for (auto& component : options.components) {
      component.policy.deadline = 5s;
      if (component.name == trouble_->component)
        component.factory.create = [this, name = component.name,
                                    create = component.factory.create] {
          return std::make_unique<Misbehaving>(create(), name, trouble_);
        };
    }
    options.plugins = std::make_shared<RealPlugins>(receptionist().composition);
    options.on_inspection = [this](const Inspection& seen) { watch(seen); };
    auto node = actors::Node::start(std::move(options));
    EXPECT_TRUE(node) << to_string(node.error());
    node_ = std::move(*node);
    trouble_->node = node_.get();
    seat_ = node_->open_seat(
        {[this](const SessionId&, const dialogue::Output& output) {
           said.push_back(output.text);
         },
         {}});
  }

  // False if the host was not announced within a dozen turns.
  bool hold() {
    node_->open(seat_);
    say({plan_[0], plan_[1]});
    poke();
    for (int turn = 0; turn < 12 && !announced(); ++turn)
      say({reply(listen())});
    listen();
    return announced();
  }

  bool struck() const {
    return trouble_->seen >= trouble_->message;
  }

  std::vector<std::string> said;
  std::vector<std::string> calls;  // of the telephone
  std::vector<std::string> system; // events of components

private:
  void watch(const Inspection& seen) {
    if (seen.kind != InspectionKind::message)
      return;
    if (seen.message->command == "Call")
      calls.push_back(to_string(*seen.message));
    if (seen.message->source == "System")
      system.push_back(seen.message->command);
  }

  void say(const std::vector<std::string>& lines) {
    node_->enter(seat_, lines);
    node_->run_until_quiet();
  }

  // Components without a part in the conversation get a message, too.
  void poke() {
    Message message;
    message.source = "Script";
    message.command = "Poke";
    message.sinks = {trouble_->component};
    if (!has_part(trouble_->component))
      node_->inject("", std::move(message));
    node_->run_until_quiet();
  }

  // The robot's words up to its next question or a silence.
  std::string listen() {
    while (heard_ == said.size() && node_->step_to_next_due(20s)) {
    }
    std::string words;
    while (heard_ < said.size())
      words += said[heard_++] + ' ';
    return words;
  }

  std::string reply(const std::string& words) {
    if (words.find("your name") != std::string::npos)
      return "My name is David.";
    if (words.find("Whom") != std::string::npos)
      return "Dr. Jeffery Ho";
    if (words.find("time of your") != std::string::npos && next_ > 2)
      return "10:30am.";
    return next_ < plan_.size() ? plan_[next_++] : plan_[0];
  }

  bool announced() const {
    for (const auto& words : said)
      if (words.find("I will call Dr. Jeffery Ho.") != std::string::npos)
        return true;
    return false;
  }

  const std::vector<std::string> plan_ = {
      "I am David from Comptec to meet Dr. Jeffery Ho.",
      "By the way, is there any coffee shop on this second floor?",
      "How about food court?", "10:30am."};
  std::size_t next_ = 2;
  std::size_t heard_ = 0;
  std::shared_ptr<Trouble> trouble_;
  DataFolder data_ = std::move(*DataFolder::temporary());
  std::unique_ptr<actors::Node> node_;
  actors::SeatId seat_;
};

class TableOne : public testing::TestWithParam<const char*> {};

TEST_P(TableOne, EndsRightWhateverAComponentDoes) {
  Visit calm({"", Misdeed::none});
  ASSERT_TRUE(calm.hold()) << testing::PrintToString(calm.said);
  using enum Misdeed;
  for (const auto misdeed : {throws, hangs, floods, dies, is_replaced})
    for (const int message : {1, 3}) {
      Visit visit({GetParam(), misdeed, message});
      SCOPED_TRACE(std::to_string(static_cast<int>(misdeed)) + " at message " +
                   std::to_string(message));
      EXPECT_TRUE(visit.hold()) << testing::PrintToString(visit.said);
      EXPECT_THAT(visit.calls, Contains(HasSubstr("Jeffery Ho")));
      EXPECT_TRUE(visit.struck() || message > 1);
      if (!visit.struck())
        break;
      EXPECT_THAT(visit.system, Contains("ComponentUp"));
      if (misdeed != is_replaced) {
        EXPECT_THAT(visit.system, Contains("ComponentFailed"));
      } else if (has_part(GetParam())) { // the words are the same
        EXPECT_EQ(visit.said, calm.said);
      }
      EXPECT_THAT(visit.system, Not(Contains("ComponentDown")));
    }
}

std::string own_name(const testing::TestParamInfo<const char*>& which) {
  return which.param;
}

INSTANTIATE_TEST_SUITE_P(Each, TableOne,
                         testing::Values("GrammarNLU", "PhraseNLG",
                                         "SQLiteDatabase", "LogTelephone",
                                         "LogTaxi", "LogSMS", "LogWeather",
                                         "LogTraffic"),
                         own_name);

} // namespace
} // namespace parlour::tools
