#include "actors/components/supervisor.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

// What the actor does is tested as supervision; here: that it is asked.
TEST(Supervisor, AnswersWhatIsWished) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  InstanceDirectory instances;
  const PluginEnvironment environment;
  const auto actor = bench.spawn(
      supervisor, SupervisionParts{bench.time, bench.bus, bench.observer,
                                   bench.sessions, instances, environment});
  std::vector<std::string> outcomes;
  Done note = [&](Expected<void> outcome) {
    outcomes.push_back(outcome ? "done" : outcome.error().message);
  };
  bench.send(actor, load_plugin{"Voice", "", note, bench.work()});
  bench.send(actor, unload_component{"Voice", note, bench.work()});
  EXPECT_THAT(outcomes, ElementsAre("this run has no plug-ins to load",
                                    "there is no component 'Voice'"));
}

} // namespace
} // namespace parlour::actors
