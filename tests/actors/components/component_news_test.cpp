#include "actors/components/component_news.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class ComponentNewsTest : public testing::Test {
protected:
  ComponentNewsTest() {
    bench.bus.connect(bench.centre_probe());
    service.component = std::make_shared<Component>();
    service.component->order.name = "City";
    service.component->mailbox = std::make_shared<ComponentMailbox>();
    service.scope = std::make_shared<InstanceScope>();
  }

  static Message question(Correlation correlation) {
    auto message = event("Session", "Book");
    message.correlation = correlation;
    return message;
  }

  Bench bench;
  InstanceDirectory instances;
  SharedEnvironment environment;
  const SupervisionParts parts{bench.time,     bench.bus, bench.observer,
                               bench.sessions, instances, environment};
  ComponentNews news{parts};
  Service service;
};

TEST_F(ComponentNewsTest, AnswersThoseThatWait) {
  news.answer_by_failure(service, {question(0), question(7)}, "it broke");
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("City.Failed(it broke)"));
}

TEST_F(ComponentNewsTest, AnswersNobodyWhoseSessionIsOver) {
  service.over = true;
  news.answer_by_failure(service, {question(7)}, "it broke");
  bench.run();
  EXPECT_THAT(bench.seen, IsEmpty());
}

TEST_F(ComponentNewsTest, AnswersNobodyWhenTheNodeStops) {
  news.stop_answering();
  news.answer_by_failure(service, {question(7)}, "it broke");
  bench.run();
  EXPECT_THAT(bench.seen, IsEmpty());
}

TEST_F(ComponentNewsTest, AnswersWhatWaitsInTheMailbox) {
  ComponentMailbox::Job job{std::make_shared<const Message>(question(7)), {}};
  service.component->mailbox->put(job);
  news.answer_what_waits(service, "it was unloaded");
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("City.Failed(it was unloaded)"));
  EXPECT_TRUE(service.component->mailbox->empty());
}

TEST_F(ComponentNewsTest, TellsTheWholeNodeOfWhatIsNobodysOwn) {
  news.tell("ComponentDown", {"City", "unloaded"});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("System.ComponentDown(City, unloaded)"));
}

} // namespace
} // namespace parlour::actors
