#include "actors/components/supervisor.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

// What the actor does is tested as supervision; here: that it is asked.
TEST(Supervisor, AnswersWhatIsWished) {
  Bench bench;
  bench.services.centre = bench.centre_probe();
  bench.services.supervisor = bench.spawn(supervisor, &bench.services);
  std::vector<std::string> outcomes;
  Done note = [&](Expected<void> outcome) {
    outcomes.push_back(outcome ? "done" : outcome.error().message);
  };
  bench.send(bench.services.supervisor,
             load_plugin{"Voice", "", note, bench.work()});
  bench.send(bench.services.supervisor,
             unload_component{"Voice", note, bench.work()});
  EXPECT_THAT(outcomes, ElementsAre("this run has no plug-ins to load",
                                    "there is no component 'Voice'"));
}

} // namespace
} // namespace parlour::actors
