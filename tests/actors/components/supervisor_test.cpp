#include <caf/scoped_actor.hpp>

#include "actors/components/supervisor.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

// What the actor does is tested as supervision; here: that it is asked.
TEST(Supervisor, AnswersWhatIsRequested) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  InstanceDirectory instances;
  SharedEnvironment environment;
  const auto actor = bench.spawn(
      supervisor, SupervisionParts{bench.time, bench.bus, bench.observer,
                                   bench.sessions, instances, environment});
  std::vector<std::string> outcomes;
  caf::scoped_actor self(*bench.system);
  auto ask = [&](auto what) {
    auto answer = self->request(actor, caf::infinite, std::move(what));
    bench.run();
    answer.receive(
        [&](const component_done& done) {
          outcomes.push_back(done.outcome ? "done"
                                          : done.outcome.error().message);
        },
        [](const caf::error&) { FAIL() << "not answered"; });
  };
  ask(load_plugin{"Voice", "", bench.work()});
  ask(unload_component{"Voice", bench.work()});
  EXPECT_THAT(outcomes, ElementsAre("this run has no plug-ins to load",
                                    "there is no component 'Voice'"));
}

} // namespace
} // namespace parlour::actors
